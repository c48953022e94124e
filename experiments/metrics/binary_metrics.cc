// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/binary_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/parallel.h"
#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class T>
void CheckSamples(std::span<const T> scores, std::span<const std::uint8_t> labels) {
  HC_CHECK(scores.size() == labels.size(), scores.size(), labels.size());
  for (std::size_t i = 0; i < scores.size(); ++i) {
    HC_CHECK(!std::isnan(scores[i]), i, scores[i]);
    HC_CHECK(labels[i] <= 1, i, static_cast<int>(labels[i]));
  }
}

// Samples that share a score, with the numbers of each class up to and including them.
struct TieGroup {
  std::size_t good = 0;
  std::size_t bad = 0;
  std::size_t good_so_far = 0;
  std::size_t bad_so_far = 0;
};

// Tie groups by descending score.
template <class T>
std::vector<TieGroup> DescendingTieGroups(std::span<const T> scores,
                                          std::span<const std::uint8_t> labels) {
  CheckSamples(scores, labels);
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a] > scores[b];
  });
  std::vector<TieGroup> groups;
  TieGroup current;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_good = labels[order[k]] == 1;
    current.good += is_good ? 1 : 0;
    current.bad += is_good ? 0 : 1;
    const bool is_last = k + 1 == order.size() || scores[order[k + 1]] != scores[order[k]];
    if (!is_last) continue;
    current.good_so_far += current.good;
    current.bad_so_far += current.bad;
    groups.push_back(current);
    current.good = 0;
    current.bad = 0;
  }
  return groups;
}

template <class T>
ConfusionMatrix CountConfusionOf(std::span<const T> scores,
                                 std::span<const std::uint8_t> labels,
                                 double threshold) {
  CheckSamples(scores, labels);
  ConfusionMatrix matrix;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const bool is_called_good = static_cast<double>(scores[i]) > threshold;
    if (labels[i] == 1) {
      ++(is_called_good ? matrix.true_positive : matrix.false_negative);
    } else {
      ++(is_called_good ? matrix.false_positive : matrix.true_negative);
    }
  }
  return matrix;
}

template <class T>
double RocAucOf(std::span<const T> scores, std::span<const std::uint8_t> labels) {
  const std::vector<TieGroup> groups = DescendingTieGroups(scores, labels);
  if (groups.empty()) return kNaN;
  const std::size_t num_good = groups.back().good_so_far;
  const std::size_t num_bad = groups.back().bad_so_far;
  if (num_good == 0 || num_bad == 0) return kNaN;
  // Twice Mann–Whitney's U: each good sample beats the bad ones below it and half beats its ties.
  std::uint64_t twice_wins = 0;
  for (const TieGroup& group : groups) {
    const std::size_t bad_below = num_bad - group.bad_so_far;
    twice_wins += std::uint64_t{group.good} * (2 * bad_below + group.bad);
  }
  return static_cast<double>(twice_wins) /
         (2.0 * static_cast<double>(num_good) * static_cast<double>(num_bad));
}

template <class T>
std::vector<RocPoint> RocCurveOf(std::span<const T> scores,
                                 std::span<const std::uint8_t> labels,
                                 std::size_t max_points) {
  HC_CHECK(max_points >= 2, max_points);
  const std::vector<TieGroup> groups = DescendingTieGroups(scores, labels);
  if (groups.empty() || groups.back().good_so_far == 0 || groups.back().bad_so_far == 0) return {};
  const auto num_good = static_cast<double>(groups.back().good_so_far);
  const auto num_bad = static_cast<double>(groups.back().bad_so_far);
  // Point 0 is the origin, point i the state after tie group i.
  const std::size_t last = groups.size();
  const std::size_t num_kept = std::min(max_points, last + 1);
  std::vector<RocPoint> curve;
  curve.reserve(num_kept);
  for (std::size_t k = 0; k < num_kept; ++k) {
    const std::size_t i = k * last / (num_kept - 1);
    if (i == 0) {
      curve.push_back({0.0, 0.0});
      continue;
    }
    const TieGroup& group = groups[i - 1];
    curve.push_back({static_cast<double>(group.bad_so_far) / num_bad,
                     static_cast<double>(group.good_so_far) / num_good});
  }
  return curve;
}

template <class T>
double LogLossOf(std::span<const T> probabilities, std::span<const std::uint8_t> labels) {
  constexpr double kClip = 1e-15;
  CheckSamples(probabilities, labels);
  if (probabilities.empty()) return kNaN;
  double sum = 0.0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double p = std::clamp(static_cast<double>(probabilities[i]), kClip, 1.0 - kClip);
    sum -= labels[i] == 1 ? std::log(p) : std::log1p(-p);
  }
  return sum / static_cast<double>(probabilities.size());
}

