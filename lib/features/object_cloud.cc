// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_cloud.h"

#include <algorithm>
#include <cstring>

namespace handcraft::features {
namespace {

// Whether eight bytes of the mask from column u on are all 0.
bool IsOutside(const ObjectCloud& cloud, int u, int v) noexcept {
  std::uint64_t eight = 0;
  std::memcpy(&eight, cloud.mask + v * cloud.mask_stride + u, sizeof eight);
  return eight == 0;
}

// The first column of row v that has a point of the object; the width when there is none.
int FirstInRow(const ObjectCloud& cloud, int v) noexcept {
  int u = 0;
  if (cloud.mask != nullptr) {
    while (u + 8 <= cloud.width && IsOutside(cloud, u, v)) u += 8;
  }
  while (u < cloud.width && !cloud.Has(u, v)) ++u;
  return u;
}

// The column behind the last one of row v that has a point, or `least` when that is no smaller.
int EndInRow(const ObjectCloud& cloud, int least, int v) noexcept {
  int end = cloud.width;
  if (cloud.mask != nullptr) {
    while (end - 8 >= least && IsOutside(cloud, end - 8, v)) end -= 8;
  }
  while (end > least && !cloud.Has(end - 1, v)) --end;
  return end;
}

}  // namespace

PixelExtent FindExtent(const ObjectCloud& cloud) noexcept {
  PixelExtent extent{.u_begin = cloud.width, .u_end = 0, .v_begin = cloud.height, .v_end = 0};
  for (int v = 0; v < cloud.height; ++v) {
    const int first = FirstInRow(cloud, v);
    if (first == cloud.width) continue;
    extent.u_begin = std::min(extent.u_begin, first);
    extent.v_begin = std::min(extent.v_begin, v);
    extent.v_end = v + 1;
    extent.u_end = EndInRow(cloud, extent.u_end, v);
  }
  return extent.v_end == 0 ? PixelExtent{} : extent;
}

}  // namespace handcraft::features
