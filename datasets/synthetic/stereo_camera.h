// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/renderer.h"
#include "lib/core/image.h"
#include "lib/perception/stereo_matching.h"

namespace handcraft::synthetic {

using perception::StereoMatcher;

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

/// How many disparities are searched (see perception::NumDisparities).
[[nodiscard]] int NumDisparities(const PinholeCamera& camera, const StereoOptions& options);

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
