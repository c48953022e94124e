// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/handcraft_runtime.h"

#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "lib/features/pixel_scorer.h"
#include "lib/runtime/aligned_buffer.h"
#include "tests/lib/runtime/raw_model.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

struct Deleter {
  void operator()(hc_model* model) const { hc_model_free(model); }
  void operator()(hc_workspace* workspace) const { hc_workspace_free(workspace); }
};
using Model = std::unique_ptr<hc_model, Deleter>;
using Workspace = std::unique_ptr<hc_workspace, Deleter>;

Model Load(const Bytes& bytes) {
  hc_model* model = nullptr;
  hc_error error{};
  const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &model, &error);
  EXPECT_EQ(status, HC_OK) << error.message;
  EXPECT_EQ(error.status, status);
  return Model(model);
}

Model Load(const model_io::ModelFile& model) { return Load(model_io::Serialise(model)); }

Workspace MakeWorkspace(const Model& model, std::int32_t width, std::int32_t height) {
  hc_workspace* workspace = nullptr;
  EXPECT_EQ(hc_workspace_create(model.get(), width, height, &workspace), HC_OK);
  return Workspace(workspace);
}

hc_image View(const Image& picture) {
  return {picture.values().data(),
          picture.width(),
          picture.height(),
          std::int64_t{picture.width()} * picture.channels(),
          picture.channels() == 1 ? HC_GRAY8 : HC_BGR8};
}

void ExpectRefused(const Bytes& bytes, hc_status expected, const std::string& message) {
  auto* model = reinterpret_cast<hc_model*>(1);
  hc_error error{};
  EXPECT_EQ(hc_model_load_memory(bytes.data(), bytes.size(), &model, &error), expected)
      << error.message;
  EXPECT_EQ(model, nullptr);
  EXPECT_EQ(error.status, expected);
  EXPECT_THAT(std::string(error.message), HasSubstr(message));
}

void ExpectRefused(const model_io::ModelFile& model,
                   hc_status expected,
                   const std::string& message) {
  ExpectRefused(model_io::Serialise(model), expected, message);
}

TEST(LoadModel, TellsWhatItIs) {
  const Model grasp = Load(testing::SomeGraspPointModel("edges54"));
  EXPECT_EQ(hc_model_kind(grasp.get()), HC_KIND_GRASP_POINT);
  EXPECT_EQ(hc_model_num_features(grasp.get()), 54U);
  EXPECT_EQ(hc_model_needs_colour(grasp.get()), 0);
  EXPECT_STREQ(hc_model_metadata(grasp.get(), "hc.name"), "some_grasp_points");
  EXPECT_STREQ(hc_model_metadata(grasp.get(), "hc.training.seed"), "1");
  EXPECT_EQ(hc_model_metadata(grasp.get(), "hc.nothing"), nullptr);
  EXPECT_EQ(hc_model_metadata(grasp.get(), nullptr), nullptr);
  EXPECT_EQ(hc_model_needs_colour(Load(testing::SomeGraspPointModel("saxena459")).get()), 1);

  const Model logistic = Load(testing::SomeLogisticModel());
  EXPECT_EQ(hc_model_kind(logistic.get()), HC_KIND_LOGISTIC);
  EXPECT_EQ(hc_model_num_features(logistic.get()), 2U);
  EXPECT_EQ(hc_model_needs_colour(logistic.get()), 0);
}

TEST(LoadModel, ReadsAFile) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "m.safetensors", model_io::Serialise(testing::SomeLogisticModel()));
  hc_model* model = nullptr;
  hc_error error{};
  ASSERT_EQ(hc_model_load_file((folder / "m.safetensors").c_str(), &model, &error), HC_OK);
  EXPECT_STREQ(error.message, "");
  hc_model_free(model);
  ASSERT_EQ(hc_model_load_file((folder / "m.safetensors").c_str(), &model, nullptr), HC_OK);
  hc_model_free(model);
}

