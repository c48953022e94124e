// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

struct RankingEstimates {
  Estimate auc;
  Estimate average_precision;
};

/// A sample among all of a ranking, the highest score first.
struct RankedSample {
  std::uint32_t group = 0;
  bool is_good = false;
  bool ends_tie = false;  ///< the next sample has a lower score, or there is none
};

/// Figures of the order of scores, of resampled groups (images): what the bootstrap asks for a
/// thousand times. The samples are sorted once; resamples then take a linear pass, eight at a time,
/// in which a sample counts as often as its group was drawn.
///
/// Immutable after construction: the figures may be asked for from many threads. They are NaN when
/// a class is missing, take O(n) and allocate num_groups counts a resample. Throws std::logic_error
/// on a drawn group out of range.
class GroupedRanking {
 public:
  /// Sample i belongs to group groups[i] < num_groups. Throws std::logic_error on lengths that
  /// differ, NaN scores, labels other than 0/1, or a group out of range. O(n log n).
  GroupedRanking(std::span<const double> scores,
                 std::span<const std::uint8_t> labels,
                 std::span<const std::size_t> groups,
                 std::size_t num_groups);

  /// Area under the ROC curve of the listed groups, repeats counted: exactly RocAuc of the samples
  /// written out, while twice the pairs of a good and a bad sample are below 2⁵³.
  [[nodiscard]] double Auc(std::span<const std::size_t> drawn_groups) const;

  /// Average precision of the same, Σ_k (R_k − R_{k−1}) P_k over the distinct scores from the
  /// highest down, with R_k the recall and P_k the precision of the samples above or at it. No
  /// interpolation. Guessing gives the share of good samples.
  /// Source: Manning, Raghavan and Schütze 2008, "Introduction to Information Retrieval", sec. 8.4.
  [[nodiscard]] double AveragePrecision(std::span<const std::size_t> drawn_groups) const;

  /// Both with their 95 % intervals: bit for bit what BootstrapOverGroups makes of the two, for any
  /// number of threads.
  [[nodiscard]] RankingEstimates Bootstrap(std::size_t num_resamples,
                                           std::uint64_t seed,
                                           int num_threads) const;

  /// All samples by descending score, as long as this object lives.
  [[nodiscard]] std::span<const RankedSample> Descending() const noexcept { return descending_; }
  [[nodiscard]] std::size_t num_groups() const noexcept { return num_groups_; }

 private:
  struct Ranks {
    double auc = 0.0;
    double average_precision = 0.0;
  };
  template <std::size_t kLanes>
  using Lanes = std::array<double, kLanes>;
  template <std::size_t kLanes>
  [[nodiscard]] std::array<Ranks, kLanes> RanksOf(std::span<const Lanes<kLanes>> times_drawn) const;
  [[nodiscard]] Ranks RanksOfOne(std::span<const std::size_t> drawn_groups) const;

  std::vector<RankedSample> descending_;
  std::size_t num_groups_;
};

}  // namespace handcraft::experiments
