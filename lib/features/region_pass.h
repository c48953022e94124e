// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>

#include "lib/features/channel_planes.h"
#include "lib/features/pixel_region.h"
#include "lib/features/row_runs.h"
#include "lib/features/scoring_level.h"

namespace handcraft::features::internal {

/// Rows of decision values in the making, one for each row of the window, of the picture's width.
struct RegionSums {
  float* memory = nullptr;  ///< NumFloats of them

  [[nodiscard]] static std::ptrdiff_t Stride(int width) noexcept {
    return (width + kSlack + 15) / 16 * 16;
  }
  [[nodiscard]] static std::size_t NumFloats(int width, int window) noexcept {
    return static_cast<std::size_t>(Stride(width)) * static_cast<std::size_t>(window);
  }
};

/// Where scores go: a map of the picture's size, whose unwanted pixels are set to 0, or one number
/// for each of a list of pixels in the order of rows.
struct RegionOutput {
  float* map = nullptr;
  std::ptrdiff_t stride = 0;
  std::span<const PixelPosition> pixels = {};
  float* values = nullptr;  ///< pixels.size() of them; used when there is no map
};

/// Scores the wanted pixels of a picture in the sparse way. Row by row, the runs of columns are
/// filtered that hold a wanted pixel within the window's rows; each pixel's sum is formed by the
/// same operations in the same order as in the dense way, so the bits are the same. Planes must be
/// converted in the box and kRegionMargin around it. No allocation, no checks.
void ScoreRegion(const ScoringLevel& level,
                 const PixelMask& mask,
                 const RegionBox& box,
                 const RegionSums& sums,
                 StripBuffers& buffers,
                 const RegionOutput& output) noexcept;

/// Pixels around a region that its scores depend on: window, kernels, and the scratch's spare one.
inline constexpr int kRegionMargin = kMaxRadius + kKernelSize / 2 + 1;

}  // namespace handcraft::features::internal
