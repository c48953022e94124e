// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>

#include "lib/robot/rotation.h"

namespace handcraft::robot {

/// A rigid motion, target_from_source: p_in_target = rotation · p_in_source + translation.
struct Pose {
  Matrix3 rotation = kIdentity3;
  Vector3 translation_m = {};
};

/// a_from_c = a_from_b · b_from_c.
[[nodiscard]] Pose operator*(const Pose& a_from_b, const Pose& b_from_c) noexcept;
[[nodiscard]] Pose Inverse(const Pose& pose) noexcept;
[[nodiscard]] Vector3 Apply(const Pose& pose, const Vector3& point_m) noexcept;

/// How far one pose is from another: distance of the origins, angle of the turn between them.
struct PoseError {
  double position_m = 0.0;
  double rotation_rad = 0.0;
};
[[nodiscard]] PoseError ErrorBetween(const Pose& a, const Pose& b) noexcept;

/// Fixed axes x, y, z in this order, as URDF has it: R = Rz(yaw) · Ry(pitch) · Rx(roll).
[[nodiscard]] Matrix3 RotationFromRollPitchYaw(const Vector3& rpy_rad) noexcept;

/// Quaternions are x, y, z, w, as in ROS messages. That of a pose has w ≥ 0. A pose takes one that
/// has not quite length 1 and scales it.
[[nodiscard]] Matrix3 RotationFromQuaternion(const std::array<double, 4>& xyzw) noexcept;
[[nodiscard]] std::array<double, 4> QuaternionFromRotation(const Matrix3& rotation) noexcept;

/// What is wrong with a pose that came from outside: a number that is not finite, or a rotation
/// that is none: |RᵀR − I| > 1e-6 in an entry (singular, scaled), or det R < 0 (mirrored). Empty
/// for a sound pose.
[[nodiscard]] std::string FaultOf(const Pose& pose);

}  // namespace handcraft::robot
