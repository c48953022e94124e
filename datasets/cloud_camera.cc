// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/cloud_camera.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Cholesky>

#include "lib/core/error.h"
#include "lib/core/fields.h"

namespace handcraft::datasets {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kFewestPoints = 10;
constexpr double kGreatestErrorPx = 2.0;
constexpr double kLeastSpread = 1e-6;  // a milliradian

// Normal equations of the least squares in (focal, centre_u, centre_v).
struct Sums {
  Matrix3d matrix = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  double squares = 0.0;
  int num_points = 0;

  void Add(const Vector3d& row, double pixel) {
    matrix += row * row.transpose();
    right += pixel * row;
    squares += pixel * pixel;
  }
};

Sums SumUp(const OrganisedCloud& cloud) {
  Sums sums;
  const Eigen::Isometry3d camera_from_base = cloud.base_from_camera.inverse().cast<double>();
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      if (!IsMeasured(cloud.At(u, v))) continue;
      const Vector3d p = camera_from_base * cloud.At(u, v).cast<double>();
      if (!(p.z() > 0.0)) continue;
      sums.Add({p.x() / p.z(), 1.0, 0.0}, u);
      sums.Add({p.y() / p.z(), 0.0, 1.0}, v);
      ++sums.num_points;
    }
  }
  return sums;
}

// Variance of x / z and y / z: what is left of the focal length's entry when both centres are
// eliminated.
double Spread(const Sums& sums) {
  const Matrix3d& m = sums.matrix;
  const double left = m(0, 0) - m(0, 1) * m(0, 1) / m(1, 1) - m(0, 2) * m(0, 2) / m(2, 2);
  return left / (2.0 * sums.num_points);
}

[[noreturn]] void Fail(std::string reason) { throw Error({.reason = std::move(reason)}); }

}  // namespace

synthetic::PinholeCamera FitCamera(const OrganisedCloud& cloud) {
  const Sums sums = SumUp(cloud);
  if (sums.num_points < kFewestPoints) {
    Fail("the cloud has " + std::to_string(sums.num_points) +
         " points in front of its camera; at least 10 are due");
  }
  if (Spread(sums) < kLeastSpread) Fail("the cloud's points lie in one direction from its camera");
  const Vector3d fitted = sums.matrix.ldlt().solve(sums.right);
  const double squares = sums.squares - fitted.dot(sums.right);
  const double error_px = std::sqrt(std::max(squares, 0.0) / (2.0 * sums.num_points));
  if (!(error_px <= kGreatestErrorPx) || !(fitted[0] > 0.0)) {
    Fail("the cloud's points are " + NumberToText(std::round(10.0 * error_px) / 10.0) +
         " pixels from where a pinhole camera sees them");
  }
  return {.width_px = cloud.width,
          .height_px = cloud.height,
          .focal_px = static_cast<float>(fitted[0]),
          .centre_u_px = static_cast<float>(fitted[1]),
          .centre_v_px = static_cast<float>(fitted[2]),
          .base_from_camera = cloud.base_from_camera};
}

}  // namespace handcraft::datasets
