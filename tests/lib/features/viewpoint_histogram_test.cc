// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/viewpoint_histogram.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/reference_numbers.h"
#include "tests/lib/features/some_surface.h"

namespace handcraft::features {
namespace {

using testing::SomeSurface;

const Vector3 kViewpoint = {double{0.1F}, double{-0.2F}, -1.0};

std::vector<float> Describe(const std::vector<SurfacePoint>& surface,
                            const Vector3& viewpoint = kViewpoint) {
  std::vector<float> histogram(kViewpointHistogramSize, 9.0F);
  DescribeByViewpointHistogram(
      surface, viewpoint, std::span<float, kViewpointHistogramSize>(histogram));
  return histogram;
}

double Sum(const std::vector<float>& histogram) {
  return std::accumulate(histogram.begin(), histogram.end(), 0.0);
}

double Distance(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(double{a[i]} - double{b[i]});
  return sum;
}

std::vector<SurfacePoint> Changed(const std::function<void(SurfacePoint&)>& change) {
  std::vector<SurfacePoint> surface = SomeSurface();
  for (SurfacePoint& point : surface) change(point);
  return surface;
}

TEST(ViewpointHistogram, IsThatOfThePointCloudLibrary) {
  std::vector<double> expected = testing::ReferenceNumbers("vfh.txt");
  ASSERT_EQ(expected.size(), kViewpointHistogramSize);
  const auto n = static_cast<double>(SomeSurface().size());
  for (std::size_t i = 0; i < 4 * kPairBins; ++i) expected[i] *= (n - 1.0) / n;
  const std::vector<float> histogram = Describe(SomeSurface());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(double{histogram[i]}, expected[i], 1e-4) << i;
  }
}

// Centroid 0, u = (0, 0, −1), v = (0, ±1, 0): all angles 0, both points as far as any.
TEST(ViewpointHistogram, TwoPointsByHand) {
  const std::vector<SurfacePoint> surface = {{{1, 0, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, 0, -1}}};
  const std::vector<float> histogram = Describe(surface, {0, 0, -5});
  for (const std::size_t bin : {22U, 45U + 22U, 90U + 22U, 135U + 44U, 180U + 127U}) {
    EXPECT_EQ(histogram[bin], 100.0F);
  }
  EXPECT_EQ(Sum(histogram), 500.0);
  EXPECT_EQ(Describe(surface, {0, 0, 5})[180], 100.0F);
  EXPECT_EQ(Describe(surface, {5, 0, 0})[180 + 64], 100.0F);
  EXPECT_EQ(Describe(surface, {0, 0, 0})[180 + 64], 100.0F);  // at the centroid: no direction
}

TEST(ViewpointHistogram, EachOfFiveHistogramsAddsUpToAHundred) {
  const std::vector<float> histogram = Describe(SomeSurface());
  for (const std::size_t begin : {0U, 45U, 90U, 135U}) {
    EXPECT_NEAR(Sum({&histogram[begin], &histogram[begin] + 45}), 100.0, 1e-4);
  }
  EXPECT_NEAR(Sum({&histogram[180], &histogram[180] + 128}), 100.0, 1e-4);
}

TEST(ViewpointHistogram, MovingPointsAndViewpointChangesNothing) {
  const std::vector<SurfacePoint> moved = Changed([](SurfacePoint& point) {
    for (double& value : point.point_m) value += 3.0;
  });
  const Vector3 viewpoint = {kViewpoint[0] + 3.0, kViewpoint[1] + 3.0, kViewpoint[2] + 3.0};
  EXPECT_LT(Distance(Describe(moved, viewpoint), Describe(SomeSurface())), 1.0);
}

TEST(ViewpointHistogram, GrowingAboutTheViewpointChangesNothing) {
  const std::vector<SurfacePoint> grown = Changed([](SurfacePoint& point) {
    for (double& value : point.point_m) value *= 4.0;
  });
  const Vector3 viewpoint = {4.0 * kViewpoint[0], 4.0 * kViewpoint[1], 4.0 * kViewpoint[2]};
  EXPECT_EQ(Describe(grown, viewpoint), Describe(SomeSurface()));
}

TEST(ViewpointHistogram, TurningAboutTheLineOfSightChangesNothing) {
  const std::vector<SurfacePoint> turned = Changed([](SurfacePoint& point) {
    point = {{0.6 * point.point_m[0] - 0.8 * point.point_m[1],
              0.8 * point.point_m[0] + 0.6 * point.point_m[1],
              point.point_m[2]},
             {0.6 * point.normal[0] - 0.8 * point.normal[1],
              0.8 * point.normal[0] + 0.6 * point.normal[1],
              point.normal[2]}};
  });
  const Vector3 ahead = {0, 0, -1};
  EXPECT_LT(Distance(Describe(turned, ahead), Describe(SomeSurface(), ahead)), 1.0);
}

TEST(ViewpointHistogram, AnotherViewpointChangesTheLastHistogramAlone) {
  const std::vector<float> one = Describe(SomeSurface());
  const std::vector<float> other = Describe(SomeSurface(), {2, 0, -1});
  EXPECT_TRUE(std::equal(one.begin(), one.begin() + 180, other.begin()));
  EXPECT_GT(Distance(one, other), 20.0);
}

TEST(ViewpointHistogram, PointsWithoutNormalDoNotCount) {
  std::vector<SurfacePoint> surface = SomeSurface();
  const std::vector<float> expected = Describe(surface);
  surface.insert(surface.begin() + 7, SurfacePoint{{9, 9, 9}, {}});
  surface.push_back(SurfacePoint{{-9, 0, 1}, {}});
  EXPECT_EQ(Describe(surface), expected);
}

TEST(ViewpointHistogram, WithoutPointsOrWithAllInOnePlace) {
  EXPECT_EQ(Sum(Describe({})), 0.0);
  EXPECT_EQ(Sum(Describe({{{1, 2, 3}, {}}})), 0.0);
  const std::vector<float> one = Describe({{{1, 2, 3}, {0, 0, 1}}});
  EXPECT_EQ(Sum(one), 100.0);
  EXPECT_EQ(Sum({one.begin(), one.begin() + 180}), 0.0);
}

}  // namespace
}  // namespace handcraft::features
