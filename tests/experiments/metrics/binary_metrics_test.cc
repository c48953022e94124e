// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/binary_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

struct Samples {
  std::vector<double> scores;
  std::vector<std::uint8_t> labels;
};

// Sixty samples from whole-number arithmetic, with many ties, which the reference script makes too.
Samples ReferenceSamples() {
  Samples samples;
  for (int i = 0; i < 60; ++i) {
    const int x = (37 * i + 11) % 101;
    const int level = x / 5;
    samples.scores.push_back((level + 0.5) / 21.0);
    samples.labels.push_back((53 * i + 7) % 97 < 40 + x / 4 ? 1 : 0);
  }
  return samples;
}

// Scores on a coarse grid (ties) or a fine one (none).
Samples RandomSamples(std::uint64_t seed, std::size_t count, std::uint64_t levels) {
  Rng rng(seed);
  Samples samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.labels.push_back(static_cast<std::uint8_t>(rng.UniformInt(2)));
    const std::uint64_t level = rng.UniformInt(levels) + samples.labels.back() * levels / 4;
    samples.scores.push_back(static_cast<double>(level) / (2.0 * static_cast<double>(levels)));
  }
  return samples;
}

double BruteForceAuc(const Samples& samples) {
  double wins = 0.0;
  double pairs = 0.0;
  for (std::size_t i = 0; i < samples.scores.size(); ++i) {
    for (std::size_t j = 0; j < samples.scores.size(); ++j) {
      if (samples.labels[i] != 1 || samples.labels[j] != 0) continue;
      pairs += 1.0;
      if (samples.scores[i] > samples.scores[j]) wins += 1.0;
      if (samples.scores[i] == samples.scores[j]) wins += 0.5;
    }
  }
  return wins / pairs;
}

const std::vector<float> kFourScores = {0.9F, 0.6F, 0.6F, 0.1F};
const std::vector<std::uint8_t> kFourLabels = {1, 1, 0, 0};

TEST(ConfusionMatrix, CountsByHand) {
  const std::vector<float> scores = {0.9F, 0.5F, 0.8F, 0.2F, 0.1F};
  const std::vector<std::uint8_t> labels = {1, 1, 0, 0, 0};
  // The sample on the threshold itself is called bad.
  const ConfusionMatrix matrix = CountConfusion(scores, labels, 0.5);
  EXPECT_EQ(matrix.true_positive, 1U);
  EXPECT_EQ(matrix.false_negative, 1U);
  EXPECT_EQ(matrix.false_positive, 1U);
  EXPECT_EQ(matrix.true_negative, 2U);
  EXPECT_DOUBLE_EQ(matrix.Accuracy(), 0.6);
}

TEST(ConfusionMatrix, AddsAndIsNaNWhenEmpty) {
  ConfusionMatrix sum = CountConfusion(kFourScores, kFourLabels, 0.5);
  sum += CountConfusion(kFourScores, kFourLabels, 0.0);
  EXPECT_EQ(sum.Total(), 8U);
  EXPECT_EQ(sum.true_positive, 4U);
  EXPECT_EQ(sum.false_positive, 3U);
  EXPECT_TRUE(std::isnan(ConfusionMatrix{}.Accuracy()));
}

TEST(RocAuc, CountsPairsByHand) {
  // Pairs (good, bad): .9>.6, .9>.1, .6=.6, .6>.1 → 3.5 of 4.
  EXPECT_DOUBLE_EQ(RocAuc(kFourScores, kFourLabels), 0.875);
}

