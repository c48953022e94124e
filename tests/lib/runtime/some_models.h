// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/image.h"
#include "lib/core/rng.h"
#include "lib/features/pixel_features.h"
#include "lib/model_io/grasp_library_models.h"
#include "lib/model_io/linear_models.h"
#include "lib/model_io/object_class_models.h"
#include "lib/model_io/svm_models.h"
#include "tests/lib/features/some_grasp_library.h"
#include "tests/lib/features/some_object.h"

namespace handcraft::testing {

/// A picture of noise over ramps, from a seed.
inline Image SomePicture(int width, int height, int channels, std::uint64_t seed) {
  Image picture(width, height, channels);
  Rng rng(seed);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      for (int c = 0; c < channels; ++c) {
        picture.At(u, v, c) = static_cast<std::uint8_t>((4 * u + 3 * v + 50 * c) % 200 +
                                                        static_cast<int>(rng.UniformInt(56)));
      }
    }
  }
  return picture;
}

/// Mean and standard deviation of each feature over the pixels of a picture.
inline void MeasureFeatures(const Image& picture,
                            const features::FeatureSpec& spec,
                            model_io::LinearModel& model) {
  const features::PixelFeatures pixels({.data = picture.values().data(),
                                        .width = picture.width(),
                                        .height = picture.height(),
                                        .stride_bytes = std::ptrdiff_t{3} * picture.width(),
                                        .format = features::PixelFormat::kBgr8},
                                       spec);
  const auto num_features = static_cast<std::size_t>(spec.NumFeatures());
  const int num_pixels = picture.width() * picture.height();
  std::vector<float> x(num_features);
  std::vector<double> sum(num_features);
  std::vector<double> sum_of_squares(num_features);
  for (int i = 0; i < num_pixels; ++i) {
    pixels.Gather(i % picture.width(), i / picture.width(), x);
    for (std::size_t j = 0; j < num_features; ++j) {
      sum[j] += x[j];
      sum_of_squares[j] += double{x[j]} * double{x[j]};
    }
  }
  for (std::size_t j = 0; j < num_features; ++j) {
    const double mean = sum[j] / num_pixels;
    model.feature_mean.push_back(mean);
    model.feature_scale.push_back(std::sqrt(sum_of_squares[j] / num_pixels - mean * mean));
  }
}

/// A grasp-point model whose standardised weights are drawn from a fixed seed: what it predicts
/// means nothing, but it takes values all over 0 to 1.
inline model_io::ModelFile SomeGraspPointModel(std::string_view spec_text) {
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  Rng rng = Rng::Stream(1, spec_text);
  model_io::LinearModel model;
  MeasureFeatures(SomePicture(30, 20, 3, 1), spec, model);
  for (std::size_t i = 0; i < model.feature_mean.size(); ++i) {
    model.weights.push_back(rng.Normal() / std::sqrt(spec.NumFilters()) / model.feature_scale[i]);
    model.intercept -= model.weights[i] * model.feature_mean[i];
  }
  model_io::Provenance provenance;
  provenance.name = "some_grasp_points";
  provenance.hyper_parameters = {{"seed", "1"}, {"ridge", "0"}};
  return model_io::MakeGraspPointModel(spec, model, provenance);
}

/// p = 1 / (1 + exp(−(1 + 2 x0 − 3 x1))).
inline model_io::ModelFile SomeLogisticModel() {
  const model_io::LinearModel model{.weights = {2.0, -3.0},
                                    .intercept = 1.0,
                                    .feature_mean = {0.5, -0.5},
                                    .feature_scale = {1.0, 2.0}};
  model_io::Provenance provenance;
  provenance.name = "some_table";
  return model_io::MakeLogisticModel(
      {"length_m", "width_m"}, "fits", "no", "yes", model, provenance);
}

/// A linear machine of three classes of (x0', x1') = (x0 − 0.5, (x1 + 0.5) / 2):
/// f01 = x0' − x1', f02 = 2x0' + x1', f12 = x0' + 2x1' − 0.25.
inline model_io::SvmModel SomeSvm() {
  return {.similarity = {.type = features::SimilarityType::kLinear},
          .scheme = features::ClassScheme::kOneAgainstOne,
          .num_classes = 3,
          .feature_mean = {0.5, -0.5},
          .feature_scale = {1.0, 2.0},
          .support_vectors = {1, 0, 0, 1, -1, -1},
          .single_precision = true,
          .support_classes = {0, 1, 2},
          .machine_begins = {0, 2, 4, 6},
          .machine_supports = {0, 1, 0, 2, 1, 2},
          .dual_coefficients = {1, -1, 1, -1, 1, -1},
          .intercepts = {0.0, 0.0, -0.25},
          .rejection_threshold = {}};
}

inline model_io::SvmNames SomeSvmNames() {
  return {.columns = {"length_m", "width_m"},
          .classes = {"bottle", "mug", "drill"},
          .label_column = "object"};
}

inline model_io::ModelFile SomeSvmModel(const model_io::SvmModel& model = SomeSvm()) {
  model_io::Provenance provenance;
  provenance.name = "some_objects";
  return model_io::MakeSvmModel(model, SomeSvmNames(), provenance);
}

/// Three classes told apart by the depth of four cells: f01 = F0 − F1, f02 = F0 − F2, f12 = F1 −
/// F2.
inline model_io::ObjectClassModel SomeObjectClasses() {
  model_io::ObjectClassModel model{
      .descriptor = {.type = features::CloudDescriptorType::kDepthGrid, .grid_size = 2},
      .svm = SomeSvm(),
      .classes = {"bottle", "mug", "drill"}};
  model.svm.feature_mean.assign(4, 0.0);
  model.svm.feature_scale.assign(4, 1.0);
  model.svm.support_vectors = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  model.svm.intercepts = {0.0, 0.0, 0.0};
  return model;
}

inline model_io::ModelFile SomeObjectClassModel(
    const model_io::ObjectClassModel& model = SomeObjectClasses()) {
  model_io::Provenance provenance;
  provenance.name = "some_clouds";
  return model_io::MakeObjectClassModel(model, SomeObject(12, 10).View(), provenance);
}

inline model_io::ModelFile SomeGraspLibraryModel() {
  model_io::Provenance provenance;
  provenance.name = "some_grasps";
  return model_io::MakeGraspLibraryModel(
      features::testing::SomeGraspLibrary(),
      {.classes = {"mug", "drill"}, .robot = "some_robot", .joints = {"j1", "j2"}},
      provenance);
}

}  // namespace handcraft::testing
