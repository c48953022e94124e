// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/grouped_ratio.h"

#include <algorithm>
#include <limits>

namespace handcraft::experiments {
namespace {

std::size_t NumCounted(std::span<const GroupRatio> groups) {
  return static_cast<std::size_t>(std::count_if(
      groups.begin(), groups.end(), [](const GroupRatio& group) { return group.count > 0.0; }));
}

}  // namespace

Estimate EstimateRatio(std::span<const GroupRatio> groups,
                       std::size_t num_resamples,
                       std::uint64_t seed,
                       int num_threads) {
  const auto ratio = [groups](std::span<const std::size_t> drawn) {
    GroupRatio all;
    for (const std::size_t i : drawn) all += groups[i];
    return all.Value();
  };
  Estimate estimate = BootstrapOverGroups(groups.size(), ratio, num_resamples, seed, num_threads);
  if (NumCounted(groups) < 2) {
    estimate.low = std::numeric_limits<double>::quiet_NaN();
    estimate.high = estimate.low;
  }
  return estimate;
}

Estimate EstimateShare(std::span<const GroupRatio> groups,
                       std::size_t num_resamples,
                       std::uint64_t seed,
                       int num_threads) {
  const Estimate share = EstimateRatio(groups, num_resamples, seed, num_threads);
  const std::size_t num_counted = NumCounted(groups);
  if (num_counted < 2) return share;
  if (share.value == 0.0) return WilsonInterval(0, num_counted);
  if (share.value == 1.0) return WilsonInterval(num_counted, num_counted);
  return share;
}

}  // namespace handcraft::experiments
