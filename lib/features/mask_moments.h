// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "lib/features/pixel_region.h"

namespace handcraft::features {

/// Of each half: μ00 [px], then the scale-free η11, η20, η02, η30, η21, η12, η03.
inline constexpr std::size_t kMomentsPerHalf = 8;
/// Left half first.
inline constexpr std::size_t kNumMoments = 2 * kMomentsPerHalf;
using HalvesMoments = std::array<double, kNumMoments>;

/// Central moments of the left and the right half of a mask's pixels (byte not 0), each about its
/// own centroid:
///   μ_ij = Σ (u − ū)^i (v − v̄)^j (Eq. 4.4),  η_ij = μ_ij / μ00^(1 + (i + j) / 2).
/// Left are the columns u < ū, ū the centroid of the whole mask; right are the others. The η stay
/// when the picture is enlarged (but for the pixels' size) or moved. False, and no moments, when a
/// half has no pixel. Runs of pixels count at once, by sums of powers in closed form. Does not
/// allocate; thread-safe. Source: dissertation Eq. (4.4); Hu 1962, "Visual pattern recognition by
/// moment invariants", for η.
[[nodiscard]] bool MomentsOfHalves(const PixelMask& mask,
                                   int width,
                                   int height,
                                   HalvesMoments& moments) noexcept;

}  // namespace handcraft::features
