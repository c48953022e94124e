// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <string>

#include "lib/robot/serial_chain.h"

namespace handcraft::robot {

/// Three axes that meet, as rotations of one after the other:
///   Rz(θ₁) · Rx(α₁₂) · Rz(θ₂) · Rx(α₂₃) · Rz(θ₃),
/// between a frame with z along the first axis and one with z along the third, both at joint
/// values 0; θ₁ = q₁, θ₂ = q₂ + offset, θ₃ = q₃.
struct SphericalJoint {
  Vector3 centre_m;     ///< where the axes meet, in the base frame
  Matrix3 first_frame;  ///< base_from_first
  Matrix3 third_frame;  ///< base_from_third
  double cos_12 = 0.0;
  double sin_12 = 1.0;  ///< > 0
  double cos_23 = 0.0;
  double sin_23 = 1.0;  ///< > 0
  double offset_rad = 0.0;
};

/// A 7-joint arm with a closed form: axes 1, 2, 3 meet in the shoulder, 5, 6, 7 in the wrist, and
/// the elbow's axis 4 lies anywhere, so offsets at the elbow are taken. All joints at 0.
struct SphericalArm {
  SphericalJoint shoulder;
  SphericalJoint wrist;
  JointLine elbow;
  Pose base_from_tip;  ///< with all joints at 0

  /// |shoulder − wrist|² = constant + cosine · cos q₄ + sine · sin q₄ [m²].
  double reach_constant = 0.0;
  double reach_cosine = 0.0;
  double reach_sine = 0.0;
};

/// The geometry of a chain, or why it has no such closed form.
struct SphericalArmSearch {
  std::optional<SphericalArm> arm;
  std::string reason;  ///< empty when there is one
};

/// Axes meet when they pass each other within 1e-9 m, and neighbours must stand at least 3° apart.
/// Thread-safe.
[[nodiscard]] SphericalArmSearch FindSphericalArm(const SerialChain& chain);

}  // namespace handcraft::robot
