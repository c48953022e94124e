// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/mask_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "lib/features/mask_pixels.h"

namespace handcraft::features {
namespace {

// Σ u^k of the integers below n, as polynomials of n, which hold for negative n too: the sum over
// first … last − 1 is the difference of two.
struct PowerSums {
  double s0 = 0.0;
  double s1 = 0.0;
  double s2 = 0.0;
  double s3 = 0.0;
};

PowerSums Below(double n) noexcept {
  const double s1 = n * (n - 1.0) / 2.0;
  return {n, s1, s1 * (2.0 * n - 1.0) / 3.0, s1 * s1};
}

PowerSums SumOver(double first, double last) noexcept {
  const PowerSums a = Below(first);
  const PowerSums b = Below(last);
  return {b.s0 - a.s0, b.s1 - a.s1, b.s2 - a.s2, b.s3 - a.s3};
}

// Σ x^i y^j of a region, i + j ≤ 3.
struct RawMoments {
  double m00 = 0.0;
  double m10 = 0.0;
  double m01 = 0.0;
  double m20 = 0.0;
  double m11 = 0.0;
  double m02 = 0.0;
  double m30 = 0.0;
  double m21 = 0.0;
  double m12 = 0.0;
  double m03 = 0.0;

  void AddRun(double y, double first, double last) noexcept {
    const PowerSums x = SumOver(first, last);
    m00 += x.s0;
    m10 += x.s1;
    m01 += y * x.s0;
    m20 += x.s2;
    m11 += y * x.s1;
    m02 += y * y * x.s0;
    m30 += x.s3;
    m21 += y * x.s2;
    m12 += y * y * x.s1;
    m03 += y * y * y * x.s0;
  }
};

void Normalise(const RawMoments& raw, std::span<double, kMomentsPerHalf> out) noexcept {
  const double area = raw.m00;
  const double x = raw.m10 / area;
  const double y = raw.m01 / area;
  const double mu11 = raw.m11 - x * raw.m01;
  const double mu20 = raw.m20 - x * raw.m10;
  const double mu02 = raw.m02 - y * raw.m01;
  const double mu30 = raw.m30 - 3.0 * x * raw.m20 + 2.0 * x * x * raw.m10;
  const double mu21 = raw.m21 - 2.0 * x * raw.m11 - y * raw.m20 + 2.0 * x * x * raw.m01;
  const double mu12 = raw.m12 - 2.0 * y * raw.m11 - x * raw.m02 + 2.0 * y * y * raw.m10;
  const double mu03 = raw.m03 - 3.0 * y * raw.m02 + 2.0 * y * y * raw.m01;
  const double second = area * area;
  const double third = second * std::sqrt(area);
  const std::array<double, kMomentsPerHalf> moments = {area,
                                                       mu11 / second,
                                                       mu20 / second,
                                                       mu02 / second,
                                                       mu30 / third,
                                                       mu21 / third,
                                                       mu12 / third,
                                                       mu03 / third};
  std::copy(moments.begin(), moments.end(), out.begin());
}

}  // namespace

bool MomentsOfHalves(const PixelMask& mask,
                     int width,
                     int height,
                     HalvesMoments& moments) noexcept {
  std::int64_t area = 0;
  double sum_u = 0.0;
  double sum_v = 0.0;
  ForEachMaskRun(mask, width, height, [&](int v, int first_u, int last_u) {
    const int length = last_u - first_u;
    area += length;
    sum_u += 0.5 * static_cast<double>(length) * (first_u + last_u - 1);
    sum_v += static_cast<double>(length) * v;
  });
  if (area == 0) return false;
  // About a pixel near the middle, so that little is lost when means are taken off.
  const double centroid_u = sum_u / static_cast<double>(area);
  const int first_right_u = static_cast<int>(std::ceil(centroid_u));
  const int origin_v = static_cast<int>(sum_v / static_cast<double>(area));
  RawMoments left;
  RawMoments right;
  ForEachMaskRun(mask, width, height, [&](int v, int first_u, int last_u) {
    const int middle_u = std::clamp(first_right_u, first_u, last_u);
    const double y = v - origin_v;
    left.AddRun(y, first_u - first_right_u, middle_u - first_right_u);
    right.AddRun(y, middle_u - first_right_u, last_u - first_right_u);
  });
  if (left.m00 == 0.0 || right.m00 == 0.0) return false;
  Normalise(left, std::span(moments).first<kMomentsPerHalf>());
  Normalise(right, std::span(moments).last<kMomentsPerHalf>());
  return true;
}

}  // namespace handcraft::features
