// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/curve_bands.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kNumResamples = 60;
constexpr std::uint64_t kSeed = 5;

struct Samples {
  std::vector<double> scores;
  std::vector<std::uint8_t> labels;
  std::vector<std::size_t> groups;
};

// Good samples score higher, by more in some groups than in others; `num_scores` of them differ.
Samples RandomSamples(std::size_t num_samples, std::size_t num_groups, std::size_t num_scores) {
  Rng rng(2);
  Samples samples;
  for (std::size_t i = 0; i < num_samples; ++i) {
    const std::size_t group = rng.UniformInt(num_groups);
    const bool is_good = rng.UniformInt(3) == 0;
    const std::size_t score = rng.UniformInt(num_scores) + (is_good ? group * num_scores / 40 : 0);
    samples.scores.push_back(static_cast<double>(score));
    samples.labels.push_back(is_good ? 1 : 0);
    samples.groups.push_back(group);
  }
  return samples;
}

GroupedRanking RankingOf(const Samples& samples, std::size_t num_groups) {
  return {samples.scores, samples.labels, samples.groups, num_groups};
}

// The definition: of the samples of a resample that score at least `lowest`, good and bad.
struct Above {
  double good = 0.0;
  double bad = 0.0;
};
Above CountAbove(const Samples& samples, const std::vector<double>& times, double lowest) {
  Above above;
  for (std::size_t i = 0; i < samples.scores.size(); ++i) {
    if (samples.scores[i] < lowest) continue;
    (samples.labels[i] == 1 ? above.good : above.bad) += times[samples.groups[i]];
  }
  return above;
}

// True positive rate at a false positive rate, from every cut between scores, straight between.
double RateByDefinition(const std::vector<Above>& cuts, double false_positive_rate) {
  const Above& all = cuts.back();
  const double wanted = false_positive_rate * all.bad;
  std::size_t k = 0;
  while (k + 1 < cuts.size() && cuts[k + 1].bad <= wanted) ++k;
  if (k + 1 == cuts.size()) return 1.0;
  const double share = (wanted - cuts[k].bad) / (cuts[k + 1].bad - cuts[k].bad);
  return (cuts[k].good + share * (cuts[k + 1].good - cuts[k].good)) / all.good;
}

double PrecisionByDefinition(const std::vector<Above>& cuts, double recall) {
  const double wanted = recall * cuts.back().good;
  std::size_t k = 0;
  while (cuts[k + 1].good < wanted) ++k;
  const double share = (wanted - cuts[k].good) / (cuts[k + 1].good - cuts[k].good);
  const double bad = cuts[k].bad + share * (cuts[k + 1].bad - cuts[k].bad);
  return wanted / (wanted + bad);
}

template <class Value>
Estimate ByDefinition(const Samples& samples, std::size_t num_groups, const Value& value) {
  return BootstrapOverGroups(
      num_groups,
      [&](std::span<const std::size_t> drawn) {
        std::vector<double> times(num_groups);
        for (const std::size_t group : drawn) times[group] += 1.0;
        std::vector<Above> cuts = {{}};
        for (double lowest = 100.0; lowest >= 0.0; lowest -= 1.0) {
          cuts.push_back(CountAbove(samples, times, lowest));
        }
        return value(cuts);
      },
      kNumResamples,
      kSeed);
}

