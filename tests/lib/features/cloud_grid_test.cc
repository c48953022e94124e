// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cloud_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/some_object.h"

namespace handcraft::features {
namespace {

using testing::SomeObject;

std::vector<CellSum> Cells(const ObjectCloud& cloud, int side) {
  std::vector<CellSum> sums(static_cast<std::size_t>(side * side));
  static_cast<void>(SumCells(cloud, side, GridBox::kFitted, sums));
  return sums;
}

std::vector<CellSum> PolarCells(const ObjectCloud& cloud, int side) {
  std::vector<CellSum> sums(static_cast<std::size_t>(side * side));
  static_cast<void>(SumPolarCells(cloud, side, sums));
  return sums;
}

TEST(CloudGrid, FourPointsByHand) {
  // 4 × 2 pixels, grid of 2: pixels 0 and 1 of a row make the left cell.
  const std::vector<float> points = {1, 2, 3, 3, 4, 5, 10, 0, 0, 20, 0, 0,
                                     0, 0, 1, 0, 0, 2, 0,  7, 0, 0,  9, 0};
  const ObjectCloud cloud{.points = points.data(), .width = 4, .height = 2, .row_stride = 12};
  std::vector<CellSum> sums(4);
  EXPECT_EQ(SumCells(cloud, 2, GridBox::kFitted, sums), 8U);
  EXPECT_EQ(sums[0].x, 4.0);
  EXPECT_EQ(sums[0].y, 6.0);
  EXPECT_EQ(sums[0].z, 8.0);
  EXPECT_EQ(sums[1].x, 30.0);
  EXPECT_EQ(sums[2].z, 3.0);
  EXPECT_EQ(sums[3].y, 16.0);
  for (const CellSum& sum : sums) EXPECT_EQ(sum.count, 2.0);
}

// The printed Algorithm 1, with real-valued cells: the oracle, pixel by pixel.
std::vector<CellSum> BruteForceCells(const ObjectCloud& cloud, int side) {
  const PixelExtent extent = FindExtent(cloud);
  std::vector<CellSum> sums(static_cast<std::size_t>(side * side));
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      if (!cloud.Has(u, v)) continue;
      const double column = (u - extent.u_begin + 0.5) / extent.Width() * side;
      const double row = (v - extent.v_begin + 0.5) / extent.Height() * side;
      // Away from where rounding could put a middle into the next cell.
      const auto c = static_cast<std::size_t>(std::floor(column + 1e-9));
      const auto r = static_cast<std::size_t>(std::floor(row + 1e-9));
      CellSum& sum = sums[r * static_cast<std::size_t>(side) + c];
      const float* p = cloud.Point(u, v);
      sum.x += static_cast<double>(p[0]);
      sum.y += static_cast<double>(p[1]);
      sum.z += static_cast<double>(p[2]);
      sum.count += 1.0;
    }
  }
  return sums;
}

void ExpectSame(const std::vector<CellSum>& found, const std::vector<CellSum>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t c = 0; c < found.size(); ++c) {
    EXPECT_EQ(found[c].count, expected[c].count) << c;
    EXPECT_EQ(found[c].x, expected[c].x) << c;
    EXPECT_EQ(found[c].y, expected[c].y) << c;
    EXPECT_EQ(found[c].z, expected[c].z) << c;
  }
}

TEST(CloudGrid, EveryPixelFallsIntoTheCellOfItsMiddle) {
  for (const int width : {1, 2, 10, 49, 50, 51, 99, 130}) {
    const SomeObject object(width, 63);
    for (const int side : {1, 3, 50}) {
      ExpectSame(Cells(object.View(), side), BruteForceCells(object.View(), side));
    }
  }
}

TEST(CloudGrid, SmallObjectsLeaveCellsEmptyAndReachNoCellBeyondTheLast) {
  // Algorithm 1 divides by ⌊9 / 50⌋ = 0 here, and by ⌊99 / 50⌋ = 1 to reach row 99 of 50 below.
  for (const int size : {10, 100}) {
    const SomeObject object(size, size);
    ObjectCloud whole = object.View();
    whole.mask = nullptr;
    const std::vector<CellSum> sums = Cells(whole, 50);
    const auto filled =
        std::count_if(sums.begin(), sums.end(), [](const CellSum& sum) { return sum.count > 0.0; });
    EXPECT_LE(filled, size * size);
    EXPECT_GE(filled, size == 10 ? 80 : 2400);
  }
}

