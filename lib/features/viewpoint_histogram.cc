// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/viewpoint_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace handcraft::features {
namespace {

bool HasNormal(const SurfacePoint& point) noexcept { return point.normal != Vector3{}; }

// Of the points with a normal.
struct Middle {
  std::size_t count = 0;
  Vector3 centroid_m = {};
  Vector3 normal = {};  // the mean
  double radius_m = 0.0;
};

Middle MiddleOf(std::span<const SurfacePoint> surface) noexcept {
  Middle middle;
  for (const SurfacePoint& point : surface) {
    if (!HasNormal(point)) continue;
    ++middle.count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middle.centroid_m[axis] += point.point_m[axis];
      middle.normal[axis] += point.normal[axis];
    }
  }
  if (middle.count == 0) return middle;
  const double share = 1.0 / static_cast<double>(middle.count);
  for (double& value : middle.centroid_m) value *= share;
  for (double& value : middle.normal) value *= share;
  double squared = 0.0;
  for (const SurfacePoint& point : surface) {
    if (!HasNormal(point)) continue;
    const Vector3 d = Subtract(point.point_m, middle.centroid_m);
    squared = std::max(squared, Dot(d, d));
  }
  middle.radius_m = std::sqrt(squared);
  return middle;
}

// Where `share` of a range of so many bins lies.
std::size_t BinOf(double share, std::size_t num_bins) noexcept {
  const double bin = std::floor(share * static_cast<double>(num_bins));
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(num_bins - 1)));
}

// α, β and φ; nothing is written where the frame is not defined.
bool PairAngles(const Middle& middle,
                const SurfacePoint& point,
                double distance_m,
                std::array<double, 3>& angles) noexcept {
  Vector3 d = Subtract(point.point_m, middle.centroid_m);
  const double at_centroid = Dot(middle.normal, d) / distance_m;
  const double at_point = Dot(point.normal, d) / distance_m;
  const bool swapped = std::fabs(at_centroid) < std::fabs(at_point);
  if (swapped) d = {-d[0], -d[1], -d[2]};
  const Vector3& u = swapped ? point.normal : middle.normal;
  const Vector3& other = swapped ? middle.normal : point.normal;
  Vector3 v = Cross(d, u);
  const double length = std::sqrt(Dot(v, v));
  if (!(length > 0.0)) return false;
  for (double& value : v) value /= length;
  angles = {std::atan2(Dot(Cross(u, v), other), Dot(u, other)),
            Dot(v, other),
            swapped ? -at_point : at_centroid};
  return true;
}

}  // namespace

void DescribeByViewpointHistogram(std::span<const SurfacePoint> surface,
                                  const Vector3& viewpoint_m,
                                  std::span<float, kViewpointHistogramSize> histogram) noexcept {
  std::fill(histogram.begin(), histogram.end(), 0.0F);
  const Middle middle = MiddleOf(surface);
  const Vector3 sight = Subtract(viewpoint_m, middle.centroid_m);
  const double sight_m = std::sqrt(Dot(sight, sight));
  std::array<std::uint32_t, kViewpointHistogramSize> counts = {};
  for (const SurfacePoint& point : surface) {
    if (!HasNormal(point)) continue;
    const double cosine = sight_m > 0.0 ? Dot(point.normal, sight) / sight_m : 0.0;
    ++counts[4 * kPairBins + BinOf(0.5 * (cosine + 1.0), kViewpointBins)];
    const Vector3 d = Subtract(point.point_m, middle.centroid_m);
    const double distance_m = std::sqrt(Dot(d, d));
    std::array<double, 3> angles = {};
    if (!(distance_m > 0.0) || !PairAngles(middle, point, distance_m, angles)) continue;
    for (std::size_t k = 0; k < angles.size(); ++k) {
      constexpr double kTurn = 2.0 * std::numbers::pi;
      ++counts[k * kPairBins + BinOf((angles[k] + std::numbers::pi) / kTurn, kPairBins)];
    }
    ++counts[3 * kPairBins + BinOf(distance_m / middle.radius_m, kPairBins)];
  }
  if (middle.count == 0) return;
  const double share = 100.0 / static_cast<double>(middle.count);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    histogram[i] = static_cast<float>(share * counts[i]);
  }
}

}  // namespace handcraft::features
