// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_cloud.h"

#include <algorithm>
#include <cstring>

namespace handcraft::features {
namespace {

// The first column of row v from `u` on that may hold a pixel of the object: eight bytes of the
// mask at once.
int SkipOutside(const ObjectCloud& cloud, int v, int u, int end) noexcept {
  if (cloud.mask == nullptr) return u;
  const std::uint8_t* row = cloud.mask + v * cloud.mask_stride;
  for (; u + 8 <= end; u += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, row + u, sizeof eight);
    if (eight != 0) break;
  }
  return u;
}

int FirstInRow(const ObjectCloud& cloud, int v) noexcept {
  int u = SkipOutside(cloud, v, 0, cloud.width);
  while (u < cloud.width && !cloud.Has(u, v)) ++u;
  return u;
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
    int last = cloud.width - 1;
    while (last >= extent.u_end && !cloud.Has(last, v)) --last;
    extent.u_end = std::max(extent.u_end, last + 1);
  }
  return extent.v_end == 0 ? PixelExtent{} : extent;
}

}  // namespace handcraft::features
