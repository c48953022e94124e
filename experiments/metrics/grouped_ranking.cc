// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/grouped_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/parallel.h"

namespace handcraft::experiments {

GroupedRanking::GroupedRanking(std::span<const double> scores,
                               std::span<const std::uint8_t> labels,
                               std::span<const std::size_t> groups,
                               std::size_t num_groups)
    : num_groups_(num_groups) {
  HC_CHECK(scores.size() == labels.size() && scores.size() == groups.size(),
           scores.size(),
           labels.size(),
           groups.size());
  for (std::size_t i = 0; i < scores.size(); ++i) {
    HC_CHECK(!std::isnan(scores[i]), i, scores[i]);
    HC_CHECK(labels[i] <= 1, i, static_cast<int>(labels[i]));
    HC_CHECK(groups[i] < num_groups, i, groups[i], num_groups);
  }
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a] > scores[b];
  });
  descending_.reserve(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    const bool ends_tie = k + 1 == order.size() || scores[order[k + 1]] != scores[i];
    descending_.push_back({static_cast<std::uint32_t>(groups[i]), labels[i] == 1, ends_tie});
  }
}

// Going down the scores, in each lane: what is good and bad so far, and what was so before the tie
// that is being gone through.
template <std::size_t kLanes>
std::array<GroupedRanking::Ranks, kLanes> GroupedRanking::RanksOf(
    std::span<const Lanes<kLanes>> times_drawn) const {
  Lanes<kLanes> good{};
  Lanes<kLanes> bad{};
  Lanes<kLanes> good_before{};
  Lanes<kLanes> bad_before{};
  Lanes<kLanes> twice_losses{};  // of good samples to the bad ones above them, half to their ties
  Lanes<kLanes> precision_sum{};
  bool has_good = false;
  for (const RankedSample& sample : descending_) {
    const Lanes<kLanes>& times = times_drawn[sample.group];
    has_good = has_good || sample.is_good;
    Lanes<kLanes>& counted = sample.is_good ? good : bad;
    for (std::size_t k = 0; k < kLanes; ++k) counted[k] += times[k];
    if (!sample.ends_tie) continue;
    if (has_good) {
      for (std::size_t k = 0; k < kLanes; ++k) {
        const double more = good[k] - good_before[k];
        twice_losses[k] += more * (bad_before[k] + bad[k]);
        precision_sum[k] += more * good[k] / std::max(good[k] + bad[k], 1.0);
      }
      good_before = good;
    }
    bad_before = bad;
    has_good = false;
  }
  std::array<Ranks, kLanes> ranks{};
  for (std::size_t k = 0; k < kLanes; ++k) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const double twice_pairs = 2.0 * good[k] * bad[k];
    ranks[k] = twice_pairs == 0.0 ? Ranks{kNaN, kNaN}
                                  : Ranks{(twice_pairs - twice_losses[k]) / twice_pairs,
                                          precision_sum[k] / good[k]};
  }
  return ranks;
}

GroupedRanking::Ranks GroupedRanking::RanksOfOne(std::span<const std::size_t> drawn_groups) const {
  std::vector<Lanes<1>> times(num_groups_);
  for (const std::size_t group : drawn_groups) {
    HC_CHECK(group < num_groups_, group, num_groups_);
    times[group][0] += 1.0;
  }
  return RanksOf<1>(times)[0];
}

double GroupedRanking::Auc(std::span<const std::size_t> drawn_groups) const {
  return RanksOfOne(drawn_groups).auc;
}

double GroupedRanking::AveragePrecision(std::span<const std::size_t> drawn_groups) const {
  return RanksOfOne(drawn_groups).average_precision;
}

RankingEstimates GroupedRanking::Bootstrap(std::size_t num_resamples,
                                           std::uint64_t seed,
                                           int num_threads) const {
  constexpr std::size_t kLanes = 8;
  std::vector<std::size_t> all(num_groups_);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Ranks value = RanksOfOne(all);
  std::vector<double> aucs(num_groups_ < 2 ? 0 : num_resamples);
  std::vector<double> precisions(aucs.size());
  ParallelFor((aucs.size() + kLanes - 1) / kLanes, num_threads, [&](std::size_t batch) {
    const std::size_t begin = batch * kLanes;
    const std::size_t count = std::min(kLanes, aucs.size() - begin);
    std::vector<Lanes<kLanes>> times(num_groups_);
    for (std::size_t k = 0; k < count; ++k) {
      for (const std::size_t group : DrawGroups(num_groups_, seed, begin + k)) {
        times[group][k] += 1.0;
      }
    }
    const std::array<Ranks, kLanes> ranks = RanksOf<kLanes>(times);
    for (std::size_t k = 0; k < count; ++k) {
      aucs[begin + k] = ranks[k].auc;
      precisions[begin + k] = ranks[k].average_precision;
    }
  });
  return {PercentileEstimate(value.auc, std::move(aucs)),
          PercentileEstimate(value.average_precision, std::move(precisions))};
}

}  // namespace handcraft::experiments
