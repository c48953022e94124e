// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/sample_quotas.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace handcraft::datasets {
namespace {

// round(x), at most `limit`; x may lie beyond what an integer holds.
std::size_t RoundAtMost(double x, std::size_t limit) {
  return x >= static_cast<double>(limit) ? limit : static_cast<std::size_t>(std::llround(x));
}

std::vector<PixelCounts> EveryPixel(std::span<const PixelCounts> available) {
  std::vector<PixelCounts> quotas(available.begin(), available.end());
  for (PixelCounts& quota : quotas) {
    if (quota.good == 0 || quota.bad == 0) quota = {};
  }
  return quotas;
}

}  // namespace

std::vector<std::size_t> ShareEvenly(std::span<const std::size_t> capacities, std::size_t total) {
  std::vector<std::size_t> ascending(capacities.begin(), capacities.end());
  std::sort(ascending.begin(), ascending.end());
  // Those below the level give all they have; `left` is what remains for the others.
  std::size_t left =
      std::min(total, std::accumulate(ascending.begin(), ascending.end(), std::size_t{0}));
  std::size_t num_full = 0;
  while (num_full < ascending.size() &&
         ascending[num_full] <= left / (ascending.size() - num_full)) {
    left -= ascending[num_full];
    ++num_full;
  }
  std::vector<std::size_t> shares(capacities.begin(), capacities.end());
  if (num_full == ascending.size()) return shares;

  const std::size_t level = left / (ascending.size() - num_full);
  std::size_t excess = left % (ascending.size() - num_full);
  for (std::size_t& share : shares) {
    if (share <= level) continue;
    share = level;
    if (excess == 0) continue;
    ++share;
    --excess;
  }
  return shares;
}

std::vector<PixelCounts> ShareSamples(std::span<const PixelCounts> available,
                                      std::size_t num_samples,
                                      double bad_per_good) {
  if (num_samples == 0) return EveryPixel(available);
  std::vector<std::size_t> capacities;
  for (const PixelCounts& counts : available) {
    const double partners = std::floor(static_cast<double>(counts.bad) / bad_per_good);
    capacities.push_back(RoundAtMost(partners, counts.good));
  }
  const std::size_t wanted_good =
      RoundAtMost(static_cast<double>(num_samples) / (1.0 + bad_per_good), num_samples);
  const std::vector<std::size_t> good = ShareEvenly(capacities, wanted_good);
  const std::size_t all_good = std::accumulate(good.begin(), good.end(), std::size_t{0});
  const std::size_t all_bad =
      all_good == wanted_good
          ? num_samples - wanted_good
          : RoundAtMost(bad_per_good * static_cast<double>(all_good), num_samples);

  std::vector<PixelCounts> quotas;
  std::size_t carried = 0;  // numerator of the fraction of a bad pixel not given yet, over all_good
  for (std::size_t i = 0; i < good.size(); ++i) {
    carried += all_bad * good[i];
    const std::size_t bad = all_good == 0 ? 0 : carried / all_good;
    carried -= bad * all_good;
    quotas.push_back({.good = good[i], .bad = std::min(bad, available[i].bad)});
  }
  return quotas;
}

}  // namespace handcraft::datasets
