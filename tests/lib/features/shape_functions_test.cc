// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/shape_functions.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/reference_numbers.h"
#include "tests/lib/features/some_surface.h"

namespace handcraft::features {
namespace {

std::vector<Vector3> SomePoints() {
  std::vector<Vector3> points;
  for (const SurfacePoint& point : testing::SomeSurface()) points.push_back(point.point_m);
  return points;
}

std::vector<float> Describe(const std::vector<Vector3>& points) {
  std::vector<std::byte> workspace(ShapeFunctionsWorkspace(points.size()), std::byte{0xA5});
  std::vector<float> histogram(kShapeFunctionsSize, 9.0F);
  DescribeByShapeFunctions(points, workspace, std::span<float, kShapeFunctionsSize>(histogram));
  return histogram;
}

double Distance(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(double{a[i]} - double{b[i]});
  return sum;
}

double Sum(const std::vector<float>& histogram) {
  return std::accumulate(histogram.begin(), histogram.end(), 0.0);
}

TEST(ShapeFunctions, AreThoseOfThePointCloudLibraryWithTheSameDraws) {
  const std::vector<double> expected = testing::ReferenceNumbers("esf.txt");
  ASSERT_EQ(expected.size(), kShapeFunctionsSize);
  const std::vector<float> histogram = Describe(SomePoints());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(double{histogram[i]}, expected[i], 1e-6) << i;
  }
}

// Every triangle has the same three sides, whose voxels, far apart, are mostly empty.
TEST(ShapeFunctions, ATriangleOfThreeFourFiveByHand) {
  const std::vector<float> histogram = Describe({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}});
  const auto is_angle = [](std::size_t bin) { return bin == 26 || bin == 37 || bin == 63; };
  const auto is_side = [](std::size_t bin) { return bin == 38 || bin == 50 || bin == 63; };
  for (std::size_t i = 0; i < 9 * kShapeBins; ++i) {
    const std::size_t kind = i / kShapeBins;
    const std::size_t bin = i % kShapeBins;
    const bool is_hit = kind == 1   ? is_angle(bin)               // A3, out
                        : kind == 4 ? bin == 63                   // D3, out
                                    : kind == 7 && is_side(bin);  // D2, out
    EXPECT_EQ(histogram[i] > 0.0F, is_hit) << i;
  }
  EXPECT_FLOAT_EQ(histogram[7 * 64 + 38], histogram[7 * 64 + 63]);
  EXPECT_FLOAT_EQ(histogram[7 * 64 + 38] / 2.0F, histogram[4 * 64 + 63] * 2.0F);
}

TEST(ShapeFunctions, OfAFullDiscAreInAndOfTwoBallsMixed) {
  std::vector<Vector3> disc;
  std::vector<Vector3> balls;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 60; ++k) {
      const double x = i - 29.5;
      const double y = k - 29.5;
      if (x * x + y * y < 900.0) disc.push_back({x, y, 0.0});
      if (x * x + y * y < 100.0) balls.push_back({x, y, i % 2 == 0 ? 0.0 : 100.0});
    }
  }
  const std::vector<float> full = Describe(disc);
  const std::vector<float> apart = Describe(balls);
  const auto share = [](const std::vector<float>& h, std::size_t kind) {
    return Sum({h.begin() + static_cast<std::ptrdiff_t>(kind * 64),
                h.begin() + static_cast<std::ptrdiff_t>(kind * 64 + 64)});
  };
  EXPECT_GT(share(full, 0), 0.9 * (share(full, 0) + share(full, 1) + share(full, 2)));
  EXPECT_LT(share(apart, 0), 0.5 * (share(apart, 0) + share(apart, 1) + share(apart, 2)));
}

TEST(ShapeFunctions, AddUpToOne) { EXPECT_NEAR(Sum(Describe(SomePoints())), 1.0, 1e-5); }

TEST(ShapeFunctions, MovingThePointsChangesNothingButRounding) {
  std::vector<Vector3> moved = SomePoints();
  for (Vector3& point : moved) point = {point[0] + 3.0, point[1] - 5.0, point[2] + 1.0};
  EXPECT_LT(Distance(Describe(moved), Describe(SomePoints())), 0.01);
}

TEST(ShapeFunctions, GrowingChangesNothing) {
  std::vector<Vector3> grown = SomePoints();
  for (Vector3& point : grown) {
    for (double& value : point) value *= 0.125;
  }
  EXPECT_EQ(Describe(grown), Describe(SomePoints()));
}

// Voxels turn into voxels.
TEST(ShapeFunctions, QuarterTurnsAndReflectionsChangeNothingButRounding) {
  std::vector<Vector3> turned = SomePoints();
  for (Vector3& point : turned) point = {-point[1], point[0], point[2]};
  EXPECT_LT(Distance(Describe(turned), Describe(SomePoints())), 0.01);
  for (Vector3& point : turned) point = {point[2], point[1], -point[0]};
  EXPECT_LT(Distance(Describe(turned), Describe(SomePoints())), 0.01);
}

TEST(ShapeFunctions, WithoutATriangleAreZero) {
  std::vector<Vector3> line;
  line.reserve(50);
  for (int i = 0; i < 50; ++i) line.push_back({0.1 * i, 0.2 * i, 0.0});
  EXPECT_EQ(Sum(Describe(line)), 0.0);
  EXPECT_EQ(Sum(Describe(std::vector<Vector3>(50, Vector3{1, 2, 3}))), 0.0);
  EXPECT_EQ(Sum(Describe({{0, 0, 0}, {1, 0, 0}})), 0.0);
  EXPECT_EQ(Sum(Describe({})), 0.0);
}

TEST(ShapeFunctions, TakeHugeAndTinyCoordinates) {
  for (const double scale : {1e-12, 1e6}) {
    std::vector<Vector3> points = SomePoints();
    for (Vector3& point : points) {
      for (double& value : point) value *= scale;
    }
    for (const float value : Describe(points)) ASSERT_TRUE(std::isfinite(value));
    EXPECT_LT(Distance(Describe(points), Describe(SomePoints())), 0.01);
  }
}

}  // namespace
}  // namespace handcraft::features
