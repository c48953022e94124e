// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/precision_recall.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/core/check.h"

namespace handcraft::experiments {
namespace {

// Indices by descending score.
std::vector<std::size_t> DescendingOrder(std::span<const float> scores,
                                         std::span<const std::uint8_t> labels) {
  HC_CHECK(scores.size() == labels.size(), scores.size(), labels.size());
  for (std::size_t i = 0; i < scores.size(); ++i) {
    HC_CHECK(!std::isnan(scores[i]), i, scores[i]);
    HC_CHECK(labels[i] <= 1, i, static_cast<int>(labels[i]));
  }
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a] > scores[b];
  });
  return order;
}

}  // namespace

std::vector<PrecisionRecallPoint> PrecisionRecallCurve(std::span<const float> scores,
                                                       std::span<const std::uint8_t> labels,
                                                       std::size_t max_points) {
  HC_CHECK(max_points >= 2, max_points);
  const std::vector<std::size_t> order = DescendingOrder(scores, labels);
  const auto num_good = std::accumulate(labels.begin(), labels.end(), std::size_t{0});
  if (num_good == 0) return {};
  std::vector<PrecisionRecallPoint> all;
  std::size_t good_so_far = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    good_so_far += labels[order[k]];
    if (k + 1 < order.size() && scores[order[k + 1]] == scores[order[k]]) continue;
    all.push_back({static_cast<double>(good_so_far) / static_cast<double>(num_good),
                   static_cast<double>(good_so_far) / static_cast<double>(k + 1)});
  }
  if (all.size() <= max_points) return all;
  std::vector<PrecisionRecallPoint> kept;
  kept.reserve(max_points);
  for (std::size_t k = 0; k < max_points; ++k) {
    kept.push_back(all[k * (all.size() - 1) / (max_points - 1)]);
  }
  return kept;
}

}  // namespace handcraft::experiments