TEST(LoadModel, ReportsFilesItCannotRead) {
  const testing::TemporaryDirectory folder;
  hc_model* model = nullptr;
  hc_error error{};
  EXPECT_EQ(hc_model_load_file("missing", &model, &error), HC_ERROR_FILE);
  EXPECT_THAT(error.message, HasSubstr("No such file or directory: missing"));
  EXPECT_EQ(hc_model_load_file(folder.path().c_str(), &model, &error), HC_ERROR_FILE);
  EXPECT_THAT(error.message, HasSubstr("Is a directory"));
  WriteFileAtomically(folder / "empty", "");
  EXPECT_EQ(hc_model_load_file((folder / "empty").c_str(), &model, &error), HC_ERROR_TRUNCATED);
  EXPECT_THAT(error.message, HasSubstr("the file is empty"));
  EXPECT_EQ(model, nullptr);
}

TEST(LoadModel, RefusesKindsAndVersionsOfTheFuture) {
  model_io::ModelFile model = testing::SomeLogisticModel();
  model.metadata["hc.kind"] = "svm";
  ExpectRefused(model, HC_ERROR_KIND, "the model is of kind 'svm' and Handcraft");
  model.metadata.erase("hc.kind");
  ExpectRefused(model, HC_ERROR_KIND, "the model is of kind ''");
  model = testing::SomeLogisticModel();
  model.metadata["hc.kind_version"] = "2";
  ExpectRefused(model, HC_ERROR_VERSION, "version '2' of kind logistic and Handcraft");
  model.metadata.erase("hc.kind_version");
  ExpectRefused(model, HC_ERROR_VERSION, "version '' of kind logistic");

  Bytes bytes = model_io::Serialise(testing::SomeLogisticModel());
  const std::string version = "\"hc.format\":\"";
  const auto place = std::search(bytes.begin(), bytes.end(), version.begin(), version.end());
  *(place + static_cast<std::ptrdiff_t>(version.size())) = '2';
  ExpectRefused(bytes, HC_ERROR_CHECKSUM, "the file is damaged");
  testing::Seal(bytes);
  ExpectRefused(bytes, HC_ERROR_VERSION, "has format 2.0");
}

TEST(LoadModel, RefusesTensorsOfAnotherKind) {
  model_io::ModelFile model = testing::SomeLogisticModel();
  model.metadata["hc.kind"] = "grasp_point";
  ExpectRefused(model, HC_ERROR_CONTENT, "the tensor 'filter_ids' I32[?] is missing");
}

TEST(LoadModel, RefusesEveryFlippedBitAndEveryTruncation) {
  Bytes bytes = model_io::Serialise(testing::SomeLogisticModel());
  hc_model* model = nullptr;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
    bytes[bit / 8] ^= mask;
    ASSERT_NE(hc_model_load_memory(bytes.data(), bytes.size(), &model, nullptr), HC_OK) << bit;
    ASSERT_EQ(model, nullptr);
    bytes[bit / 8] ^= mask;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_EQ(hc_model_load_memory(bytes.data(), size, &model, nullptr), HC_ERROR_TRUNCATED);
  }
}

TEST(LoadModel, RefusesNullPointers) {
  hc_model* model = nullptr;
  hc_error error{};
  EXPECT_EQ(hc_model_load_memory(nullptr, 10, &model, &error), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_model_load_memory("x", 1, nullptr, &error), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_model_load_file(nullptr, &model, &error), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_model_load_file("x", nullptr, nullptr), HC_ERROR_ARGUMENT);
  EXPECT_THAT(error.message, HasSubstr("null pointer"));
  EXPECT_EQ(hc_model_load_memory(nullptr, 0, &model, &error), HC_ERROR_TRUNCATED);
  hc_model_free(nullptr);
  hc_workspace_free(nullptr);
}

// The promise of the product: the trainer's scorer and the robot's give the same bytes.
TEST(ScoreImage, GivesTheBytesOfTheScorer) {
  for (const std::string_view text : {"all500,energy=log", "edges54", "saxena459"}) {
    const model_io::ModelFile file = testing::SomeGraspPointModel(text);
    const Model model = Load(file);
    const Image picture = testing::SomePicture(70, 45, 3, 1);
    const Workspace workspace = MakeWorkspace(model, 100, 100);
    std::vector<float> probabilities(70 * 45);
    const hc_image view = View(picture);
    ASSERT_EQ(hc_score_image(model.get(), workspace.get(), &view, probabilities.data(), 70), HC_OK);

    const features::PixelScorer scorer(
        features::ParseFeatureSpec(text),
        std::get<std::vector<float>>(file.tensors.at("weights").values),
        std::get<std::vector<double>>(file.tensors.at("intercept").values)[0]);
    const runtime::AlignedBuffer scratch(scorer.WorkspaceBytes(70, 45));
    std::vector<float> expected(probabilities.size());
    scorer.Score({.data = picture.values().data(),
                  .width = 70,
                  .height = 45,
                  .stride_bytes = 210,
                  .format = features::PixelFormat::kBgr8},
                 scratch.Bytes(),
                 expected.data(),
                 70);
    EXPECT_EQ(std::memcmp(probabilities.data(), expected.data(), 4 * expected.size()), 0) << text;
  }
}

