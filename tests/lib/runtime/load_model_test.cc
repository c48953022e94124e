// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Loading through the C interface: what is told, what is refused, and in which words.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/raw_model.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

using ::testing::HasSubstr;
using testing::Load;
using testing::Model;
using Bytes = std::vector<std::uint8_t>;

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
  model.metadata["hc.kind"] = "fold";
  ExpectRefused(model, HC_ERROR_KIND, "the model is of kind 'fold' and Handcraft");
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
  EXPECT_EQ(hc_model_kind(nullptr), 0);
  EXPECT_EQ(hc_model_num_features(nullptr), 0U);
  EXPECT_EQ(hc_model_needs_colour(nullptr), 0);
  EXPECT_EQ(hc_model_metadata(nullptr, "hc.name"), nullptr);
  hc_model_free(nullptr);
  hc_workspace_free(nullptr);
}

}  // namespace
}  // namespace handcraft
