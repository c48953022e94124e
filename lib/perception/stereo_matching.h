// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/core/image.h"

namespace handcraft::perception {

enum class StereoMatcher {
  kSemiGlobal,  ///< OpenCV's StereoSGBM: block 5, P1 200, P2 800, uniqueness 10 %
  kBlock,       ///< OpenCV's StereoBM: block 15, uniqueness 10 %
};

/// How many disparities are searched: all up to that of a point nearest_m away,
/// d = focal · baseline / depth, rounded up to a multiple of 16.
[[nodiscard]] int NumDisparities(float focal_px, float baseline_m, float nearest_m);

/// Disparity of each pixel of the left picture of a rectified pair [px]; NaN where none was found.
/// None is found in the first `num_disparities` columns. Speckles of less than 100 pixels that
/// differ by more than 2 px from what is around them are left out. Gray or BGR, of the same size.
/// Same pictures, same values, in whole numbers: steps of 1/16 px.
/// Source: H. Hirschmüller, "Stereo processing by semiglobal matching and mutual information",
/// 2008, and K. Konolige's block matching, both as OpenCV has them.
[[nodiscard]] FloatImage MatchPair(const Image& left,
                                   const Image& right,
                                   StereoMatcher matcher,
                                   int num_disparities);

/// depth = focal · baseline / disparity [m]; 0, nothing, where there is no disparity or the depth
/// is beyond farthest_m.
[[nodiscard]] FloatImage DepthOfDisparity(const FloatImage& disparity_px,
                                          float focal_px,
                                          float baseline_m,
                                          float farthest_m);

}  // namespace handcraft::perception