TEST(ScoreImage, ReadsStridesAndFormats) {
  const Model model = Load(testing::SomeGraspPointModel("edges54"));
  const Workspace workspace = MakeWorkspace(model, 31, 17);
  const Image bgr = testing::SomePicture(31, 17, 3, 2);
  std::vector<float> expected(31 * 17);
  const hc_image view = View(bgr);
  ASSERT_EQ(hc_score_image(model.get(), workspace.get(), &view, expected.data(), 31), HC_OK);

  // The same picture as RGB in wide rows, into wide rows.
  Bytes wide(120 * 17);
  for (int v = 0; v < 17; ++v) {
    for (int u = 0; u < 31; ++u) {
      for (int c = 0; c < 3; ++c) {
        wide[static_cast<std::size_t>(120 * v + 3 * u + c)] = bgr.At(u, v, 2 - c);
      }
    }
  }
  const hc_image rgb{wide.data(), 31, 17, 120, HC_RGB8};
  std::vector<float> found(40 * 17, -1.0F);
  ASSERT_EQ(hc_score_image(model.get(), workspace.get(), &rgb, found.data(), 40), HC_OK);
  for (std::size_t v = 0; v < 17; ++v) {
    EXPECT_TRUE(std::equal(&expected[31 * v], &expected[31 * v] + 31, &found[40 * v])) << v;
    EXPECT_EQ(found[40 * v + 31], -1.0F) << "wrote behind a row";
  }
}

TEST(ScoreImage, ScoresTinyAndLongImages) {
  const Model model = Load(testing::SomeGraspPointModel("all500"));
  for (const auto& [width, height] : {std::pair{1, 1}, {4, 4}, {1, 50}, {10000, 3}, {3, 10000}}) {
    const Workspace workspace = MakeWorkspace(model, width, height);
    const Image picture = testing::SomePicture(width, height, 1, 3);
    std::vector<float> probabilities(static_cast<std::size_t>(width * height), -1.0F);
    const hc_image view = View(picture);
    ASSERT_EQ(hc_score_image(model.get(), workspace.get(), &view, probabilities.data(), width),
              HC_OK);
    for (const float p : probabilities) ASSERT_TRUE(p >= 0.0F && p <= 1.0F) << p;
  }
}

TEST(ScoreImage, RefusesImagesItCannotScore) {
  const Model model = Load(testing::SomeGraspPointModel("saxena459"));
  const Workspace workspace = MakeWorkspace(model, 20, 10);
  std::vector<float> out(1000);
  const Image gray = testing::SomePicture(20, 10, 1, 4);
  const Image colour = testing::SomePicture(21, 11, 3, 4);
  const auto score = [&](hc_image image) {
    return hc_score_image(model.get(), workspace.get(), &image, out.data(), 30);
  };
  hc_image image = View(gray);
  EXPECT_EQ(score(image), HC_ERROR_IMAGE) << "gray where colour is needed";
  image = View(colour);
  EXPECT_EQ(score(image), HC_ERROR_IMAGE) << "larger than the workspace";
  image.width = 20;
  EXPECT_EQ(score(image), HC_ERROR_IMAGE) << "higher than the workspace";
  image.height = 10;
  EXPECT_EQ(score(image), HC_OK);
  for (const std::int32_t bad : {0, -1, std::numeric_limits<std::int32_t>::min()}) {
    image.height = bad;
    EXPECT_EQ(score(image), HC_ERROR_IMAGE);
  }
}