TEST(CloudGrid, ASquareBoxByHand) {
  // 4 × 2 pixels in the middle of 4 × 4, a grid of 4: one pixel a cell of the middle rows.
  std::vector<float> points;
  for (int i = 0; i < 8; ++i) points.insert(points.end(), 3, static_cast<float>(i + 1));
  ObjectCloud cloud{.points = points.data(), .width = 4, .height = 2, .row_stride = 12};
  std::vector<CellSum> sums(16);
  EXPECT_EQ(SumCells(cloud, 4, GridBox::kSquare, sums), 8U);
  for (std::size_t c = 0; c < 16; ++c) {
    EXPECT_EQ(sums[c].x, c < 4 || c >= 12 ? 0.0 : static_cast<double>(c) - 3.0);
  }
  // The same object standing: 2 × 4 pixels fill the middle columns.
  cloud = {.points = points.data(), .width = 2, .height = 4, .row_stride = 6};
  EXPECT_EQ(SumCells(cloud, 4, GridBox::kSquare, sums), 8U);
  EXPECT_EQ(sums[0].count, 0.0);
  EXPECT_EQ(sums[1].x, 1.0);
  EXPECT_EQ(sums[14].x, 8.0);
}

TEST(CloudGrid, ASquareBoxLosesNoPoint) {
  for (const int width : {1, 2, 10, 49, 130}) {
    const SomeObject object(width, 63);
    std::vector<CellSum> sums(49);
    std::vector<CellSum> all(1);
    EXPECT_EQ(SumCells(object.View(), 7, GridBox::kSquare, sums),
              SumCells(object.View(), 1, GridBox::kFitted, all));
  }
}

TEST(CloudGrid, StridesAndABoxOfThePicture) {
  const SomeObject object(30, 20);
  // The same points, four floats each, in the middle of wider rows.
  std::vector<float> padded(static_cast<std::size_t>(20 * 4 * 50), 7.0F);
  for (int v = 0; v < 20; ++v) {
    for (int u = 0; u < 30; ++u) {
      std::copy_n(object.View().Point(u, v), 3, padded.begin() + (v * 50 + u + 10) * 4);
    }
  }
  ObjectCloud view = object.View();
  view.points = padded.data() + 40;
  view.row_stride = 200;
  view.point_stride = 4;
  ExpectSame(Cells(view, 7), Cells(object.View(), 7));
}

TEST(CloudGrid, OfNothingIsEmpty) {
  std::vector<CellSum> sums(9, CellSum{1.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(SumCells({}, 3, GridBox::kFitted, sums), 0U);
  for (const CellSum& sum : sums) EXPECT_EQ(sum.count, 0.0);
  sums.assign(9, CellSum{1.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(SumPolarCells({}, 3, sums), 0U);
  for (const CellSum& sum : sums) EXPECT_EQ(sum.count, 0.0);
}

TEST(CloudPolarGrid, FourPointsByHand) {
  // A cross around (2, 2): the middle, and points to the right, below, to the left and above.
  std::vector<float> points(75, std::numeric_limits<float>::quiet_NaN());
  const auto put = [&](int u, int v, float x) {
    std::fill_n(points.begin() + (v * 5 + u) * 3, 3, x);
  };
  put(2, 2, 1.0F);
  put(4, 2, 2.0F);
  put(2, 4, 3.0F);
  put(0, 2, 4.0F);
  put(2, 0, 5.0F);
  const ObjectCloud cloud{.points = points.data(), .width = 5, .height = 5, .row_stride = 15};
  std::vector<CellSum> sums(16);
  EXPECT_EQ(SumPolarCells(cloud, 4, sums), 5U);
  EXPECT_EQ(sums[0].x, 1.0);
  for (std::size_t sector = 0; sector < 4; ++sector) {
    EXPECT_EQ(sums[12 + sector].x, 2.0 + static_cast<double>(sector));
  }
}

TEST(CloudPolarGrid, TurningThePictureByAQuarterTurnsTheSectors) {
  constexpr int kSide = 8;
  const SomeObject object(41, 41);
  SomeObject turned = object;
  for (int v = 0; v < 41; ++v) {
    for (int u = 0; u < 41; ++u) {
      // (u, v) goes to (40 − v, u): +u becomes +v.
      std::copy_n(object.View().Point(u, v), 3, turned.points.begin() + (u * 41 + 40 - v) * 3);
    }
  }
  const std::vector<CellSum> before = PolarCells(object.View(), kSide);
  const std::vector<CellSum> after = PolarCells(turned.View(), kSide);
  double moved = 0.0;
  double total = 0.0;
  for (std::size_t ring = 0; ring < kSide; ++ring) {
    for (std::size_t sector = 0; sector < kSide; ++sector) {
      const std::size_t next = (sector + kSide / 4) % kSide;
      moved += std::fabs(after[ring * kSide + next].count - before[ring * kSide + sector].count);
      total += before[ring * kSide + sector].count;
    }
  }
  EXPECT_LT(moved, 0.02 * total);  // pixels on the edge of a sector
}

}  // namespace
}  // namespace handcraft::features
