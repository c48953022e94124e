// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/features/mask_pixels.h"

namespace handcraft::features {
namespace {

Vector3 NormalOf(const KnownViews& known, std::size_t view) noexcept {
  const double* n = known.normals.data() + 3 * view;
  return {n[0], n[1], n[2]};
}

// The moments with each half's area over the whole area: nothing has a unit.
HalvesMoments WithShares(const double* moments) noexcept {
  HalvesMoments shares;
  std::copy_n(moments, kNumMoments, shares.begin());
  const double area = moments[0] + moments[kMomentsPerHalf];
  shares[0] /= area;
  shares[kMomentsPerHalf] /= area;
  return shares;
}

double Square(double x) noexcept { return x * x; }

// Mean square of the differences: the root of Eq. 4.5 does not change which is least.
double Difference(const double* a, const double* b, const KnownViews& known, ComparedMoments rule) {
  if (rule == ComparedMoments::kAll) {
    const HalvesMoments x = WithShares(a);
    const HalvesMoments y = WithShares(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < kNumMoments; ++i) sum += Square((x[i] - y[i]) / known.scales[i]);
    return sum / static_cast<double>(kNumMoments);
  }
  const bool printed = rule == ComparedMoments::kPrinted;
  const double area_a = printed ? 1.0 : a[0] + a[kMomentsPerHalf];
  const double area_b = printed ? 1.0 : b[0] + b[kMomentsPerHalf];
  double sum = 0.0;
  for (const std::size_t half : {std::size_t{0}, kMomentsPerHalf}) {
    sum += Square(a[half] / area_a - b[half] / area_b);
    const double a11 = a[half + 1] * (printed ? Square(a[half]) : 1.0);  // μ11 = η11 μ00²
    const double b11 = b[half + 1] * (printed ? Square(b[half]) : 1.0);
    sum += Square(a11 - b11);
  }
  return sum / 4.0;
}

// The largest angle that a candidate has: all views up to it are looked at, of equal ones the
// first.
struct Limit {
  double angle_rad = std::numeric_limits<double>::infinity();
  std::size_t view = std::numeric_limits<std::size_t>::max();
};

Limit CandidateLimit(const Vector3& normal, const KnownViews& known, std::size_t num_candidates) {
  if (num_candidates == 0 || num_candidates >= known.size()) return {};
  std::array<Limit, kMaxCandidates> nearest;
  const std::size_t capacity = std::min(num_candidates, kMaxCandidates);
  std::size_t count = 0;
  for (std::size_t view = 0; view < known.size(); ++view) {
    const Limit found{AngleBetweenLines(normal, NormalOf(known, view)), view};
    std::size_t at = count < capacity ? count++ : capacity;
    for (; at > 0 && found.angle_rad < nearest[at - 1].angle_rad; --at) {
      if (at < capacity) nearest[at] = nearest[at - 1];
    }
    if (at < capacity) nearest[at] = found;
  }
  return nearest[capacity - 1];
}

}  // namespace

std::string_view NameOf(ComparedMoments moments) noexcept {
  switch (moments) {
    case ComparedMoments::kPrinted:
      return "printed";
    case ComparedMoments::kScaleFree:
      return "scale_free";
    case ComparedMoments::kAll:
      return "all";
  }
  return "";
}

CloudFault DescribeView(const ObjectCloud& cloud,
                        std::span<float> scratch,
                        ViewDescription& description) noexcept {
  const ObjectPlane plane = FitObjectPlane(cloud, scratch);
  if (plane.fault != CloudFault::kNone) return plane.fault;
  description.normal = plane.normal;
  description.mean_m = plane.mean_m;
  return MomentsOfHalves(MaskOf(cloud), cloud.width, cloud.height, description.moments)
             ? CloudFault::kNone
             : CloudFault::kEmptyHalf;
}

HalvesMoments MomentScales(std::span<const double> moments) noexcept {
  constexpr double kLeastScale = 1e-9;  // of numbers of the order of 1
  const std::size_t num_views = moments.size() / kNumMoments;
  HalvesMoments sum{};
  HalvesMoments scales{};
  for (std::size_t view = 0; view < num_views; ++view) {
    const HalvesMoments shares = WithShares(moments.data() + view * kNumMoments);
    for (std::size_t i = 0; i < kNumMoments; ++i) sum[i] += shares[i];
  }
  for (std::size_t view = 0; view < num_views; ++view) {
    const HalvesMoments shares = WithShares(moments.data() + view * kNumMoments);
    for (std::size_t i = 0; i < kNumMoments; ++i) {
      scales[i] += Square(shares[i] - sum[i] / static_cast<double>(num_views));
    }
  }
  for (double& scale : scales) {
    scale = std::sqrt(scale / static_cast<double>(num_views));
    if (!(scale > kLeastScale)) scale = 1.0;
  }
  return scales;
}

double AngleBetweenLines(const Vector3& a, const Vector3& b) noexcept {
  const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const double x = a[1] * b[2] - a[2] * b[1];
  const double y = a[2] * b[0] - a[0] * b[2];
  const double z = a[0] * b[1] - a[1] * b[0];
  return std::atan2(std::sqrt(x * x + y * y + z * z), std::fabs(dot));
}

std::size_t NearestView(const ViewDescription& view,
                        const KnownViews& known,
                        const RotationRule& rule) noexcept {
  const Limit limit = CandidateLimit(view.normal, known, rule.num_candidates);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double angle_rad = AngleBetweenLines(view.normal, NormalOf(known, i));
    if (angle_rad > limit.angle_rad || (angle_rad == limit.angle_rad && i > limit.view)) continue;
    const double cost =
        Difference(
            view.moments.data(), known.moments.data() + i * kNumMoments, known, rule.moments) +
        Square(rule.angle_weight * angle_rad);
    if (cost < least) {
      least = cost;
      best = i;
    }
  }
  return best;
}

}  // namespace handcraft::features