TEST(ScoreImage, RefusesWrongArguments) {
  const Model model = Load(testing::SomeGraspPointModel("edges54"));
  const Model logistic = Load(testing::SomeLogisticModel());
  const Workspace workspace = MakeWorkspace(model, 20, 10);
  const Image picture = testing::SomePicture(20, 10, 3, 5);
  std::vector<float> out(200);
  const hc_image good = View(picture);
  EXPECT_EQ(hc_score_image(nullptr, workspace.get(), &good, out.data(), 20), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_score_image(model.get(), nullptr, &good, out.data(), 20), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_score_image(model.get(), workspace.get(), nullptr, out.data(), 20),
            HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_score_image(model.get(), workspace.get(), &good, nullptr, 20), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_score_image(model.get(), workspace.get(), &good, out.data(), 19), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_score_image(logistic.get(), workspace.get(), &good, out.data(), 20), HC_ERROR_KIND);
  hc_image bad = good;
  bad.data = nullptr;
  EXPECT_EQ(hc_score_image(model.get(), workspace.get(), &bad, out.data(), 20), HC_ERROR_ARGUMENT);
  bad = good;
  bad.stride_bytes = 59;
  EXPECT_EQ(hc_score_image(model.get(), workspace.get(), &bad, out.data(), 20), HC_ERROR_ARGUMENT);
  bad = good;
  const int no_format = 3;
  std::memcpy(&bad.format, &no_format, sizeof bad.format);
  EXPECT_EQ(hc_score_image(model.get(), workspace.get(), &bad, out.data(), 20), HC_ERROR_ARGUMENT);
}

TEST(ScoreImage, RefusesAWorkspaceThatIsTooSmallForTheModel) {
  const Model small = Load(testing::SomeGraspPointModel("filters=laplacian,window=1"));
  const Model large = Load(testing::SomeGraspPointModel("saxena459"));
  const Workspace workspace = MakeWorkspace(small, 200, 100);
  const Image picture = testing::SomePicture(200, 100, 3, 6);
  std::vector<float> out(200 * 100);
  const hc_image view = View(picture);
  EXPECT_EQ(hc_score_image(large.get(), workspace.get(), &view, out.data(), 200),
            HC_ERROR_ARGUMENT);
}

TEST(CreateWorkspace, RefusesWrongArguments) {
  const Model model = Load(testing::SomeGraspPointModel("edges54"));
  const Model logistic = Load(testing::SomeLogisticModel());
  hc_workspace* workspace = nullptr;
  EXPECT_EQ(hc_workspace_create(nullptr, 1, 1, &workspace), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_workspace_create(model.get(), 1, 1, nullptr), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_workspace_create(model.get(), 0, 1, &workspace), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_workspace_create(model.get(), 1, -1, &workspace), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_workspace_create(model.get(), 1 << 21, 1, &workspace), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_workspace_create(logistic.get(), 1, 1, &workspace), HC_ERROR_KIND);
  EXPECT_EQ(workspace, nullptr);
}

TEST(TopK, FindsPointsInAScoredImage) {
  const std::vector<float> map = {0.1F, 0.9F, 0.8F, 0.2F, 0.3F, 0.7F};
  hc_point points[4];
  std::size_t count = 4;
  ASSERT_EQ(hc_top_k(map.data(), 3, 2, 3, 0.25F, 0, points, &count), HC_OK);
  ASSERT_EQ(count, 4U);
  EXPECT_EQ(points[0].u, 1);
  EXPECT_EQ(points[0].v, 0);
  EXPECT_EQ(points[0].probability, 0.9F);
  EXPECT_EQ(points[3].probability, 0.3F);
  count = 4;
  ASSERT_EQ(hc_top_k(map.data(), 3, 2, 3, 0.05F, 1, points, &count), HC_OK);
  EXPECT_EQ(count, 1U);
  count = 0;
  EXPECT_EQ(hc_top_k(map.data(), 3, 2, 3, 0.0F, 1, nullptr, &count), HC_OK);
}

TEST(TopK, RefusesWrongArguments) {
  const float map[1] = {0.5F};
  hc_point point;
  std::size_t count = 1;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(hc_top_k(nullptr, 1, 1, 1, 0, 0, &point, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 0, 1, 1, 0, 0, &point, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 1, -1, 1, 0, 0, &point, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 1, 1, 0, 0, 0, &point, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 1, 1, 1, nan, 0, &point, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 1, 1, 1, 0, -1, &point, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 1, 1, 1, 0, 0, nullptr, &count), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_top_k(map, 1, 1, 1, 0, 0, &point, nullptr), HC_ERROR_ARGUMENT);
}

