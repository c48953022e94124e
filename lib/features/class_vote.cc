// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/class_vote.h"

#include <algorithm>
#include <limits>

namespace handcraft::features {
namespace {

ClassVote VoteOfPairs(std::span<const double> decision_values,
                      std::span<std::int32_t> votes) noexcept {
  const std::size_t num_classes = votes.size();
  std::fill(votes.begin(), votes.end(), 0);
  for (std::size_t b = 1; b < num_classes; ++b) {
    for (std::size_t a = 0; a < b; ++a) ++votes[decision_values[PairIndex(a, b)] > 0.0 ? a : b];
  }
  const auto most = std::max_element(votes.begin(), votes.end());
  ClassVote vote{.winner = static_cast<std::size_t>(most - votes.begin()),
                 .margin = std::numeric_limits<double>::infinity()};
  for (std::size_t other = 0; other < num_classes; ++other) {
    if (other == vote.winner) continue;
    const double value = other > vote.winner ? decision_values[PairIndex(vote.winner, other)]
                                             : -decision_values[PairIndex(other, vote.winner)];
    vote.margin = std::min(vote.margin, value);
  }
  return vote;
}

}  // namespace

ClassVote VoteForClass(ClassScheme scheme,
                       std::span<const double> decision_values,
                       std::span<std::int32_t> votes) noexcept {
  if (scheme == ClassScheme::kOneAgainstOne || votes.size() == 2) {
    return VoteOfPairs(decision_values, votes);
  }
  const auto largest = std::max_element(decision_values.begin(), decision_values.end());
  return {.winner = static_cast<std::size_t>(largest - decision_values.begin()),
          .margin = *largest};
}

}  // namespace handcraft::features
