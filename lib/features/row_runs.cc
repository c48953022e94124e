// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/row_runs.h"

namespace handcraft::features::internal {

RegionBox BoxOf(const PixelMask& mask, int width, int height) noexcept {
  RegionBox box{.first_u = width, .last_u = 0, .first_v = height, .last_v = 0};
  const RegionBox whole{.first_u = 0, .last_u = width, .first_v = 0, .last_v = height};
  for (int v = 0; v < height; ++v) {
    ForEachRun(mask, whole, v, v, [&](const ColumnRun& run) {
      box.first_u = std::min(box.first_u, run.first);
      box.last_u = std::max(box.last_u, run.last);
      box.first_v = std::min(box.first_v, v);
      box.last_v = v + 1;
    });
  }
  return box;
}

RegionWork SparseWork(const PixelMask& mask, const RegionBox& box, int radius) noexcept {
  RegionWork work;
  for (int v = box.first_v - radius; v < box.last_v + radius; ++v) {
    ForEachPiece(mask, box, v - radius, v + radius, [&](const ColumnRun& run) {
      work.num_columns += run.last - run.first + kRunOverhead;
      ++work.num_runs;
    });
  }
  return work;
}

std::int64_t NumDenseColumns(int width, int height, int radius) noexcept {
  const std::int64_t num_strips = (width + kStripWidth - 1) / kStripWidth;
  return (width + num_strips * kStripOverhead) * (height + std::int64_t{2} * radius);
}

}  // namespace handcraft::features::internal