TEST(PredictRow, PredictsByHand) {
  const Model model = Load(testing::SomeLogisticModel());
  double probability = -1.0;
  const double row[] = {1.0, 1.0};
  ASSERT_EQ(hc_predict_row(model.get(), row, 2, &probability), HC_OK);
  EXPECT_EQ(probability, 0.5);
}

TEST(PredictRow, RefusesWrongArguments) {
  const Model model = Load(testing::SomeLogisticModel());
  const Model grasp = Load(testing::SomeGraspPointModel("edges54"));
  double probability = -1.0;
  double row[] = {1.0, 1.0, 1.0};
  EXPECT_EQ(hc_predict_row(nullptr, row, 2, &probability), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_predict_row(model.get(), nullptr, 2, &probability), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_predict_row(model.get(), row, 2, nullptr), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_predict_row(model.get(), row, 1, &probability), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_predict_row(model.get(), row, SIZE_MAX, &probability), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_predict_row(grasp.get(), row, 2, &probability), HC_ERROR_KIND);
  row[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hc_predict_row(model.get(), row, 2, &probability), HC_ERROR_ARGUMENT);
  EXPECT_EQ(probability, -1.0);
}

TEST(Runtime, DoesNotAllocateAfterLoading) {
  if (!testing::AllocationCounter::Available()) GTEST_SKIP() << "a sanitizer brings its own malloc";
  const Model model = Load(testing::SomeGraspPointModel("saxena459"));
  const Model logistic = Load(testing::SomeLogisticModel());
  const Workspace workspace = MakeWorkspace(model, 64, 48);
  const Image picture = testing::SomePicture(64, 48, 3, 7);
  const hc_image view = View(picture);
  std::vector<float> out(64 * 48);
  hc_point points[15];
  std::size_t count = 15;
  std::size_t count_apart = 15;
  double probability = 0.0;
  const double row[] = {1.0, 2.0};

  const testing::AllocationCounter counter;
  const hc_status scored = hc_score_image(model.get(), workspace.get(), &view, out.data(), 64);
  const hc_status found = hc_top_k(out.data(), 64, 48, 64, 0.0F, 0, points, &count);
  const hc_status apart = hc_top_k(out.data(), 64, 48, 64, 0.0F, 4, points, &count_apart);
  const hc_status predicted = hc_predict_row(logistic.get(), row, 2, &probability);
  const bool named = hc_model_metadata(model.get(), "hc.name") != nullptr;
  EXPECT_EQ(counter.Count(), 0U);
  EXPECT_EQ(scored, HC_OK);
  EXPECT_EQ(found, HC_OK);
  EXPECT_EQ(apart, HC_OK);
  EXPECT_EQ(predicted, HC_OK);
  EXPECT_TRUE(named);
}

TEST(Runtime, LetsThreadsShareAModel) {
  const Model model = Load(testing::SomeGraspPointModel("all500"));
  const Image picture = testing::SomePicture(80, 60, 3, 8);
  constexpr int kNumThreads = 2;
  std::vector<float> maps[kNumThreads];
  std::vector<std::thread> threads;
  for (std::vector<float>& map : maps) {
    threads.emplace_back([&] {
      const Workspace workspace = MakeWorkspace(model, 80, 60);
      const hc_image view = View(picture);
      map.resize(80 * 60);
      for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(hc_score_image(model.get(), workspace.get(), &view, map.data(), 80), HC_OK);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::memcmp(maps[0].data(), maps[1].data(), 4 * maps[0].size()), 0);
}

TEST(Runtime, ExplainsEveryStatus) {
  std::vector<std::string> messages;
  for (int status = HC_OK; status <= HC_ERROR_IMAGE; ++status) {
    messages.emplace_back(hc_status_message(static_cast<hc_status>(status)));
    EXPECT_THAT(messages.back(),
                AllOf(::testing::EndsWith("."), ::testing::Not("Unknown status.")));
  }
  std::sort(messages.begin(), messages.end());
  EXPECT_EQ(std::unique(messages.begin(), messages.end()), messages.end());
  EXPECT_STREQ(hc_status_message(static_cast<hc_status>(15)), "Unknown status.");
  EXPECT_THAT(hc_version(), ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
}

}  // namespace
}  // namespace handcraft
