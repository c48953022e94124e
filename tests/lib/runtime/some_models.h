// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/image.h"
#include "lib/core/rng.h"
#include "lib/model_io/linear_models.h"

namespace handcraft::testing {

/// A grasp-point model whose weights are drawn from a fixed seed: what it predicts means nothing,
/// but it takes every value between 0 and 1.
inline model_io::ModelFile SomeGraspPointModel(std::string_view spec_text) {
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  Rng rng = Rng::Stream(1, spec_text);
  model_io::LinearModel model;
  model.intercept = 0.25;
  for (int i = 0; i < spec.NumFeatures(); ++i) {
    model.weights.push_back(rng.Normal() / std::sqrt(spec.NumFeatures()));
    model.feature_mean.push_back(rng.Uniform());
    model.feature_scale.push_back(0.5 + rng.Uniform());
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

}  // namespace handcraft::testing
