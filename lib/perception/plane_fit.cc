// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/plane_fit.h"

#include <array>

#include "lib/features/small_eigen.h"

namespace handcraft::perception {

Plane Plane::TurnedTo(const Eigen::Vector3f& up) const {
  return normal.dot(up) < 0.0F ? Plane{-normal, -offset_m} : *this;
}

void PlaneFit::Add(const Eigen::Vector3f& point) {
  if (count_ == 0) first_ = point;
  const Eigen::Vector3d p = (point - first_).cast<double>();
  sum_ += p;
  products_.noalias() += p * p.transpose();
  ++count_;
}

std::optional<Plane> PlaneFit::Solve() const {
  constexpr double kLeastSpread = 1e-8;  // of variances: 10⁻⁴ of lengths, squared
  if (count_ < 3) return std::nullopt;
  const auto count = static_cast<double>(count_);
  const Eigen::Vector3d mean = sum_ / count;
  const Eigen::Matrix3d covariance = products_ / count - mean * mean.transpose();
  if (!covariance.allFinite()) return std::nullopt;
  std::array<double, 9> entries;
  Eigen::Map<Eigen::Matrix3d>(entries.data()) = covariance;
  const features::SmallEigen<3> eigen = features::EigenOfSymmetric<3>(entries);
  if (!(eigen.values[1] > kLeastSpread * eigen.values[2])) return std::nullopt;
  const Eigen::Vector3d normal(eigen.vectors[0].data());
  return Plane{normal.cast<float>(), static_cast<float>(normal.dot(mean + first_.cast<double>()))};
}

}  // namespace handcraft::perception
