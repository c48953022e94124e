// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace handcraft::experiments {

/// A number with its 95 % interval.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct ConfusionMatrix {
  std::size_t true_positive = 0;
  std::size_t false_positive = 0;
  std::size_t true_negative = 0;
  std::size_t false_negative = 0;

  [[nodiscard]] std::size_t Total() const noexcept {
    return true_positive + false_positive + true_negative + false_negative;
  }
  [[nodiscard]] double Accuracy() const noexcept;  ///< NaN when empty
  ConfusionMatrix& operator+=(const ConfusionMatrix& other) noexcept;
};

/// Positive means score > threshold.
[[nodiscard]] ConfusionMatrix CountConfusion(std::span<const float> scores,
                                             std::span<const std::uint8_t> labels,
                                             double threshold);

/// Area under the ROC curve: the chance that a good sample scores above a bad one, ties one half
/// (Mann–Whitney). O(n log n). NaN when a class is missing.
[[nodiscard]] double RocAuc(std::span<const float> scores, std::span<const std::uint8_t> labels);

struct RocPoint {
  double false_positive_rate = 0.0;
  double true_positive_rate = 0.0;
};
/// The curve thinned to at most max_points points, both ends kept.
[[nodiscard]] std::vector<RocPoint> RocCurve(std::span<const float> scores,
                                             std::span<const std::uint8_t> labels,
                                             std::size_t max_points);

/// Mean log-loss, probabilities clipped to [1e-15, 1 − 1e-15]; and mean squared error (Brier).
[[nodiscard]] double LogLoss(std::span<const float> probabilities,
                             std::span<const std::uint8_t> labels);
[[nodiscard]] double BrierScore(std::span<const float> probabilities,
                                std::span<const std::uint8_t> labels);

/// Wilson score interval of a proportion (Wilson 1927), 95 %.
[[nodiscard]] Estimate WilsonInterval(std::size_t successes, std::size_t trials);

/// Percentile bootstrap over groups (images): `statistic` maps a resampled list of group indices to
/// a number (NaN results are left out). 95 %, seeded.
[[nodiscard]] Estimate BootstrapOverGroups(
    std::size_t num_groups,
    const std::function<double(std::span<const std::size_t>)>& statistic,
    std::size_t num_resamples,
    std::uint64_t seed);

}  // namespace handcraft::experiments
