// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cell_normals.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace handcraft::features {
namespace {

constexpr int kSide = 9;

// Sums of two points in each cell, which z(x, y) bends; x and y of cell (r, c) are c and r.
template <class Depth>
std::vector<CellSum> Bent(Depth&& depth) {
  std::vector<CellSum> sums;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double x = 0.25 * column;
      const double y = 0.25 * row;
      sums.push_back({2.0 * x, 2.0 * y, 2.0 * depth(x, y), 2.0});
    }
  }
  return sums;
}

std::vector<SurfacePoint> Surface(std::vector<CellSum> sums,
                                  const Vector3& mean = {},
                                  const Vector3& viewpoint = {}) {
  std::vector<SurfacePoint> surface(sums.size());
  surface.resize(FindCellNormals(sums, kSide, mean, viewpoint, surface));
  return surface;
}

void ExpectNear(const Vector3& a, const Vector3& b, double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

TEST(FindCellNormals, OfAPlaneAreItsOwnInEveryCell) {
  const auto plane = [](double x, double y) { return 4.0 + 0.5 * x - 0.25 * y; };
  const double length = std::sqrt(0.25 + 0.0625 + 1.0);
  const std::vector<SurfacePoint> surface = Surface(Bent(plane));
  ASSERT_EQ(surface.size(), std::size_t{kSide * kSide});
  for (const SurfacePoint& point : surface) {
    ExpectNear(point.normal, {0.5 / length, -0.25 / length, -1.0 / length}, 1e-12);
  }
  ExpectNear(surface[kSide + 2].point_m, {0.5, 0.25, 4.1875}, 1e-15);
}

TEST(FindCellNormals, LookTowardsTheViewpoint) {
  const auto plane = [](double /*x*/, double /*y*/) { return 4.0; };
  EXPECT_EQ(Surface(Bent(plane), {}, {0, 0, 0})[0].normal, (Vector3{0, 0, -1}));
  EXPECT_EQ(Surface(Bent(plane), {}, {0, 0, 9})[0].normal, (Vector3{0, 0, 1}));
}

TEST(FindCellNormals, OfABallPointAwayFromItsMiddle) {
  const Vector3 middle = {1.0, 1.0, 8.0};
  const auto ball = [&middle](double x, double y) {
    return middle[2] - std::sqrt(9.0 - (x - 1.0) * (x - 1.0) - (y - 1.0) * (y - 1.0));
  };
  const std::vector<SurfacePoint> surface = Surface(Bent(ball));
  for (const SurfacePoint& point : surface) {
    const Vector3 outwards = Subtract(point.point_m, middle);  // 3 long
    EXPECT_GT(Dot(point.normal, outwards), 3.0 * std::cos(0.15));
  }
  ExpectNear(surface[(kSide * kSide) / 2].normal, {0, 0, -1}, 1e-12);  // the window is symmetric
}

TEST(FindCellNormals, EmptyCellsAreLeftOutAndTakeNothingFromOthers) {
  const auto plane = [](double x, double y) { return 4.0 + 0.5 * x - 0.25 * y; };
  std::vector<CellSum> sums = Bent(plane);
  std::size_t num_left = sums.size();
  for (std::size_t i = 0; i < sums.size(); i += 3) {  // whole columns
    sums[i] = {};
    --num_left;
  }
  const std::vector<SurfacePoint> surface = Surface(sums);
  ASSERT_EQ(surface.size(), num_left);
  const Vector3 whole = Surface(Bent(plane))[0].normal;
  for (const SurfacePoint& point : surface) ExpectNear(point.normal, whole, 1e-12);
}

TEST(FindCellNormals, OfOneRowOfOnePlaceAndOfALineAreNone) {
  std::vector<CellSum> row(kSide * kSide);
  for (std::size_t c = 0; c < kSide; ++c) row[c] = {double(c), 0.5 * double(c * c), 4.0, 1.0};
  ASSERT_EQ(Surface(row).size(), std::size_t{kSide});
  for (const SurfacePoint& point : Surface(row)) EXPECT_EQ(point.normal, Vector3{});
  const std::vector<CellSum> place(kSide * kSide, CellSum{0.25, 0.5, 2.0, 1.0});
  for (const SurfacePoint& point : Surface(place)) EXPECT_EQ(point.normal, Vector3{});
  std::vector<CellSum> line(kSide * kSide);
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = {double(i), 0.0, 4.0, 1.0};
  for (const SurfacePoint& point : Surface(line)) EXPECT_EQ(point.normal, Vector3{});
}

TEST(FindCellNormals, MovingAndGrowingChangeNothing) {
  const auto bent = [](double x, double y) { return 4.0 + 0.5 * x * x - 0.25 * x * y; };
  const std::vector<SurfacePoint> before = Surface(Bent(bent), {1, 1, 4}, {-1, -1, -4});
  std::vector<CellSum> sums = Bent(bent);
  for (CellSum& sum : sums) {
    sum = {3.0 * sum.x + 2.0, 3.0 * sum.y, 3.0 * sum.z - 10.0, 2.0};  // p → 3 p + (1, 0, −5)
  }
  const std::vector<SurfacePoint> after = Surface(sums, {4, 3, 7}, {-3, -3, -12});
  for (std::size_t i = 0; i < before.size(); ++i) {
    ExpectNear(after[i].normal, before[i].normal, 1e-12);
  }
}

TEST(FindCellNormals, TurnWithTheObjectAboutTheLineOfSight) {
  const auto bent = [](double x, double y) { return 4.0 + 0.5 * x * x - 0.25 * x * y; };
  const std::vector<CellSum> sums = Bent(bent);
  std::vector<CellSum> turned(sums.size());
  for (std::size_t row = 0; row < kSide; ++row) {
    for (std::size_t column = 0; column < kSide; ++column) {
      const CellSum& sum = sums[row * kSide + column];
      turned[column * kSide + (kSide - 1 - row)] = {-sum.y, sum.x, sum.z, sum.count};
    }
  }
  const std::vector<SurfacePoint> before = Surface(sums);
  const std::vector<SurfacePoint> after = Surface(turned);
  for (std::size_t row = 0; row < kSide; ++row) {
    for (std::size_t column = 0; column < kSide; ++column) {
      const Vector3& normal = before[row * kSide + column].normal;
      ExpectNear(after[column * kSide + (kSide - 1 - row)].normal,
                 {-normal[1], normal[0], normal[2]},
                 1e-12);
    }
  }
}

}  // namespace
}  // namespace handcraft::features
