// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lib/core/rng.h"
#include "lib/features/object_cloud.h"

namespace handcraft::testing {

/// A cloud of a bent surface with holes, whose object is an ellipse in the middle of the picture.
struct SomeObject {
  SomeObject(int wide, int high, std::uint64_t seed = 1) : width(wide), height(high) {
    Rng rng(seed);
    for (int v = 0; v < high; ++v) {
      for (int u = 0; u < wide; ++u) {
        const double x = (u + 0.5) / wide - 0.5;
        const double y = (v + 0.5) / high - 0.5;
        // Multiples of 2⁻¹⁰, so that sums are exact.
        const double depth = 0.5 + x * x + static_cast<double>(rng.UniformInt(9)) / 1024.0;
        const bool is_hole = rng.UniformInt(10) == 0;
        for (const double value : {depth, -x, -y}) {
          points.push_back(is_hole ? std::numeric_limits<float>::quiet_NaN()
                                   : static_cast<float>(static_cast<int>(value * 1024)) / 1024.0F);
        }
        mask.push_back(x * x + y * y < 0.2 ? 255 : 0);
      }
    }
  }

  [[nodiscard]] features::ObjectCloud View() const {
    return {.points = points.data(),
            .width = width,
            .height = height,
            .row_stride = 3 * width,
            .point_stride = 3,
            .mask = mask.data(),
            .mask_stride = width};
  }

  int width;
  int height;
  std::vector<float> points;
  std::vector<std::uint8_t> mask;
};

}  // namespace handcraft::testing
