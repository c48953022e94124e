// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/core/fields.h"

namespace handcraft::robot {

Pose operator*(const Pose& a_from_b, const Pose& b_from_c) noexcept {
  return {Multiply(a_from_b.rotation, b_from_c.rotation), Apply(a_from_b, b_from_c.translation_m)};
}

Pose Inverse(const Pose& pose) noexcept {
  const Matrix3 inverse = Transpose(pose.rotation);
  return {inverse, Scale(Multiply(inverse, pose.translation_m), -1.0)};
}

Vector3 Apply(const Pose& pose, const Vector3& point_m) noexcept {
  return Add(Multiply(pose.rotation, point_m), pose.translation_m);
}

PoseError ErrorBetween(const Pose& a, const Pose& b) noexcept {
  return {Norm(Subtract(a.translation_m, b.translation_m)),
          Norm(RotationVector(Multiply(Transpose(a.rotation), b.rotation)))};
}

Matrix3 RotationFromRollPitchYaw(const Vector3& rpy_rad) noexcept {
  const Matrix3 roll = AxisRotation({1, 0, 0}, rpy_rad[0]);
  const Matrix3 pitch = AxisRotation({0, 1, 0}, rpy_rad[1]);
  const Matrix3 yaw = AxisRotation({0, 0, 1}, rpy_rad[2]);
  return Multiply(yaw, Multiply(pitch, roll));
}

Matrix3 RotationFromQuaternion(const std::array<double, 4>& xyzw) noexcept {
  const auto [x, y, z, w] = xyzw;
  const double s = 2.0 / (x * x + y * y + z * z + w * w);
  return {1 - s * (y * y + z * z),
          s * (x * y - z * w),
          s * (x * z + y * w),
          s * (x * y + z * w),
          1 - s * (x * x + z * z),
          s * (y * z - x * w),
          s * (x * z - y * w),
          s * (y * z + x * w),
          1 - s * (x * x + y * y)};
}

std::array<double, 4> QuaternionFromRotation(const Matrix3& rotation) noexcept {
  const Vector3 vector = RotationVector(rotation);
  const double angle_rad = Norm(vector);
  const double factor = angle_rad > 0.0 ? std::sin(0.5 * angle_rad) / angle_rad : 0.5;
  return {vector[0] * factor, vector[1] * factor, vector[2] * factor, std::cos(0.5 * angle_rad)};
}

std::string FaultOf(const Pose& pose) {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(pose.rotation.begin(), pose.rotation.end(), is_finite) ||
      !std::all_of(pose.translation_m.begin(), pose.translation_m.end(), is_finite)) {
    return "the pose holds a number that is not finite";
  }
  constexpr double kTolerance = 1e-6;
  const Matrix3 product = Multiply(Transpose(pose.rotation), pose.rotation);
  double largest = 0.0;
  for (std::size_t i = 0; i < product.size(); ++i) {
    largest = std::max(largest, std::abs(product[i] - kIdentity3[i]));
  }
  const double determinant = Determinant(pose.rotation);
  if (largest <= kTolerance && determinant > 0.0) return {};
  return "the pose's rotation is none: its determinant is " + NumberToText(determinant) +
         ", its columns are off right angles and length 1 by " + NumberToText(largest);
}

}  // namespace handcraft::robot
