// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "lib/core/image.h"
#include "lib/features/feature_spec.h"

namespace handcraft::model_io {

/// A picture and the probabilities a model gives it, stored in the model so that the robot can tell
/// at load whether it computes the same (docs/model_format.md § 5.3).
struct GraspPointSelfTest {
  Image picture;                     ///< blue, green, red
  std::vector<float> probabilities;  ///< one a pixel, row-major
  float tolerance = 0.0F;            ///< largest difference of probability allowed
};

/// 40 × 30 pixels, blue, green, red: ramps, a bright disc, a dark bar, and noise over the right
/// half, so that the energies of every filter span many decades. Always the same.
[[nodiscard]] Image SelfTestPicture();

/// Scores the picture. The tolerance covers processors that round differently (those without a
/// fused multiply-add): 16 times the largest difference between the instruction sets of this one,
/// or 16 roundings of the sum Σ |w · x| behind a probability, whichever is larger; from 1e-5 to
/// 0.1.
[[nodiscard]] GraspPointSelfTest MakeGraspPointSelfTest(const features::FeatureSpec& spec,
                                                        std::span<const float> weights,
                                                        double intercept);

}  // namespace handcraft::model_io
