// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/evaluation/grasp_point_evaluation.h"

namespace handcraft::experiments {

/// The best pixels of one image by the ground they lie on.
struct BestPixelCounts {
  std::size_t good = 0;
  std::size_t bad = 0;
  std::size_t dont_care = 0;  ///< shown, not counted
};
[[nodiscard]] BestPixelCounts CountBestPixels(const ImageScore& image);

/// The figures of a group of images. Intervals: bootstrap over its images (grouped_ratio.h,
/// grouped_ranking.h); for a share of exactly 0 or 1 the Wilson interval with as many trials as
/// images that count. A figure that has nothing to stand on (no counted pixel, one kind of pixel)
/// is NaN, and so is the interval of a single image. Pure; the number of threads does not change a
/// bit.
[[nodiscard]] GroupFigures ComputeGroupFigures(const std::string& name,
                                               std::span<const ImageScore* const> images,
                                               const EvaluationOptions& options);

/// The drawn pixels of all images in one row.
struct PooledPixels {
  std::vector<float> probabilities;
  std::vector<std::uint8_t> labels;
};
[[nodiscard]] PooledPixels PoolPixels(std::span<const ImageScore> images);

/// Fills evaluation.all, .classes (by name) and .curves from evaluation.images.
void FormFigures(const datasets::LabelledImageSet& set, GraspPointEvaluation& evaluation);

}  // namespace handcraft::experiments
