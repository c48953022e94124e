// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_plane.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "lib/features/mask_pixels.h"
#include "lib/features/small_eigen.h"

namespace handcraft::features {
namespace {

constexpr int kNumClippings = 3;
constexpr double kClippingDeviations = 3.0;
constexpr std::size_t kLanes = 4;  // sums that are independent of each other

// The measured points of an object, axis after axis.
struct Points {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  std::size_t size = 0;
};

Points Gather(const ObjectCloud& cloud, std::span<float> scratch) noexcept {
  const std::size_t capacity = scratch.size() / 3;
  float* x = scratch.data();
  float* y = x + capacity;
  float* z = y + capacity;
  std::size_t size = 0;
  ForEachMaskRun(MaskOf(cloud), cloud.width, cloud.height, [&](int v, int first_u, int last_u) {
    for (int u = first_u; u < last_u; ++u) {
      const float* p = cloud.Point(u, v);
      x[size] = p[0];
      y[size] = p[1];
      z[size] = p[2];
      size += ObjectCloud::IsMeasured(p) ? 1 : 0;
    }
  });
  return {x, y, z, size};
}

// What counts: |p − centre| ≤ reach along each axis, both about the first point.
struct Box {
  Vector3 centre_m = {0.0, 0.0, 0.0};
  Vector3 reach_m = {std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity()};
};

// Count, mean and covariance of the points in a box, about the first point.
struct Spread {
  double count = 0.0;
  Vector3 mean_m = {};
  std::array<double, 6> covariance = {};  // xx, xy, xz, yy, yz, zz
};

// Sums over the points in a box, about the first point: 1, x, y, z, xx, xy, xz, yy, yz, zz.
std::array<double, 10> MomentsOf(const Points& points, const Box& box) noexcept {
  const double x0 = points.x[0];
  const double y0 = points.y[0];
  const double z0 = points.z[0];
  double sums[10][kLanes] = {};
  for (std::size_t i = 0; i < points.size; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t at = i + lane < points.size ? i + lane : 0;
      const double x = double{points.x[at]} - x0;
      const double y = double{points.y[at]} - y0;
      const double z = double{points.z[at]} - z0;
      const auto within = [&box](double value, std::size_t axis) {
        return std::fabs(value - box.centre_m[axis]) <= box.reach_m[axis] ? 1.0 : 0.0;
      };
      const double w =  // without a branch
          (i + lane < points.size ? 1.0 : 0.0) * within(x, 0) * within(y, 1) * within(z, 2);
      sums[0][lane] += w;
      sums[1][lane] += w * x;
      sums[2][lane] += w * y;
      sums[3][lane] += w * z;
      sums[4][lane] += w * x * x;
      sums[5][lane] += w * x * y;
      sums[6][lane] += w * x * z;
      sums[7][lane] += w * y * y;
      sums[8][lane] += w * y * z;
      sums[9][lane] += w * z * z;
    }
  }
  std::array<double, 10> total;
  for (std::size_t k = 0; k < total.size(); ++k) {
    total[k] = (sums[k][0] + sums[k][2]) + (sums[k][1] + sums[k][3]);
  }
  return total;
}

Spread SpreadOf(const Points& points, const Box& box) noexcept {
  const std::array<double, 10> total = MomentsOf(points, box);
  Spread spread{.count = total[0], .mean_m = {}, .covariance = {}};
  if (spread.count == 0.0) return spread;
  const Vector3 mean = {total[1] / total[0], total[2] / total[0], total[3] / total[0]};
  spread.mean_m = mean;
  spread.covariance = {total[4] / total[0] - mean[0] * mean[0],
                       total[5] / total[0] - mean[0] * mean[1],
                       total[6] / total[0] - mean[0] * mean[2],
                       total[7] / total[0] - mean[1] * mean[1],
                       total[8] / total[0] - mean[1] * mean[2],
                       total[9] / total[0] - mean[2] * mean[2]};
  return spread;
}

Box BoxAround(const Spread& spread) noexcept {
  const auto reach = [](double variance) {
    return kClippingDeviations * std::sqrt(variance > 0.0 ? variance : 0.0);
  };
  return {
      .centre_m = spread.mean_m,
      .reach_m = {
          reach(spread.covariance[0]), reach(spread.covariance[3]), reach(spread.covariance[5])}};
}

// The points' spread without those far from the others.
Spread ClippedSpread(const Points& points) noexcept {
  Spread spread = SpreadOf(points, Box{});
  for (int round = 0; round < kNumClippings; ++round) {
    const Spread clipped = SpreadOf(points, BoxAround(spread));
    if (clipped.count < 3.0) return spread;
    const bool is_same = clipped.count == spread.count;
    spread = clipped;
    if (is_same) break;
  }
  return spread;
}

CloudFault FaultOf(const SmallEigen<3>& eigen) noexcept {
  constexpr double kLeastSpread = 1e-8;      // of variances: 1e-4 of lengths, squared
  constexpr double kLeastDifference = 1e-6;  // of variances
  const auto& [thickness, width, length] = eigen.values;
  if (!(width > kLeastSpread * length)) return CloudFault::kOnALine;
  if (!(width - thickness > kLeastDifference * length)) return CloudFault::kNoSinglePlane;
  return CloudFault::kNone;
}

}  // namespace

std::string_view NameOf(CloudFault fault) noexcept {
  switch (fault) {
    case CloudFault::kNone:
      return "is sound";
    case CloudFault::kTooFewPoints:
      return "has fewer than three measured points";
    case CloudFault::kOnALine:
      return "has its points on one line";
    case CloudFault::kNoSinglePlane:
      return "is as thick as it is wide, so that no one plane fits it best";
    case CloudFault::kEmptyHalf:
      return "has a mask of one column, which has no left and right half";
  }
  return "";
}

ObjectPlane FitObjectPlane(const ObjectCloud& cloud, std::span<float> scratch) noexcept {
  const Points points = Gather(cloud, scratch);
  if (points.size < kMinObjectPoints) return {};
  const Spread spread = ClippedSpread(points);
  const auto& [xx, xy, xz, yy, yz, zz] = spread.covariance;
  const SmallEigen<3> eigen = EigenOfSymmetric<3>({xx, xy, xz, xy, yy, yz, xz, yz, zz});
  return {.fault = FaultOf(eigen),
          .normal = eigen.vectors[0],
          .mean_m = {spread.mean_m[0] + double{points.x[0]},
                     spread.mean_m[1] + double{points.y[0]},
                     spread.mean_m[2] + double{points.z[0]}},
          .num_points = static_cast<std::size_t>(spread.count)};
}

}  // namespace handcraft::features