// Reference: scikit-learn 1.2.1
//   x = [(37*i+11)%101 for i in range(60)]; s = [(v//5+0.5)/21 for v in x]
//   y = [int((53*i+7)%97 < 40+x[i]//4) for i in range(60)]
//   roc_auc_score(y, s), log_loss(y, s, eps=1e-15), brier_score_loss(y, s),
//   confusion_matrix(y, np.array(s) > 0.5).ravel()
TEST(BinaryMetrics, AgreeWithScikitLearn) {
  const Samples samples = ReferenceSamples();
  EXPECT_NEAR(RocAuc(samples.scores, samples.labels), 0.6595982142857143, 1e-15);
  EXPECT_NEAR(LogLoss(samples.scores, samples.labels), 0.7106389563156689, 1e-14);
  EXPECT_NEAR(BrierScore(samples.scores, samples.labels), 0.25128495842781556, 1e-15);
  const ConfusionMatrix matrix = CountConfusion(samples.scores, samples.labels, 0.5);
  EXPECT_EQ(matrix.true_negative, 18U);
  EXPECT_EQ(matrix.false_positive, 10U);
  EXPECT_EQ(matrix.false_negative, 15U);
  EXPECT_EQ(matrix.true_positive, 17U);
}

// Reference: scikit-learn 1.2.1, roc_curve(y, s, drop_intermediate=False) of the samples above.
TEST(RocCurve, AgreesWithScikitLearn) {
  const Samples samples = ReferenceSamples();
  const std::vector<RocPoint> curve = RocCurve(samples.scores, samples.labels, 1000);
  ASSERT_EQ(curve.size(), 22U);
  EXPECT_NEAR(curve[4].false_positive_rate, 0.071428571429, 1e-12);
  EXPECT_DOUBLE_EQ(curve[4].true_positive_rate, 0.25);
  EXPECT_NEAR(curve[15].false_positive_rate, 0.607142857143, 1e-12);
  EXPECT_DOUBLE_EQ(curve[15].true_positive_rate, 0.8125);
}

TEST(RocAuc, AgreesWithBruteForceOnRandomSamples) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Samples samples = RandomSamples(seed, 50 + 7 * seed, seed % 2 == 0 ? 8 : 100000);
    EXPECT_NEAR(RocAuc(samples.scores, samples.labels), BruteForceAuc(samples), 1e-14) << seed;
  }
}

TEST(RocAuc, IsInvariantToOrderAndMonotoneMapsAndComplementsUnderNegation) {
  Samples samples = RandomSamples(3, 400, 40);
  const double auc = RocAuc(samples.scores, samples.labels);
  std::vector<double> mapped(samples.scores.size());
  std::vector<double> negated(samples.scores.size());
  std::transform(samples.scores.begin(), samples.scores.end(), mapped.begin(), [](double s) {
    return std::exp(3.0 * s);
  });
  std::transform(samples.scores.begin(), samples.scores.end(), negated.begin(), std::negate<>());
  EXPECT_EQ(RocAuc(mapped, samples.labels), auc);
  EXPECT_NEAR(RocAuc(negated, samples.labels), 1.0 - auc, 1e-15);
  std::reverse(samples.scores.begin(), samples.scores.end());
  std::reverse(samples.labels.begin(), samples.labels.end());
  EXPECT_EQ(RocAuc(samples.scores, samples.labels), auc);
}

TEST(RocCurve, RisesFromOriginToOneAndHasTheAucBelowIt) {
  const Samples samples = RandomSamples(4, 500, 60);
  const std::vector<RocPoint> curve = RocCurve(samples.scores, samples.labels, 100000);
  EXPECT_EQ(curve.front().false_positive_rate, 0.0);
  EXPECT_EQ(curve.front().true_positive_rate, 0.0);
  EXPECT_EQ(curve.back().false_positive_rate, 1.0);
  EXPECT_EQ(curve.back().true_positive_rate, 1.0);
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_GE(curve[i].false_positive_rate, curve[i - 1].false_positive_rate);
    EXPECT_GE(curve[i].true_positive_rate, curve[i - 1].true_positive_rate);
    area += 0.5 * (curve[i].true_positive_rate + curve[i - 1].true_positive_rate) *
            (curve[i].false_positive_rate - curve[i - 1].false_positive_rate);
  }
  EXPECT_NEAR(area, RocAuc(samples.scores, samples.labels), 1e-12);
}

