// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/probability_bins.h"

#include <algorithm>
#include <limits>

#include "experiments/metrics/grouped_ratio.h"
#include "lib/core/check.h"

namespace handcraft::experiments {

std::vector<ProbabilityBin> BinProbabilities(std::span<const float> probabilities,
                                             std::span<const std::uint8_t> labels,
                                             std::size_t num_bins) {
  HC_CHECK(num_bins >= 1, num_bins);
  HC_CHECK(probabilities.size() == labels.size(), probabilities.size(), labels.size());
  const auto bin_count = static_cast<double>(num_bins);
  std::vector<ProbabilityBin> bins(num_bins);
  for (std::size_t b = 0; b < num_bins; ++b) {
    bins[b].low = static_cast<double>(b) / bin_count;
    bins[b].high = static_cast<double>(b + 1) / bin_count;
  }
  std::vector<double> sums(num_bins, 0.0);
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double p = probabilities[i];
    HC_CHECK(p >= 0.0 && p <= 1.0, i, p);
    HC_CHECK(labels[i] <= 1, i, static_cast<int>(labels[i]));
    const std::size_t b = std::min(static_cast<std::size_t>(p * bin_count), num_bins - 1);
    ++(labels[i] == 1 ? bins[b].num_good : bins[b].num_bad);
    sums[b] += p;
  }
  for (std::size_t b = 0; b < num_bins; ++b) {
    bins[b].mean_probability = bins[b].Total() == 0
                                   ? std::numeric_limits<double>::quiet_NaN()
                                   : sums[b] / static_cast<double>(bins[b].Total());
  }
  return bins;
}

std::vector<ReliabilityBin> EstimateReliability(std::span<const std::vector<ProbabilityBin>> groups,
                                                std::size_t num_resamples,
                                                std::uint64_t seed,
                                                int num_threads) {
  const std::size_t num_bins = groups.empty() ? 0 : groups.front().size();
  std::vector<ReliabilityBin> reliability(num_bins);
  for (std::size_t b = 0; b < num_bins; ++b) {
    ProbabilityBin& all = reliability[b].bin;
    all = {.low = groups.front()[b].low, .high = groups.front()[b].high};
    double sum = 0.0;
    std::vector<GroupRatio> shares;
    for (const std::vector<ProbabilityBin>& group : groups) {
      HC_CHECK(group.size() == num_bins, group.size(), num_bins);
      const ProbabilityBin& part = group[b];
      const auto count = static_cast<double>(part.Total());
      if (part.Total() > 0) sum += count * part.mean_probability;
      all.num_good += part.num_good;
      all.num_bad += part.num_bad;
      shares.push_back({static_cast<double>(part.num_good), count});
    }
    all.mean_probability = all.Total() == 0 ? std::numeric_limits<double>::quiet_NaN()
                                            : sum / static_cast<double>(all.Total());
    reliability[b].good_share = EstimateShare(shares, num_resamples, seed, num_threads);
  }
  return reliability;
}

}  // namespace handcraft::experiments
