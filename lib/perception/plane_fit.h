// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Core>

namespace handcraft::perception {

/// The plane normal · p = offset_m; the normal has length 1.
struct Plane {
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
  float offset_m = 0.0F;

  /// Distance of a point [m], positive on the side the normal points to.
  [[nodiscard]] float Distance(const Eigen::Vector3f& point) const {
    return normal.dot(point) - offset_m;
  }
  /// The same plane with the normal on the side of `up`.
  [[nodiscard]] Plane TurnedTo(const Eigen::Vector3f& up) const;
};

/// Orthogonal distance regression: the plane that minimises Σ (n · p_i − d)², |n| = 1. It goes
/// through the points' mean, and n is the eigenvector of the least eigenvalue of their covariance,
/// in double precision. Sums are kept about the first point, so that clouds far from the origin
/// lose nothing. No allocation.
/// Source: dissertation section 3.2.2; C. Shakarji, "Least-squares fitting algorithms of the NIST
/// algorithm testing system", 1998, section 3.
class PlaneFit {
 public:
  void Add(const Eigen::Vector3f& point);

  [[nodiscard]] std::size_t count() const noexcept { return count_; }

  /// Nothing for fewer than three points, and where they lie on one line (to 10⁻⁴ of their
  /// spread) or in one place, or are not finite: no plane is the best.
  [[nodiscard]] std::optional<Plane> Solve() const;

 private:
  Eigen::Vector3f first_ = Eigen::Vector3f::Zero();
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
  std::size_t count_ = 0;
};

}  // namespace handcraft::perception
