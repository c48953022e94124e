// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::runtime {

/// A map of probabilities in the caller's memory; row v starts at data + v · stride.
struct ProbabilityMap {
  const float* data = nullptr;
  std::int32_t width = 0;   ///< [px], at least 1
  std::int32_t height = 0;  ///< [px], at least 1
  std::ptrdiff_t stride = 0;

  [[nodiscard]] const float* Row(std::int32_t v) const noexcept { return data + v * stride; }
};

/// The best pixels with probability > min_probability, best first (ties: smaller v, then smaller
/// u); fills `points` from the front and returns how many there are. NaN is never chosen.
/// A heap over `points`: O(width · height + m log k), m pixels above the least of the best so far.
/// Does not allocate.
[[nodiscard]] std::size_t FindBest(const ProbabilityMap& map,
                                   float min_probability,
                                   std::span<hc_point> points) noexcept;

/// As FindBest, greedily with suppression: the best pixel is taken, then the best of those more
/// than radius_px away from it in the maximum norm, and so on. Exact.
/// The picture is cut into at most 32 × 32 tiles whose best pixels are kept; a taken point makes
/// only the tiles that its square touches look again. O(width · height) for the first pass, then
/// per point O(tiles) and, for each touched tile whose best pixel it suppresses, O(points taken +
/// pixels of the tile · points taken near it). Uses 13 KiB of stack.
[[nodiscard]] std::size_t FindBestApart(const ProbabilityMap& map,
                                        float min_probability,
                                        std::int32_t radius_px,
                                        std::span<hc_point> points) noexcept;

}  // namespace handcraft::runtime
