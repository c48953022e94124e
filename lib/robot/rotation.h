// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "lib/features/vector3.h"

namespace handcraft::robot {

/// Vectors and rotations of three dimensions in plain C++, so that what a robot runs needs no
/// matrix library. Nothing here allocates or throws.
using features::Cross;
using features::Dot;
using features::Subtract;
using features::Vector3;
using Matrix3 = std::array<double, 9>;  ///< row-major

inline constexpr Matrix3 kIdentity3 = {1, 0, 0, 0, 1, 0, 0, 0, 1};

[[nodiscard]] constexpr Vector3 Add(const Vector3& a, const Vector3& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
[[nodiscard]] constexpr Vector3 Scale(const Vector3& a, double factor) noexcept {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}
[[nodiscard]] double Norm(const Vector3& a) noexcept;

[[nodiscard]] constexpr Vector3 Multiply(const Matrix3& a, const Vector3& b) noexcept {
  return {a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
          a[3] * b[0] + a[4] * b[1] + a[5] * b[2],
          a[6] * b[0] + a[7] * b[1] + a[8] * b[2]};
}
[[nodiscard]] Matrix3 Multiply(const Matrix3& a, const Matrix3& b) noexcept;
[[nodiscard]] Matrix3 Transpose(const Matrix3& a) noexcept;
[[nodiscard]] double Determinant(const Matrix3& a) noexcept;
[[nodiscard]] Vector3 Column(const Matrix3& a, int column) noexcept;
/// The matrix with these columns.
[[nodiscard]] Matrix3 FromColumns(const Vector3& x, const Vector3& y, const Vector3& z) noexcept;

/// A rotation next to a matrix that is nearly one: z kept in direction, x in the plane of both, y
/// their product.
[[nodiscard]] Matrix3 Orthonormalised(const Matrix3& rotation) noexcept;

/// Rotation by an angle [rad] about a unit axis (Rodrigues).
[[nodiscard]] Matrix3 AxisRotation(const Vector3& axis, double angle_rad) noexcept;

/// The vector along the axis of a rotation, as long as its angle, in [0, π] [rad]: the inverse of
/// AxisRotation. Exact to rounding near 0 and near π.
[[nodiscard]] Vector3 RotationVector(const Matrix3& rotation) noexcept;

}  // namespace handcraft::robot
