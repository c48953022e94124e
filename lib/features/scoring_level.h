// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "lib/features/channel_planes.h"
#include "lib/features/pixel_kernels.h"

namespace handcraft::features::internal {

/// Decision values of a shrunk picture, added to the pixels they stand for.
struct ScaleMap {
  int reduction = 1;
  int width = 0;
  const float* values = nullptr;
};

/// One picture (or one shrunk copy) and everything its scores take.
struct ScoringLevel {
  const ChannelPlanes& planes;
  const FilterPlan& plan;
  const PixelKernels& kernels;
  const float* weights;
  int window;
  float intercept;
  std::span<const ScaleMap> maps;
  bool as_probability;
};

/// What the decision values of pixels x0 … x0 + width − 1 of row y start from.
inline void StartSums(const ScoringLevel& level, int x0, int width, int y, float* sums) noexcept {
  std::fill_n(sums, width, level.intercept);
  for (const ScaleMap& map : level.maps) {
    const float* row = map.values + static_cast<std::ptrdiff_t>(y / map.reduction) * map.width;
    for (int x = 0; x < width; ++x) sums[x] += row[(x0 + x) / map.reduction];
  }
}

}  // namespace handcraft::features::internal