template <class T>
double BrierScoreOf(std::span<const T> probabilities, std::span<const std::uint8_t> labels) {
  CheckSamples(probabilities, labels);
  if (probabilities.empty()) return kNaN;
  double sum = 0.0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double error = static_cast<double>(probabilities[i]) - labels[i];
    sum += error * error;
  }
  return sum / static_cast<double>(probabilities.size());
}

// Percentile of ascending values with linear interpolation (type 7 of Hyndman and Fan 1996).
double PercentileOfSorted(const std::vector<double>& sorted, double share) {
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double fraction = position - static_cast<double>(below);
  return sorted[below] + fraction * (sorted[below + 1] - sorted[below]);
}

}  // namespace

double ConfusionMatrix::Accuracy() const noexcept {
  if (Total() == 0) return kNaN;
  return static_cast<double>(true_positive + true_negative) / static_cast<double>(Total());
}

ConfusionMatrix& ConfusionMatrix::operator+=(const ConfusionMatrix& other) noexcept {
  true_positive += other.true_positive;
  false_positive += other.false_positive;
  true_negative += other.true_negative;
  false_negative += other.false_negative;
  return *this;
}

ConfusionMatrix CountConfusion(std::span<const float> scores,
                               std::span<const std::uint8_t> labels,
                               double threshold) {
  return CountConfusionOf(scores, labels, threshold);
}

ConfusionMatrix CountConfusion(std::span<const double> scores,
                               std::span<const std::uint8_t> labels,
                               double threshold) {
  return CountConfusionOf(scores, labels, threshold);
}

double RocAuc(std::span<const float> scores, std::span<const std::uint8_t> labels) {
  return RocAucOf(scores, labels);
}

double RocAuc(std::span<const double> scores, std::span<const std::uint8_t> labels) {
  return RocAucOf(scores, labels);
}

std::vector<RocPoint> RocCurve(std::span<const float> scores,
                               std::span<const std::uint8_t> labels,
                               std::size_t max_points) {
  return RocCurveOf(scores, labels, max_points);
}

std::vector<RocPoint> RocCurve(std::span<const double> scores,
                               std::span<const std::uint8_t> labels,
                               std::size_t max_points) {
  return RocCurveOf(scores, labels, max_points);
}

double LogLoss(std::span<const float> probabilities, std::span<const std::uint8_t> labels) {
  return LogLossOf(probabilities, labels);
}

double LogLoss(std::span<const double> probabilities, std::span<const std::uint8_t> labels) {
  return LogLossOf(probabilities, labels);
}

double BrierScore(std::span<const float> probabilities, std::span<const std::uint8_t> labels) {
  return BrierScoreOf(probabilities, labels);
}

double BrierScore(std::span<const double> probabilities, std::span<const std::uint8_t> labels) {
  return BrierScoreOf(probabilities, labels);
}

Estimate WilsonInterval(std::size_t successes, std::size_t trials) {
  HC_CHECK(successes <= trials, successes, trials);
  if (trials == 0) return {kNaN, 0.0, 1.0};
  constexpr double kZ = 1.959963984540054;  // 97.5th percentile of the standard normal
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double denominator = 1.0 + kZ * kZ / n;
  const double centre = (p + kZ * kZ / (2.0 * n)) / denominator;
  const double half_width =
      kZ * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n)) / denominator;
  // Exactly 0 and 1 at the ends, where rounding would leave a hair.
  return {p,
          successes == 0 ? 0.0 : centre - half_width,
          successes == trials ? 1.0 : centre + half_width};
}

std::vector<std::size_t> DrawGroups(std::size_t num_groups,
                                    std::uint64_t seed,
                                    std::size_t resample) {
  Rng rng = Rng::Stream(seed, "bootstrap", resample);
  std::vector<std::size_t> drawn(num_groups);
  for (std::size_t& group : drawn) group = rng.UniformInt(num_groups);
  return drawn;
}

Estimate PercentileEstimate(double value, std::vector<double> of_resamples) {
  std::erase_if(of_resamples, [](double result) { return std::isnan(result); });
  if (of_resamples.empty()) return {value, kNaN, kNaN};
  std::sort(of_resamples.begin(), of_resamples.end());
  return {value, PercentileOfSorted(of_resamples, 0.025), PercentileOfSorted(of_resamples, 0.975)};
}

Estimate BootstrapOverGroups(std::size_t num_groups,
                             const std::function<double(std::span<const std::size_t>)>& statistic,
                             std::size_t num_resamples,
                             std::uint64_t seed,
                             int num_threads) {
  if (num_groups == 0) return {kNaN, kNaN, kNaN};
  std::vector<std::size_t> all(num_groups);
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (num_groups == 1) return {statistic(all), kNaN, kNaN};
  std::vector<double> results(num_resamples);
  ParallelFor(num_resamples, num_threads, [&](std::size_t resample) {
    results[resample] = statistic(DrawGroups(num_groups, seed, resample));
  });
  return PercentileEstimate(statistic(all), std::move(results));
}

}  // namespace handcraft::experiments
