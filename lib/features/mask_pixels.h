// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "lib/features/object_cloud.h"
#include "lib/features/pixel_region.h"

namespace handcraft::features {

/// The mask of a cloud that has one.
[[nodiscard]] inline PixelMask MaskOf(const ObjectCloud& cloud) noexcept {
  return {cloud.mask, cloud.mask_stride};
}

/// Calls visit(v, first_u, last_u) for each run of pixels first_u … last_u − 1 of a row whose byte
/// is not 0, row after row from left to right. Eight empty pixels cost one comparison.
template <class Visit>
void ForEachMaskRun(const PixelMask& mask, int width, int height, const Visit& visit) noexcept {
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* row = mask.Row(v);
    int u = 0;
    while (u < width) {
      std::uint64_t eight = 0;
      if (u + 8 <= width) {
        std::memcpy(&eight, row + u, 8);
        if (eight == 0) {
          u += 8;
          continue;
        }
      }
      while (u < width && row[u] == 0) ++u;
      const int first_u = u;
      while (u < width && row[u] != 0) ++u;
      if (u > first_u) visit(v, first_u, u);
    }
  }
}

}  // namespace handcraft::features
