// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/confusion_rates.h"

#include <vector>

#include "experiments/metrics/grouped_ratio.h"

namespace handcraft::experiments {

ConfusionRates EstimateRates(std::span<const ConfusionMatrix> groups,
                             std::size_t num_resamples,
                             std::uint64_t seed,
                             int num_threads) {
  std::vector<GroupRatio> good;
  std::vector<GroupRatio> bad;
  good.reserve(groups.size());
  bad.reserve(groups.size());
  for (const ConfusionMatrix& matrix : groups) {
    good.push_back(
        {static_cast<double>(matrix.true_positive), static_cast<double>(matrix.NumGood())});
    bad.push_back(
        {static_cast<double>(matrix.true_negative), static_cast<double>(matrix.NumBad())});
  }
  return {.true_positive_rate = EstimateShare(good, num_resamples, seed, num_threads),
          .true_negative_rate = EstimateShare(bad, num_resamples, seed, num_threads)};
}

Estimate Complement(const Estimate& share) noexcept {
  return {1.0 - share.value, 1.0 - share.high, 1.0 - share.low};
}

}  // namespace handcraft::experiments
