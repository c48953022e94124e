// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// Of a reliability diagram.
inline constexpr std::size_t kNumReliabilityBins = 10;

/// The samples whose probability lies in [low, high) (the last bin takes 1 as well).
struct ProbabilityBin {
  double low = 0.0;
  double high = 0.0;
  std::size_t num_good = 0;
  std::size_t num_bad = 0;
  double mean_probability = 0.0;  ///< NaN when the bin is empty

  [[nodiscard]] std::size_t Total() const noexcept { return num_good + num_bad; }
};

/// Counts samples in num_bins ≥ 1 bins of equal width over [0, 1]: the score histogram, and the
/// reliability diagram (share of good samples against mean probability; DeGroot and Fienberg 1983).
/// Throws std::logic_error on lengths that differ, labels other than 0/1, or probabilities outside
/// [0, 1].
[[nodiscard]] std::vector<ProbabilityBin> BinProbabilities(std::span<const float> probabilities,
                                                           std::span<const std::uint8_t> labels,
                                                           std::size_t num_bins);

/// A bin of a reliability diagram: its samples, and how many of them are good, with 95 %.
struct ReliabilityBin {
  ProbabilityBin bin = {};
  Estimate good_share = {};  ///< NaN when the bin is empty
};

/// The bins of all groups (images) together; `groups` holds the bins of each, as many in all.
/// Intervals: EstimateShare (grouped_ratio.h), a group that has nothing in a bin being drawn too.
[[nodiscard]] std::vector<ReliabilityBin> EstimateReliability(
    std::span<const std::vector<ProbabilityBin>> groups,
    std::size_t num_resamples,
    std::uint64_t seed,
    int num_threads = 1);

}  // namespace handcraft::experiments
