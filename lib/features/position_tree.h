// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/features/vector3.h"

namespace handcraft::features {

/// A k-d tree of positions without pointers: the order of the rows is the tree. Of the rows
/// [first, last) of depth d, if they are more than kTreeLeafRows, row (first + last) / 2 divides:
/// along axis d mod 3 the rows before it are not above it, those behind it not below. Few enough
/// rows are a leaf, which is read from end to end.
struct PositionTree {
  std::span<const double> rows;           ///< num_rows × 3 [m]
  std::span<const std::int32_t> numbers;  ///< num_rows: who each row is

  [[nodiscard]] std::size_t size() const noexcept { return numbers.size(); }
};
inline constexpr std::size_t kTreeLeafRows = 8;

/// The order that makes positions a tree: order[i] is the position that goes to row i.
/// Deterministic: of equal coordinates the lower number comes first. Allocates.
[[nodiscard]] std::vector<std::size_t> TreeOrder(std::span<const Vector3> positions);

/// Whether the rows are in such an order. O(n log n); does not allocate or recurse.
[[nodiscard]] bool IsTree(std::span<const double> rows) noexcept;

struct Neighbour {
  double squared_distance_m2 = 0.0;
  std::int32_t number = 0;
  std::size_t row = 0;
};

/// The rows nearest to a point, nearest first, of equal ones the lower number: as many as
/// `nearest` holds or there are. Returns how many. Does not allocate or recurse; thread-safe.
/// Source: Bentley 1975, "Multidimensional binary search trees used for associative searching".
std::size_t FindNearest(const PositionTree& tree,
                        const Vector3& point,
                        std::span<Neighbour> nearest) noexcept;

}  // namespace handcraft::features
