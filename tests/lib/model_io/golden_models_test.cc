// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of every released format load for ever and predict what they predicted when they were made.

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "lib/model_io/model_writer.h"
#include "lib/runtime/handcraft_runtime.h"
#include "tests/lib/runtime/some_models.h"

namespace handcraft {
namespace {

const std::filesystem::path kFolder = HANDCRAFT_SOURCE_DIR "/tests/data/models";

hc_model* Load(const std::string& name) {
  hc_model* model = nullptr;
  hc_error error{};
  EXPECT_EQ(hc_model_load_file((kFolder / name).c_str(), &model, &error), HC_OK)
      << name << ": " << error.message;
  return model;
}

// Probabilities of SomePicture(16, 12, 3, 1) at (3, 2), (8, 6) and (15, 11).
void ExpectScores(const std::string& name, const std::vector<float>& expected) {
  hc_model* model = Load(name);
  hc_workspace* workspace = nullptr;
  ASSERT_EQ(hc_workspace_create(model, 16, 12, &workspace), HC_OK);
  const Image picture = testing::SomePicture(16, 12, 3, 1);
  const hc_image image{picture.values().data(), 16, 12, 48, HC_BGR8};
  std::vector<float> map(16 * 12);
  ASSERT_EQ(hc_score_image(model, workspace, &image, map.data(), 16), HC_OK);
  EXPECT_NEAR(map[2 * 16 + 3], expected[0], 1e-5);
  EXPECT_NEAR(map[6 * 16 + 8], expected[1], 1e-5);
  EXPECT_NEAR(map[11 * 16 + 15], expected[2], 1e-5);
  hc_workspace_free(workspace);
  hc_model_free(model);
}

TEST(GoldenModels, OfFormat1ScorePixelsAsTheyDid) {
  ExpectScores("v1_grasp_point_edges54.safetensors", {0.328668F, 0.195423F, 0.117329F});
  ExpectScores("v1_grasp_point_saxena459.safetensors", {0.344438F, 0.946584F, 0.999436F});
}

TEST(GoldenModels, OfFormat1PredictRowsAsTheyDid) {
  hc_model* model = Load("v1_logistic.safetensors");
  const double row[] = {0.25, 0.75};
  double probability = 0.0;
  ASSERT_EQ(hc_predict_row(model, row, 2, &probability), HC_OK);
  EXPECT_NEAR(probability, 1.0 / (1.0 + std::exp(0.75)), 1e-15);
  hc_model_free(model);
}

TEST(GoldenModels, OfFormat1ClassifyRowsAsTheyDid) {
  hc_model* model = Load("v1_svm.safetensors");
  hc_workspace* workspace = nullptr;
  ASSERT_EQ(hc_row_workspace_create(model, &workspace), HC_OK);
  const double row[] = {2.5, 1.5};
  hc_class_prediction prediction{};
  ASSERT_EQ(hc_classify_row(model, workspace, row, 2, &prediction), HC_OK);
  EXPECT_EQ(std::string(hc_model_class_name(model, 0)), "bottle");
  EXPECT_EQ(prediction.number, 0);
  EXPECT_EQ(prediction.margin, 1.0);
  hc_workspace_free(workspace);
  hc_model_free(model);
}

TEST(GoldenModels, OfFormat1ClassifyCloudsAsTheyDid) {
  hc_model* model = Load("v1_object_class.safetensors");
  hc_workspace* workspace = nullptr;
  ASSERT_EQ(hc_row_workspace_create(model, &workspace), HC_OK);
  // Two by two pixels at depths 1, 3, 2 and 2: F = (−1, 1, 0, 0).
  const float points[] = {1, 0, 0, 3, 1, 0, 2, 0, 1, 2, 1, 1};
  const hc_cloud cloud{points, 2, 2, 6, 3, nullptr, 0};
  hc_class_prediction prediction{};
  double values[3];
  ASSERT_EQ(hc_classify_cloud(model, workspace, &cloud, &prediction, values), HC_OK);
  EXPECT_EQ(std::string(hc_model_class_name(model, 1)), "mug");
  EXPECT_EQ(prediction.number, 1);
  EXPECT_EQ(values[0], -2.0);
  EXPECT_EQ(values[1], -1.0);
  EXPECT_EQ(values[2], 1.0);
  hc_workspace_free(workspace);
  hc_model_free(model);
}

// Of SomeObject(24, 20).
void ExpectClass(const std::string& name, bool is_rejected, const std::vector<double>& expected) {
  hc_model* model = Load(name);
  hc_workspace* workspace = nullptr;
  ASSERT_EQ(hc_row_workspace_create(model, &workspace), HC_OK);
  const testing::SomeObject object(24, 20);
  const hc_cloud cloud{object.points.data(), 24, 20, 72, 3, object.mask.data(), 24};
  hc_class_prediction prediction{};
  double values[3];
  ASSERT_EQ(hc_classify_cloud(model, workspace, &cloud, &prediction, values), HC_OK);
  EXPECT_EQ(prediction.number, 2);
  EXPECT_EQ(prediction.rejected != 0, is_rejected);
  for (std::size_t m = 0; m < 3; ++m) EXPECT_NEAR(values[m], expected[m], 1e-5) << name;
  hc_workspace_free(workspace);
  hc_model_free(model);
}

TEST(GoldenModels, OfFormat1ClassifyHistogramsAsTheyDid) {
  ExpectClass("v1_object_class_vfh.safetensors", false, {29.09090936, -70.90909285, -100.00000226});
  ExpectClass(
      "v1_object_class_esf.safetensors", true, {-0.0018049726, -0.0091311756, -0.0073262030});
}

TEST(GoldenModels, OfFormat1FindGraspsAsTheyDid) {
  hc_model* model = Load("v1_grasp_library.safetensors");
  hc_workspace* workspace = nullptr;
  ASSERT_EQ(hc_workspace_create(model, 4, 3, &workspace), HC_OK);
  std::vector<float> points;
  for (int v = 0; v < 3; ++v) {
    for (int u = 0; u < 4; ++u) {
      points.push_back(0.01F * static_cast<float>(u));
      points.push_back(0.02F * static_cast<float>(u));
      points.push_back(0.01F * static_cast<float>(v));
    }
  }
  const std::vector<std::uint8_t> mask(12, 1);
  const hc_cloud cloud{points.data(), 4, 3, 12, 3, mask.data(), 4};
  const hc_grasp_request request{1, 1, {0.02, 0.03, 0.01}};
  hc_grasp grasp{};
  ASSERT_EQ(hc_find_grasp(model, workspace, &cloud, &request, &grasp), HC_OK);
  EXPECT_EQ(std::string(hc_model_class_name(model, 1)), "drill");
  EXPECT_EQ(grasp.view, 10);
  EXPECT_EQ(grasp.demonstration, 151);
  EXPECT_NEAR(grasp.distance_m, 0.062667850807063205, 1e-9);
  hc_workspace_free(workspace);
  hc_model_free(model);
}

// Reading and writing again changes no byte: one model has one encoding.
TEST(GoldenModels, AreWrittenAgainAsTheyAre) {
  int num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".safetensors") continue;
    ++num_files;
    const std::vector<std::uint8_t> bytes = ReadFile(entry.path());
    EXPECT_EQ(model_io::Serialise(model_io::Parse(bytes, entry.path())), bytes) << entry.path();
  }
  EXPECT_EQ(num_files, 8);
}

}  // namespace
}  // namespace handcraft
