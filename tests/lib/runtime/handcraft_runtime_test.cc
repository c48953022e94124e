// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/handcraft_runtime.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/features/pixel_scorer.h"
#include "lib/runtime/aligned_buffer.h"
#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/allocation_counter.h"

namespace handcraft {
namespace {

using ::testing::AllOf;
using testing::Load;
using testing::MakeWorkspace;
using testing::Model;
using testing::View;
using testing::Workspace;
using Bytes = std::vector<std::uint8_t>;

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
  const hc_pixel pixel{5, 6};

  const testing::AllocationCounter counter;
  const hc_status scored = hc_score_image(model.get(), workspace.get(), &view, out.data(), 64);
  const hc_status masked = hc_score_mask(
      model.get(), workspace.get(), &view, picture.values().data(), 192, out.data(), 64);
  const hc_status listed =
      hc_score_pixels(model.get(), workspace.get(), &view, &pixel, 1, out.data());
  const hc_status found = hc_top_k(out.data(), 64, 48, 64, 0.0F, 0, points, &count);
  const hc_status apart = hc_top_k(out.data(), 64, 48, 64, 0.0F, 4, points, &count_apart);
  const hc_status predicted = hc_predict_row(logistic.get(), row, 2, &probability);
  const bool named = hc_model_metadata(model.get(), "hc.name") != nullptr;
  EXPECT_EQ(counter.Count(), 0U);
  EXPECT_EQ(scored, HC_OK);
  EXPECT_EQ(masked, HC_OK);
  EXPECT_EQ(listed, HC_OK);
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
