// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/renderer.h"
#include "lib/core/image.h"

namespace handcraft::synthetic {

enum class StereoMatcher {
  kSemiGlobal,  ///< OpenCV's StereoSGBM: block 5, P1 200, P2 800, uniqueness 10 %
  kBlock,       ///< OpenCV's StereoBM: block 15, uniqueness 10 %
};

/// Two cameras beside each other, and what is done with their pictures.
struct StereoOptions {
  StereoMatcher matcher = StereoMatcher::kSemiGlobal;
  float baseline_m = 0.12F;  ///< in (0, 1]
  float nearest_m = 0.4F;    ///< depth of the nearest point that is found; in [0.1, farthest_m)
  float farthest_m = 2.0F;   ///< points beyond are left out; at most 100
  /// A projector between the cameras throws random dots on the scene while the pair is taken that
  /// is matched; the picture that is kept is taken without.
  bool has_projector = false;

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// How many disparities are searched: all up to that of the nearest point,
/// d = focal · baseline / depth, rounded up to a multiple of 16.
[[nodiscard]] int NumDisparities(const PinholeCamera& camera, const StereoOptions& options);

/// Disparity of each pixel of the left picture of a rectified pair [px]; NaN where none was found.
/// None is found in the first `num_disparities` columns. Speckles of less than 100 pixels that
/// differ by more than 2 px from what is around them are left out. Same pictures, same values, in
/// whole numbers: steps of 1/16 px.
/// Source: H. Hirschmüller, "Stereo processing by semiglobal matching and mutual information",
/// 2008, and K. Konolige's block matching, both as OpenCV has them.
[[nodiscard]] FloatImage MatchPair(const Image& left,
                                   const Image& right,
                                   StereoMatcher matcher,
                                   int num_disparities);

/// What a stereo camera takes of a scene; `view`, `image` and `cloud` are those of its left camera,
/// which is the scene's.
struct StereoShot {
  View view;
  Image image;
  Image right_image;
  datasets::OrganisedCloud cloud;
};

/// Takes a scene: both cameras are rendered wider to the left by the number of disparities, so that
/// every column of the pictures is searched in full, and cut to their size after matching. Noise
/// and dots are drawn from streams of (seed, name). The options must be valid.
[[nodiscard]] StereoShot TakeStereo(const Scene& scene,
                                    const StereoOptions& options,
                                    std::uint64_t seed,
                                    std::string_view name);

}  // namespace handcraft::synthetic
