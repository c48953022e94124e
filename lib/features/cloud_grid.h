// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/features/object_cloud.h"

namespace handcraft::features {

/// Cells along a side of a grid, at most.
inline constexpr int kMaxGridSize = 128;

/// What the points of a cell add up to.
struct CellSum {
  double x = 0.0;  ///< [m]
  double y = 0.0;
  double z = 0.0;
  double count = 0.0;
};

/// Which box of the picture a grid divides. The numbers stand in model files.
enum class GridBox : std::uint8_t {
  kFitted = 0,  ///< that of the object's measured pixels: cells are as broad as the object
  kSquare = 1,  ///< the square around its middle, as long as its longer side: cells are square
};

/// Sums of an object's points in the cells of a grid that is fitted to the box of its measured
/// pixels (FindExtent): pixel (u, v) of a box of W × H pixels belongs to column
/// ⌊(u − u_begin + ½) · side / W⌋ and row ⌊(v − v_begin + ½) · side / H⌋, which are below `side`
/// whatever the size; cell (row, column) is number row · side + column. A box with fewer pixels
/// than cells leaves cells empty.
///
/// `side` is from 1 to kMaxGridSize, `sums` has side² entries. Returns the number of points. Sums
/// of doubles in the order of the pixels; does not allocate; thread-safe. Source: dissertation,
/// section 4.2.2, Algorithm 1, whose whole-numbered cells divide by zero on small objects and reach
/// row `side` on others (docs/errata.md).
[[nodiscard]] std::size_t SumCells(const ObjectCloud& cloud,
                                   int side,
                                   GridBox box,
                                   std::span<CellSum> sums) noexcept;

/// As SumCells for circular and radial sampling: rings of equal width around the mean pixel of the
/// object's points, the last one ending at the farthest, each cut into `side` equal sectors that
/// begin at +u and go towards +v; cell (ring, sector) is number ring · side + sector.
/// Source: dissertation, section 4.2.2, after its reference [77].
[[nodiscard]] std::size_t SumPolarCells(const ObjectCloud& cloud,
                                        int side,
                                        std::span<CellSum> sums) noexcept;

}  // namespace handcraft::features
