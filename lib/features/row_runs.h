// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "lib/features/pixel_kernels.h"
#include "lib/features/pixel_region.h"

namespace handcraft::features::internal {

/// Columns first … last − 1 of a row.
struct ColumnRun {
  int first = 0;
  int last = 0;
};

/// Runs closer than this are one run [px]. Not less than a vector of the widest set: kernels write
/// up to a vector past the end of a run, and must not reach the next one.
inline constexpr int kMergeGap = 24;
static_assert(kMergeGap >= 16);

/// What a run makes the filters compute besides its columns, in columns: their reach at both ends,
/// the rest of its last vector. Measured: docs/methods/search_space_reduction.md.
inline constexpr int kRunOverhead = 24;
/// The same for a strip of the dense way.
inline constexpr int kStripOverhead = 12;

/// The smallest box that holds the wanted pixels; empty when there are none.
[[nodiscard]] RegionBox BoxOf(const PixelMask& mask, int width, int height) noexcept;

/// What the sparse way computes to score the wanted pixels with a window of radius `radius`.
struct RegionWork {
  std::int64_t num_columns = 0;  ///< kRunOverhead included
  std::int64_t num_runs = 0;     ///< pieces of them
};
[[nodiscard]] RegionWork SparseWork(const PixelMask& mask,
                                    const RegionBox& box,
                                    int radius) noexcept;

/// Columns that the dense way computes, kStripOverhead included.
[[nodiscard]] std::int64_t NumDenseColumns(int width, int height, int radius) noexcept;

/// Calls visit(ColumnRun) from left to right for each run of columns in the box where one of the
/// rows first_row … last_row (inclusive, cut to the box) has a wanted pixel.
template <class Visit>
void ForEachRun(const PixelMask& mask,
                const RegionBox& box,
                int first_row,
                int last_row,
                const Visit& visit) noexcept {
  static_assert(std::endian::native == std::endian::little, "the first byte is the lowest");
  first_row = std::max(first_row, box.first_v);
  last_row = std::min(last_row, box.last_v - 1);
  ColumnRun run{-1, -1};
  for (int u = box.first_u; u < box.last_u; u += 8) {
    const auto count = static_cast<std::size_t>(std::min(8, box.last_u - u));
    std::uint64_t wanted = 0;
    for (int v = first_row; v <= last_row; ++v) {
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, mask.Row(v) + u, count);
      wanted |= bytes;
    }
    if (wanted == 0) continue;
    const int first = u + std::countr_zero(wanted) / 8;
    const int last = u + 8 - std::countl_zero(wanted) / 8;
    if (run.first >= 0 && first - run.last >= kMergeGap) {
      visit(run);
      run.first = -1;
    }
    if (run.first < 0) run.first = first;
    run.last = last;
  }
  if (run.first >= 0) visit(run);
}

/// As ForEachRun, with long runs cut into pieces of at most kStripWidth.
template <class Visit>
void ForEachPiece(const PixelMask& mask,
                  const RegionBox& box,
                  int first_row,
                  int last_row,
                  const Visit& visit) noexcept {
  ForEachRun(mask, box, first_row, last_row, [&](const ColumnRun& run) {
    for (int first = run.first; first < run.last; first += kStripWidth) {
      visit(ColumnRun{first, std::min(run.last, first + kStripWidth)});
    }
  });
}

}  // namespace handcraft::features::internal
