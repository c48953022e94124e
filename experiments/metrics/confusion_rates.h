// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// What a confusion matrix says of each kind of sample, with 95 % intervals. The rates of wrong
/// calls are what these leave of 1 (Complement).
struct ConfusionRates {
  Estimate true_positive_rate = {};  ///< good samples called good, out of the good ones
  Estimate true_negative_rate = {};  ///< bad samples called bad, out of the bad ones
};

/// Of the matrices of all groups (images) together, each rate by EstimateShare (grouped_ratio.h).
/// NaN where a kind is missing. Pure.
[[nodiscard]] ConfusionRates EstimateRates(std::span<const ConfusionMatrix> groups,
                                           std::size_t num_resamples,
                                           std::uint64_t seed,
                                           int num_threads = 1);

/// 1 − the share, with its interval.
[[nodiscard]] Estimate Complement(const Estimate& share) noexcept;

}  // namespace handcraft::experiments
