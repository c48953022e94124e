// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/scene.h"
#include "lib/core/image.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// A depth camera that throws a pattern and matches it, as the first Kinect does.
struct DepthCameraOptions {
  float baseline_m = 0.075F;         ///< from the camera to its projector, on its right; in (0, 1]
  float disparity_step_px = 0.125F;  ///< smallest difference that it tells; in (0, 1]
  float nearest_m = 0.4F;            ///< nothing is measured nearer; at least 0.1
  float farthest_m = 3.0F;           ///< nor farther; more than nearest_m, at most 100

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Standard deviation of the depth that is measured [m] at a depth z [m] of a surface whose normal
/// makes the angle θ [rad] with the ray:
///   0.0012 + 0.0019 (z − 0.4)² + 0.0001 / √z · θ² / (π/2 − θ)²,
/// the last term beyond 60° alone. Needs z > 0 and 0 ≤ θ < π/2.
/// Source: C. V. Nguyen, S. Izadi, D. Lovell, "Modeling Kinect sensor noise for improved 3D
/// reconstruction and tracking", 3DIMPVT 2012.
[[nodiscard]] float AxialNoise(float depth_m, float angle_rad);

/// Standard deviation across the ray [px]: 0.8 + 0.035 θ / (π/2 − θ). Same source.
[[nodiscard]] float LateralNoise(float angle_rad);

/// The depth that the scene's camera measures [m]; 0 where nothing: out of range, in the
/// projector's shadow, on surfaces steeper than 80° to the ray, and for half of the pixels beside
/// a step of more than 3 % of the depth. Each pixel takes the depth of a pixel that lateral noise
/// leads to, adds axial noise, and is rounded to a whole number of steps of disparity,
/// d = focal · baseline / depth. The options must be valid. Same scene and state of the generator,
/// same values.
[[nodiscard]] FloatImage MeasureDepth(const Scene& scene,
                                      const DepthCameraOptions& options,
                                      Rng& rng);

}  // namespace handcraft::synthetic
