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
  [[nodiscard]] std::size_t NumGood() const noexcept { return true_positive + false_negative; }
  [[nodiscard]] std::size_t NumBad() const noexcept { return false_positive + true_negative; }
  [[nodiscard]] double Accuracy() const noexcept;  ///< NaN when empty
  ConfusionMatrix& operator+=(const ConfusionMatrix& other) noexcept;
};

/// Every function below takes single- or double-precision scores and labels 0 (bad) or 1 (good) of
/// the same length. Throws std::logic_error when the lengths differ, a score is NaN or a label is
/// neither 0 nor 1. Allocates at most O(n). Thread-safe, deterministic.

/// Positive means score > threshold.
[[nodiscard]] ConfusionMatrix CountConfusion(std::span<const float> scores,
                                             std::span<const std::uint8_t> labels,
                                             double threshold);
[[nodiscard]] ConfusionMatrix CountConfusion(std::span<const double> scores,
                                             std::span<const std::uint8_t> labels,
                                             double threshold);

/// Area under the ROC curve: the chance that a good sample scores above a bad one, ties one half
/// (Mann–Whitney). Counted in integers, hence exact; O(n log n). NaN when a class is missing.
/// Source: Hanley and McNeil 1982, "The meaning and use of the area under a ROC curve".
[[nodiscard]] double RocAuc(std::span<const float> scores, std::span<const std::uint8_t> labels);
[[nodiscard]] double RocAuc(std::span<const double> scores, std::span<const std::uint8_t> labels);

struct RocPoint {
  double false_positive_rate = 0.0;
  double true_positive_rate = 0.0;
};
/// The curve from (0, 0) to (1, 1), one point a distinct score, thinned to at most max_points ≥ 2
/// of them with both ends kept. Empty when a class is missing.
[[nodiscard]] std::vector<RocPoint> RocCurve(std::span<const float> scores,
                                             std::span<const std::uint8_t> labels,
                                             std::size_t max_points);
[[nodiscard]] std::vector<RocPoint> RocCurve(std::span<const double> scores,
                                             std::span<const std::uint8_t> labels,
                                             std::size_t max_points);

/// Mean log-loss, −mean(y ln p + (1 − y) ln(1 − p)), probabilities clipped to
/// [1e-15, 1 − 1e-15]; and mean squared error, mean((p − y)²) (Brier 1950). NaN when empty.
[[nodiscard]] double LogLoss(std::span<const float> probabilities,
                             std::span<const std::uint8_t> labels);
[[nodiscard]] double LogLoss(std::span<const double> probabilities,
                             std::span<const std::uint8_t> labels);
[[nodiscard]] double BrierScore(std::span<const float> probabilities,
                                std::span<const std::uint8_t> labels);
[[nodiscard]] double BrierScore(std::span<const double> probabilities,
                                std::span<const std::uint8_t> labels);

/// Wilson score interval of a proportion, 95 %. No trials: value NaN, interval [0, 1].
/// Throws std::logic_error when successes > trials.
/// Source: Wilson 1927, "Probable inference, the law of succession, and statistical inference".
[[nodiscard]] Estimate WilsonInterval(std::size_t successes, std::size_t trials);

/// The groups of a resample: as many as there are, drawn with replacement from the random stream
/// (seed, resample).
[[nodiscard]] std::vector<std::size_t> DrawGroups(std::size_t num_groups,
                                                  std::uint64_t seed,
                                                  std::size_t resample);

/// The interval of BootstrapOverGroups from what the statistic was on the resamples.
[[nodiscard]] Estimate PercentileEstimate(double value, std::vector<double> of_resamples);

/// Percentile bootstrap over groups (images): `statistic` maps a resampled list of num_groups group
/// indices to a number. The value is the statistic of all groups; the interval runs from the 2.5th
/// to the 97.5th percentile of the resamples (linear interpolation), NaN results left out.
/// Everything is NaN without groups; the interval is with one group (nothing varies) or when no
/// resample gives a number.
///
/// Resample r draws from a random stream of its own, (seed, r), so the result does not depend on
/// num_threads; with more than one, `statistic` is called from several threads at once.
/// Source: Efron and Tibshirani 1993, "An Introduction to the Bootstrap", chapter 13.
[[nodiscard]] Estimate BootstrapOverGroups(
    std::size_t num_groups,
    const std::function<double(std::span<const std::size_t>)>& statistic,
    std::size_t num_resamples,
    std::uint64_t seed,
    int num_threads = 1);

}  // namespace handcraft::experiments
