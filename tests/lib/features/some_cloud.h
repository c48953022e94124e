// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lib/features/object_plane.h"

namespace handcraft::features::testing {

/// An organised cloud with a mask that owns its numbers.
struct SomeCloud {
  int width = 0;
  int height = 0;
  std::vector<float> points = {};
  std::vector<std::uint8_t> mask = {};

  SomeCloud(int w, int h)
      : width(w),
        height(h),
        points(3 * static_cast<std::size_t>(w * h), std::numeric_limits<float>::quiet_NaN()),
        mask(static_cast<std::size_t>(w * h)) {}

  void Set(int u, int v, const Vector3& p) {
    const auto pixel = static_cast<std::size_t>(v * width + u);
    mask[pixel] = 255;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[3 * pixel + axis] = static_cast<float>(p[axis]);
    }
  }
  [[nodiscard]] ObjectCloud View() const {
    return {.points = points.data(),
            .width = width,
            .height = height,
            .row_stride = std::ptrdiff_t{3} * width,
            .mask = mask.data(),
            .mask_stride = width};
  }
  [[nodiscard]] ObjectPlane Fit() const {
    std::vector<float> scratch(ObjectPlaneScratch(width, height));
    return FitObjectPlane(View(), scratch);
  }
};

}  // namespace handcraft::features::testing