TEST(BootstrapCurveBands, AreTheBootstrapOfTheCurvesWrittenOut) {
  constexpr std::size_t kNumGroups = 8;
  const Samples samples = RandomSamples(400, kNumGroups, 40);
  const CurveBands bands =
      BootstrapCurveBands(RankingOf(samples, kNumGroups), kNumResamples, kSeed, 1);
  ASSERT_EQ(bands.roc.size(), 101U);
  ASSERT_EQ(bands.precision_recall.size(), 100U);
  for (const std::size_t k : {0U, 1U, 7U, 50U, 99U, 100U}) {
    const Estimate rate = ByDefinition(samples, kNumGroups, [k](const std::vector<Above>& cuts) {
      return RateByDefinition(cuts, static_cast<double>(k) / 100.0);
    });
    EXPECT_DOUBLE_EQ(bands.roc[k].x, static_cast<double>(k) / 100.0);
    EXPECT_NEAR(bands.roc[k].low, rate.low, 1e-12) << k;
    EXPECT_NEAR(bands.roc[k].high, rate.high, 1e-12) << k;
  }
  for (const std::size_t k : {1U, 5U, 50U, 100U}) {
    const Estimate precision =
        ByDefinition(samples, kNumGroups, [k](const std::vector<Above>& cuts) {
          return PrecisionByDefinition(cuts, static_cast<double>(k) / 100.0);
        });
    const BandPoint& point = bands.precision_recall[k - 1];
    EXPECT_DOUBLE_EQ(point.x, static_cast<double>(k) / 100.0);
    EXPECT_NEAR(point.low, precision.low, 1e-12) << k;
    EXPECT_NEAR(point.high, precision.high, 1e-12) << k;
  }
}

// More scores than pieces: the band moves by less than a piece.
TEST(BootstrapCurveBands, HoldTheCurveOfManyScores) {
  constexpr std::size_t kNumGroups = 12;
  const Samples samples = RandomSamples(6000, kNumGroups, 1000000);
  const CurveBands bands =
      BootstrapCurveBands(RankingOf(samples, kNumGroups), kNumResamples, kSeed, 1);
  for (const RocPoint& point :
       RocCurve(std::span<const double>(samples.scores), samples.labels, 200)) {
    const auto k = static_cast<std::size_t>(std::lround(100.0 * point.false_positive_rate));
    if (k == 0 || k == 100) continue;
    EXPECT_GE(point.true_positive_rate, bands.roc[k - 1].low - 0.01) << k;
    EXPECT_LE(point.true_positive_rate, bands.roc[k + 1].high + 0.01) << k;
  }
  EXPECT_EQ(bands.roc.back().low, 1.0);
}

TEST(BootstrapCurveBands, DoNotDependOnTheNumberOfThreads) {
  const Samples samples = RandomSamples(300, 5, 40);
  const CurveBands one = BootstrapCurveBands(RankingOf(samples, 5), kNumResamples, kSeed, 1);
  const CurveBands three = BootstrapCurveBands(RankingOf(samples, 5), kNumResamples, kSeed, 3);
  for (std::size_t k = 0; k < one.roc.size(); ++k) {
    EXPECT_EQ(one.roc[k].low, three.roc[k].low);
    EXPECT_EQ(one.roc[k].high, three.roc[k].high);
  }
}

TEST(BootstrapCurveBands, AreEmptyWhereNothingVariesOrAKindIsMissing) {
  const Samples samples = RandomSamples(50, 1, 40);
  EXPECT_TRUE(BootstrapCurveBands(RankingOf(samples, 1), kNumResamples, kSeed, 1).roc.empty());
  Samples good = RandomSamples(50, 3, 40);
  good.labels.assign(good.labels.size(), 1);
  EXPECT_TRUE(
      BootstrapCurveBands(RankingOf(good, 3), kNumResamples, kSeed, 1).precision_recall.empty());
  EXPECT_TRUE(BootstrapCurveBands(RankingOf({}, 3), kNumResamples, kSeed, 1).roc.empty());
}

// One group has the good samples, the other the bad ones: half of the resamples have no curve.
TEST(BootstrapCurveBands, LeaveOutResamplesOfOneKind) {
  const Samples samples{{0.9, 0.1}, {1, 0}, {0, 1}};
  const CurveBands bands = BootstrapCurveBands(RankingOf(samples, 2), kNumResamples, kSeed, 1);
  for (const BandPoint& point : bands.roc) EXPECT_EQ(point.low, 1.0);
  for (const BandPoint& point : bands.precision_recall) EXPECT_EQ(point.low, 1.0);
}

}  // namespace
}  // namespace handcraft::experiments
