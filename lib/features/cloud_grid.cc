// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cloud_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace handcraft::features {
namespace {

// Where the cells of one direction begin.
class Axis {
 public:
  // Pixels [first, first + length) in the middle of `box` pixels; 0: of as many.
  Axis(int first, int length, int box, int side) noexcept
      : first_(first),
        length_(length),
        size_(box == 0 ? length : box),
        before_((size_ - length) / 2),
        side_(side) {}

  // The first pixel whose middle lies in this cell or beyond it.
  [[nodiscard]] int Begin(int cell) const noexcept {
    // (pixel + ½) · side / size ≥ cell, in whole numbers.
    const std::int64_t twice = 2 * std::int64_t{cell} * size_ - side_;
    const std::int64_t pixel = twice <= 0 ? 0 : (twice + 2 * side_ - 1) / (2 * std::int64_t{side_});
    return first_ + static_cast<int>(std::clamp<std::int64_t>(pixel - before_, 0, length_));
  }

 private:
  int first_;
  int length_;
  int size_;
  int before_;  // pixels of the box before the first
  int side_;
};

void AddPoint(const float* point, CellSum& sum) noexcept {
  sum.x += static_cast<double>(point[0]);
  sum.y += static_cast<double>(point[1]);
  sum.z += static_cast<double>(point[2]);
  sum.count += 1.0;
}

// One row's share of a cell: columns from `u` to `end`.
void AddRun(const ObjectCloud& cloud, int u, int end, int v, CellSum& sum) noexcept {
  CellSum run = sum;
  for (; u < end; ++u) {
    if (cloud.Has(u, v)) AddPoint(cloud.Point(u, v), run);
  }
  sum = run;
}

struct Centre {
  double u = 0.0;  // [px]
  double v = 0.0;
  double radius = 0.0;  // of the farthest point
};

// The mean pixel of the object's points, and how far the farthest is from it.
Centre FindCentre(const ObjectCloud& cloud, const PixelExtent& extent) noexcept {
  Centre centre;
  double count = 0.0;
  for (int v = extent.v_begin; v < extent.v_end; ++v) {
    for (int u = extent.u_begin; u < extent.u_end; ++u) {
      if (!cloud.Has(u, v)) continue;
      centre.u += u;
      centre.v += v;
      count += 1.0;
    }
  }
  if (count == 0.0) return centre;
  centre.u /= count;
  centre.v /= count;
  for (int v = extent.v_begin; v < extent.v_end; ++v) {
    for (int u = extent.u_begin; u < extent.u_end; ++u) {
      if (!cloud.Has(u, v)) continue;
      centre.radius = std::max(centre.radius, std::hypot(u - centre.u, v - centre.v));
    }
  }
  return centre;
}

}  // namespace

std::size_t SumCells(const ObjectCloud& cloud,
                     int side,
                     GridBox box,
                     std::span<CellSum> sums) noexcept {
  std::fill(sums.begin(), sums.end(), CellSum{});
  const PixelExtent extent = FindExtent(cloud);
  const int longer = std::max(extent.Width(), extent.Height());
  const Axis columns(extent.u_begin, extent.Width(), box == GridBox::kSquare ? longer : 0, side);
  const Axis rows(extent.v_begin, extent.Height(), box == GridBox::kSquare ? longer : 0, side);
  std::array<int, kMaxGridSize + 1> column_begins;  // a division each: once, not in every row
  for (int column = 0; column <= side; ++column) {
    column_begins[static_cast<std::size_t>(column)] = columns.Begin(column);
  }
  for (int row = 0; row < side; ++row) {
    const int v_end = rows.Begin(row + 1);
    for (int v = rows.Begin(row); v < v_end; ++v) {
      CellSum* cells = sums.data() + static_cast<std::ptrdiff_t>(row) * side;
      for (std::size_t column = 0; column < static_cast<std::size_t>(side); ++column) {
        AddRun(cloud, column_begins[column], column_begins[column + 1], v, cells[column]);
      }
    }
  }
  double count = 0.0;
  for (const CellSum& sum : sums) count += sum.count;
  return static_cast<std::size_t>(count);
}

std::size_t SumPolarCells(const ObjectCloud& cloud, int side, std::span<CellSum> sums) noexcept {
  std::fill(sums.begin(), sums.end(), CellSum{});
  const PixelExtent extent = FindExtent(cloud);
  const Centre centre = FindCentre(cloud, extent);
  const double rings_a_px = centre.radius > 0.0 ? side / centre.radius : 0.0;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  std::size_t count = 0;
  for (int v = extent.v_begin; v < extent.v_end; ++v) {
    for (int u = extent.u_begin; u < extent.u_end; ++u) {
      if (!cloud.Has(u, v)) continue;
      const double du = u - centre.u;
      const double dv = v - centre.v;
      const double angle = std::atan2(dv, du);
      const double turn = (angle < 0.0 ? angle + kTurn : angle) / kTurn;
      const int ring = std::min(side - 1, static_cast<int>(std::hypot(du, dv) * rings_a_px));
      const int sector = std::min(side - 1, static_cast<int>(turn * side));
      AddPoint(cloud.Point(u, v), sums[static_cast<std::size_t>(ring * side + sector)]);
      ++count;
    }
  }
  return count;
}

}  // namespace handcraft::features
