// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <span>

namespace handcraft::features {

using Quaternion = std::array<double, 4>;  ///< x, y, z, w as in ROS messages, of length 1

/// The rotation that minimises Σ_i w_i ‖A(q_i) − A(q)‖² (Frobenius, A the rotation matrix): the
/// eigenvector of the largest eigenvalue of Σ_i w_i q_i q_iᵀ, so that q and −q are the same. The
/// real part is not negative. One rotation is its own mean, exactly. At least one, as many weights,
/// all positive. Does not allocate; thread-safe.
/// Source: Markley, Cheng, Crassidis, Oshman 2007, "Averaging quaternions", Eqs. (12), (13).
[[nodiscard]] Quaternion MeanRotation(std::span<const Quaternion> rotations,
                                      std::span<const double> weights) noexcept;

/// The rotation b, then a; with a real part that is not negative.
[[nodiscard]] Quaternion Product(const Quaternion& a, const Quaternion& b) noexcept;

/// The angle of the turn from one rotation to the other, in [0, π] [rad]; exact to rounding near 0
/// and π.
[[nodiscard]] double AngleBetween(const Quaternion& a, const Quaternion& b) noexcept;

/// The turn by an angle [rad] about z.
[[nodiscard]] Quaternion TurnAboutZ(double angle_rad) noexcept;

}  // namespace handcraft::features
