// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/rotation_mean.h"

#include <cmath>
#include <cstddef>

#include "lib/features/small_eigen.h"

namespace handcraft::features {
namespace {

Quaternion WithPositiveRealPart(const Quaternion& q) noexcept {
  return q[3] < 0.0 ? Quaternion{-q[0], -q[1], -q[2], -q[3]} : q;
}

}  // namespace

Quaternion MeanRotation(std::span<const Quaternion> rotations,
                        std::span<const double> weights) noexcept {
  if (rotations.size() == 1) return WithPositiveRealPart(rotations[0]);
  std::array<double, 16> sum{};
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    const Quaternion& q = rotations[k];
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) sum[4 * i + j] += weights[k] * q[i] * q[j];
    }
  }
  return WithPositiveRealPart(EigenOfSymmetric<4>(sum).vectors[3]);
}

Quaternion Product(const Quaternion& a, const Quaternion& b) noexcept {
  const auto& [ax, ay, az, aw] = a;
  const auto& [bx, by, bz, bw] = b;
  return WithPositiveRealPart({aw * bx + ax * bw + ay * bz - az * by,
                               aw * by - ax * bz + ay * bw + az * bx,
                               aw * bz + ax * by - ay * bx + az * bw,
                               aw * bw - ax * bx - ay * by - az * bz});
}

double AngleBetween(const Quaternion& a, const Quaternion& b) noexcept {
  const Quaternion turn = Product({-a[0], -a[1], -a[2], a[3]}, b);
  return 2.0 * std::atan2(std::hypot(turn[0], turn[1], turn[2]), turn[3]);
}

Quaternion TurnAboutZ(double angle_rad) noexcept {
  return {0.0, 0.0, std::sin(0.5 * angle_rad), std::cos(0.5 * angle_rad)};
}

}  // namespace handcraft::features
