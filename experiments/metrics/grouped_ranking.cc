// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/grouped_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lib/core/check.h"

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
    descending_.push_back({groups[i], labels[i] == 1, ends_tie});
  }
}

std::vector<std::uint64_t> GroupedRanking::TimesDrawn(
    std::span<const std::size_t> drawn_groups) const {
  std::vector<std::uint64_t> times(num_groups_, 0);
  for (const std::size_t group : drawn_groups) {
    HC_CHECK(group < num_groups_, group, num_groups_);
    ++times[group];
  }
  return times;
}

double GroupedRanking::Auc(std::span<const std::size_t> drawn_groups) const {
  const std::vector<std::uint64_t> times = TimesDrawn(drawn_groups);
  // Going down the scores: a bad sample loses to every good one above it and half to its ties.
  std::uint64_t num_good = 0;
  std::uint64_t num_bad = 0;
  std::uint64_t twice_wins = 0;
  std::uint64_t tied_good = 0;
  std::uint64_t tied_bad = 0;
  for (const Sample& sample : descending_) {
    const std::uint64_t weight = times[sample.group];
    (sample.is_good ? tied_good : tied_bad) += weight;
    if (!sample.ends_tie) continue;
    twice_wins += tied_bad * (2 * num_good + tied_good);
    num_good += tied_good;
    num_bad += tied_bad;
    tied_good = 0;
    tied_bad = 0;
  }
  if (num_good == 0 || num_bad == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(twice_wins) /
         (2.0 * static_cast<double>(num_good) * static_cast<double>(num_bad));
}

double GroupedRanking::AveragePrecision(std::span<const std::size_t> drawn_groups) const {
  const std::vector<std::uint64_t> times = TimesDrawn(drawn_groups);
  std::uint64_t num_good = 0;
  std::uint64_t num_called = 0;
  std::uint64_t good_before = 0;
  double sum = 0.0;
  for (const Sample& sample : descending_) {
    const std::uint64_t weight = times[sample.group];
    num_called += weight;
    num_good += sample.is_good ? weight : 0;
    if (!sample.ends_tie || num_good == good_before) continue;
    sum += static_cast<double>(num_good - good_before) * static_cast<double>(num_good) /
           static_cast<double>(num_called);
    good_before = num_good;
  }
  if (num_good == 0 || num_good == num_called) return std::numeric_limits<double>::quiet_NaN();
  return sum / static_cast<double>(num_good);
}

}  // namespace handcraft::experiments
