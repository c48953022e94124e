// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/rotation.h"

#include <cmath>
#include <cstddef>

namespace handcraft::robot {

double Norm(const Vector3& a) noexcept { return std::sqrt(Dot(a, a)); }

Matrix3 Multiply(const Matrix3& a, const Matrix3& b) noexcept {
  Matrix3 product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      product[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return product;
}

Matrix3 Transpose(const Matrix3& a) noexcept {
  return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]};
}

double Determinant(const Matrix3& a) noexcept {
  return Dot(Column(a, 0), Cross(Column(a, 1), Column(a, 2)));
}

Vector3 Column(const Matrix3& a, int column) noexcept {
  const auto j = static_cast<std::size_t>(column);
  return {a[j], a[3 + j], a[6 + j]};
}

Matrix3 FromColumns(const Vector3& x, const Vector3& y, const Vector3& z) noexcept {
  return {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
}

Matrix3 Orthonormalised(const Matrix3& rotation) noexcept {
  const Vector3 long_z = Column(rotation, 2);
  const Vector3 z = Scale(long_z, 1.0 / Norm(long_z));
  const Vector3 x = Column(rotation, 0);
  const Vector3 across = Subtract(x, Scale(z, Dot(x, z)));
  const Vector3 unit_x = Scale(across, 1.0 / Norm(across));
  return FromColumns(unit_x, Cross(z, unit_x), z);
}

Matrix3 AxisRotation(const Vector3& axis, double angle_rad) noexcept {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  const auto [x, y, z] = axis;
  const double t = 1.0 - c;
  return {t * x * x + c,
          t * x * y - s * z,
          t * x * z + s * y,
          t * x * y + s * z,
          t * y * y + c,
          t * y * z - s * x,
          t * x * z - s * y,
          t * y * z + s * x,
          t * z * z + c};
}

Vector3 RotationVector(const Matrix3& rotation) noexcept {
  const Matrix3& r = rotation;
  const Vector3 twice_sine = {r[7] - r[5], r[2] - r[6], r[3] - r[1]};  // 2 sin(angle) · axis
  const double sine = 0.5 * Norm(twice_sine);
  const double cosine = 0.5 * (r[0] + r[4] + r[8] - 1.0);
  const double angle_rad = std::atan2(sine, cosine);
  if (cosine > -0.9) return Scale(twice_sine, sine > 0.0 ? 0.5 * angle_rad / sine : 0.5);
  // Near π the sine says little: R + Rᵀ = 2 cos · I + 2 (1 − cos) · axis · axisᵀ.
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (r[4 * i] > r[4 * largest]) largest = i;
  }
  Vector3 axis{};
  for (std::size_t i = 0; i < 3; ++i) {
    axis[i] = 0.5 * (r[3 * i + largest] + r[3 * largest + i]) - (i == largest ? cosine : 0.0);
  }
  if (Dot(axis, twice_sine) < 0.0) axis = Scale(axis, -1.0);
  return Scale(axis, angle_rad / Norm(axis));
}

}  // namespace handcraft::robot
