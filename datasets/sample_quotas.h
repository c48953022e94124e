// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace handcraft::datasets {

/// Numbers of good and bad pixels of one picture: those it has, or those it is to give.
struct PixelCounts {
  std::size_t good = 0;
  std::size_t bad = 0;
  bool operator==(const PixelCounts&) const = default;
};

/// Shares `total` among those that can give `capacities[i]` each, as evenly as possible: the least
/// level L with Σ min(capacity, L) ≥ total, the excess taken from the last ones at the level.
/// Gives all there is when that is less than `total`.
[[nodiscard]] std::vector<std::size_t> ShareEvenly(std::span<const std::size_t> capacities,
                                                   std::size_t total);

/// What each picture gives to `num_samples` pixels with `bad_per_good` r bad ones for each good
/// one:
///   good: round(num_samples / (1 + r)), shared evenly; a picture can give as many good pixels as
///         it has, but no more than it has bad ones to go with, ⌊bad / r⌋;
///   bad:  the rest of num_samples, in proportion to the good ones to within one pixel a picture;
///         when there are too few good pixels, r times as many as there are.
/// num_samples 0: every pixel of every picture that has both kinds.
[[nodiscard]] std::vector<PixelCounts> ShareSamples(std::span<const PixelCounts> available,
                                                    std::size_t num_samples,
                                                    double bad_per_good);

}  // namespace handcraft::datasets
