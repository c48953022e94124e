// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "datasets/synthetic/camera.h"
#include "datasets/synthetic/visibility.h"
#include "lib/core/image.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// Which pixels' points light from one place reaches: 255, or 0 in its shadow, on surfaces that
/// face away from it, and where nothing is.
[[nodiscard]] Image ReachedFrom(const RayTracer& tracer,
                                const PixelHits& pixels,
                                const Eigen::Vector3f& from_m);

/// A still picture of random dots, as an active stereo camera throws it, 0 ... 1 with a mean of a
/// half: a grid of bright and dark cells, each with equal odds, blended linearly. It repeats itself
/// after some thousand pixels.
class DotPattern {
 public:
  /// Cells of that size in the projector's own picture [px].
  DotPattern(float cell_px, Rng& rng);

  [[nodiscard]] float At(float u_px, float v_px) const;

 private:
  [[nodiscard]] float Cell(int column, int row) const;

  float cell_px_;
  std::vector<std::uint8_t> cells_;
};

/// Multiplies the light of each pixel (linear, `light` of the size of `pixels`) by
/// 1 + gain · pattern where the projector reaches its point. The projector is a camera run
/// backwards: its pose and focal length say where a point has its place in the pattern.
void ProjectPattern(const DotPattern& pattern,
                    const PinholeCamera& projector,
                    const Image& reached,
                    const PixelHits& pixels,
                    float gain,
                    FloatImage& light);

}  // namespace handcraft::synthetic