TEST(RocCurve, ThinsToTheWantedNumberAndKeepsBothEnds) {
  const Samples samples = RandomSamples(5, 2000, 100000);
  const std::vector<RocPoint> curve = RocCurve(samples.scores, samples.labels, 50);
  ASSERT_EQ(curve.size(), 50U);
  EXPECT_EQ(curve.front().true_positive_rate, 0.0);
  EXPECT_EQ(curve.back().false_positive_rate, 1.0);
  EXPECT_EQ(RocCurve(samples.scores, samples.labels, 2).size(), 2U);
}

TEST(BinaryMetrics, SingleAndDoublePrecisionAgree) {
  const Samples samples = RandomSamples(6, 300, 16);  // the grid is exact in both
  const std::vector<float> scores(samples.scores.begin(), samples.scores.end());
  EXPECT_EQ(RocAuc(scores, samples.labels), RocAuc(samples.scores, samples.labels));
  EXPECT_EQ(LogLoss(scores, samples.labels), LogLoss(samples.scores, samples.labels));
  EXPECT_EQ(BrierScore(scores, samples.labels), BrierScore(samples.scores, samples.labels));
  EXPECT_EQ(CountConfusion(scores, samples.labels, 0.3).true_positive,
            CountConfusion(samples.scores, samples.labels, 0.3).true_positive);
  EXPECT_EQ(RocCurve(scores, samples.labels, 99).size(),
            RocCurve(samples.scores, samples.labels, 99).size());
}

TEST(LogLoss, ClipsCertainMistakes) {
  const std::vector<std::uint8_t> good = {1};
  EXPECT_NEAR(LogLoss(std::vector<double>{0.0}, good), -std::log(1e-15), 1e-9);
  EXPECT_NEAR(LogLoss(std::vector<double>{1.0}, good), 1e-15, 1e-15);
  EXPECT_NEAR(LogLoss(std::vector<double>{0.25}, good), std::log(4.0), 1e-15);
}

TEST(BinaryMetrics, AreUndefinedOnEmptyAndOneClassInput) {
  const std::vector<float> none;
  const std::vector<std::uint8_t> no_labels;
  EXPECT_TRUE(std::isnan(RocAuc(none, no_labels)));
  EXPECT_TRUE(std::isnan(LogLoss(none, no_labels)));
  EXPECT_TRUE(std::isnan(BrierScore(none, no_labels)));
  EXPECT_TRUE(RocCurve(none, no_labels, 10).empty());
  const std::vector<std::uint8_t> all_good = {1, 1, 1, 1};
  EXPECT_TRUE(std::isnan(RocAuc(kFourScores, all_good)));
  EXPECT_TRUE(RocCurve(kFourScores, all_good, 10).empty());
  EXPECT_GT(LogLoss(kFourScores, all_good), 0.0);
}

TEST(BinaryMetrics, RefuseBadInputAndNameIt) {
  const std::vector<float> with_nan = {0.1F, std::numeric_limits<float>::quiet_NaN(), 0.2F, 0.3F};
  const std::vector<std::uint8_t> three = {1, 0, 1};
  const std::vector<std::uint8_t> wrong = {1, 0, 255, 0};
  EXPECT_THROWS_MESSAGE(RocAuc(kFourScores, three), std::logic_error, HasSubstr("4, 3"));
  EXPECT_THROWS_MESSAGE(RocAuc(with_nan, kFourLabels), std::logic_error, HasSubstr("nan"));
  EXPECT_THROWS_MESSAGE(LogLoss(kFourScores, wrong), std::logic_error, HasSubstr("255"));
  EXPECT_THROWS_MESSAGE(
      RocCurve(kFourScores, kFourLabels, 1), std::logic_error, HasSubstr("max_points"));
}

