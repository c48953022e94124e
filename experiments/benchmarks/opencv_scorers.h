// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include "lib/core/image.h"
#include "lib/features/feature_spec.h"

namespace handcraft::experiments {

/// The peers of features::PixelScorer: the same probabilities put together from OpenCV's parts, as
/// a reader of the dissertation would. Gray pictures, specifications without scales; one thread
/// (cv::setNumThreads(1) is the caller's business).

/// filter2D with every kernel of the bank, then for each pixel the window's energies gathered into
/// a vector, a dot product and a sigmoid.
[[nodiscard]] FloatImage ScoreByGathering(const Image& gray,
                                          const features::FeatureSpec& spec,
                                          std::span<const float> weights,
                                          float intercept);

/// filter2D with every kernel, then filter2D of every energy picture with its weights, summed.
[[nodiscard]] FloatImage ScoreByConvolutions(const Image& gray,
                                             const features::FeatureSpec& spec,
                                             std::span<const float> weights,
                                             float intercept);

}  // namespace handcraft::experiments