// Reference: R 4.2.2, prop.test(successes, trials, correct = FALSE)$conf.int
TEST(WilsonInterval, AgreesWithR) {
  struct Case {
    std::size_t successes, trials;
    double low, high;
  };
  for (const Case& c : {Case{8, 10, 0.4901624715366418, 0.9433178485456247},
                        Case{0, 20, 0.0, 0.1611251580528193},
                        Case{20, 20, 0.8388748419471806, 1.0},
                        Case{117, 400, 0.2500620261568490, 0.3388855759918841},
                        Case{1, 3, 0.06149194472039629, 0.79234039919795229}}) {
    const Estimate estimate = WilsonInterval(c.successes, c.trials);
    EXPECT_NEAR(estimate.low, c.low, 1e-14) << c.successes;
    EXPECT_NEAR(estimate.high, c.high, 1e-14) << c.successes;
    EXPECT_DOUBLE_EQ(estimate.value,
                     static_cast<double>(c.successes) / static_cast<double>(c.trials));
  }
}

TEST(WilsonInterval, KnowsNothingWithoutTrials) {
  const Estimate estimate = WilsonInterval(0, 0);
  EXPECT_TRUE(std::isnan(estimate.value));
  EXPECT_EQ(estimate.low, 0.0);
  EXPECT_EQ(estimate.high, 1.0);
  EXPECT_THROWS_MESSAGE(WilsonInterval(3, 2), std::logic_error, HasSubstr("3, 2"));
}

// Thirty of a hundred groups count one: a resample's share is Binomial(100, 0.3) / 100, whose
// percentiles are known. Reference: R 4.2.2, qbinom(c(.025, .975), 100, .3) / 100 = 0.21, 0.39.
TEST(BootstrapOverGroups, FindsThePercentilesOfTheBinomial) {
  const Estimate estimate = BootstrapOverGroups(
      100,
      [](std::span<const std::size_t> groups) {
        return static_cast<double>(std::count_if(
                   groups.begin(), groups.end(), [](std::size_t g) { return g < 30; })) /
               100.0;
      },
      5000,
      1);
  EXPECT_DOUBLE_EQ(estimate.value, 0.3);
  EXPECT_NEAR(estimate.low, 0.21, 0.0101);  // a percentile of 5000 draws may be one count off
  EXPECT_NEAR(estimate.high, 0.39, 0.0101);
}

double MeanIndex(std::span<const std::size_t> groups) {
  double sum = 0.0;
  for (const std::size_t group : groups) sum += static_cast<double>(group);
  return sum / static_cast<double>(groups.size());
}

TEST(BootstrapOverGroups, DependsOnTheSeedAndNotOnThreads) {
  const Estimate one = BootstrapOverGroups(37, MeanIndex, 500, 7, 1);
  const Estimate four = BootstrapOverGroups(37, MeanIndex, 500, 7, 4);
  const Estimate other = BootstrapOverGroups(37, MeanIndex, 500, 8, 1);
  EXPECT_EQ(one.low, four.low);
  EXPECT_EQ(one.high, four.high);
  EXPECT_NE(one.low, other.low);
  EXPECT_EQ(one.value, 18.0);
  EXPECT_LT(one.low, one.value);
  EXPECT_GT(one.high, one.value);
}

TEST(BootstrapOverGroups, LeavesOutResamplesWithoutAResult) {
  const auto nan_without_group_zero = [](std::span<const std::size_t> groups) {
    const bool has_zero = std::find(groups.begin(), groups.end(), 0U) != groups.end();
    return has_zero ? 2.0 : std::numeric_limits<double>::quiet_NaN();
  };
  const Estimate estimate = BootstrapOverGroups(3, nan_without_group_zero, 200, 1);
  EXPECT_EQ(estimate.low, 2.0);
  EXPECT_EQ(estimate.high, 2.0);
}

TEST(BootstrapOverGroups, OneGroupNoGroupNoResample) {
  EXPECT_EQ(BootstrapOverGroups(1, MeanIndex, 100, 1).value, 0.0);
  EXPECT_TRUE(std::isnan(BootstrapOverGroups(1, MeanIndex, 100, 1).high));
  EXPECT_TRUE(std::isnan(BootstrapOverGroups(0, MeanIndex, 100, 1).value));
  const Estimate no_resample = BootstrapOverGroups(3, MeanIndex, 0, 1);
  EXPECT_EQ(no_resample.value, 1.0);
  EXPECT_TRUE(std::isnan(no_resample.low));
}

}  // namespace
}  // namespace handcraft::experiments
