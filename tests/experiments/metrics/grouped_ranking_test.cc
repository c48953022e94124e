// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/grouped_ranking.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/metrics/binary_metrics.h"
#include "experiments/metrics/precision_recall.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

TEST(GroupedRanking, CountsRepeatedGroupsByHand) {
  // Group 0: good .9, bad .5; group 1: good .5, bad .1.
  const std::vector<double> scores = {0.9, 0.5, 0.5, 0.1};
  const std::vector<std::uint8_t> labels = {1, 0, 1, 0};
  const std::vector<std::size_t> groups = {0, 0, 1, 1};
  const GroupedRanking ranking(scores, labels, groups, 2);
  EXPECT_DOUBLE_EQ(ranking.Auc(std::vector<std::size_t>{0, 1}), 3.5 / 4.0);
  EXPECT_DOUBLE_EQ(ranking.Auc(std::vector<std::size_t>{1}), 1.0);
  // Two of group 0, one of group 1: 9 pairs, of which the two (.5, .5) are ties.
  EXPECT_DOUBLE_EQ(ranking.Auc(std::vector<std::size_t>{0, 1, 0}), 8.0 / 9.0);
}

TEST(GroupedRanking, EqualsRocAucOfTheSamplesWrittenOut) {
  constexpr std::size_t kNumGroups = 9;
  Rng rng(1);
  std::vector<double> scores;
  std::vector<std::uint8_t> labels;
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < 400; ++i) {
    scores.push_back(static_cast<double>(rng.UniformInt(30)) / 30.0);
    labels.push_back(static_cast<std::uint8_t>(rng.UniformInt(2)));
    groups.push_back(rng.UniformInt(kNumGroups));
  }
  const GroupedRanking ranking(scores, labels, groups, kNumGroups);
  for (int repeat = 0; repeat < 30; ++repeat) {
    std::vector<std::size_t> drawn(kNumGroups);
    std::vector<double> resampled_scores;
    std::vector<std::uint8_t> resampled_labels;
    for (std::size_t& group : drawn) {
      group = rng.UniformInt(kNumGroups);
      for (std::size_t i = 0; i < scores.size(); ++i) {
        if (groups[i] != group) continue;
        resampled_scores.push_back(scores[i]);
        resampled_labels.push_back(labels[i]);
      }
    }
    EXPECT_EQ(ranking.Auc(drawn), RocAuc(resampled_scores, resampled_labels));
  }
}

// Bit for bit, with ties, groups of one class, a last batch that is not full, and any threads.
TEST(GroupedRanking, BootstrapsAsOneResampleAfterTheOther) {
  for (const std::size_t num_groups : {std::size_t{1}, std::size_t{2}, std::size_t{13}}) {
    Rng rng = Rng::Stream(3, "ranking", num_groups);
    std::vector<double> scores;
    std::vector<std::uint8_t> labels;
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < 300; ++i) {
      groups.push_back(rng.UniformInt(num_groups));
      scores.push_back(static_cast<double>(rng.UniformInt(200)));
      labels.push_back(groups.back() == 1 ? 1 : static_cast<std::uint8_t>(rng.UniformInt(2)));
    }
    const GroupedRanking ranking(scores, labels, groups, num_groups);
    const auto expect_equal = [&](const Estimate& batched, auto figure) {
      const Estimate single = BootstrapOverGroups(
          num_groups,
          [&](std::span<const std::size_t> drawn) { return (ranking.*figure)(drawn); },
          43,
          7);
      EXPECT_EQ(batched.value, single.value) << num_groups;
      for (double Estimate::*end : {&Estimate::low, &Estimate::high}) {
        const bool are_none = std::isnan(batched.*end) && std::isnan(single.*end);
        EXPECT_TRUE(are_none || batched.*end == single.*end) << num_groups;
      }
    };
    for (const int num_threads : {1, 2}) {
      const RankingEstimates estimates = ranking.Bootstrap(43, 7, num_threads);
      expect_equal(estimates.auc, &GroupedRanking::Auc);
      expect_equal(estimates.average_precision, &GroupedRanking::AveragePrecision);
    }
  }
}

TEST(GroupedRanking, AveragesPrecisionByHand) {
  // Group 0: good .9, bad .8; group 1: good .5, bad .5.
  const std::vector<double> scores = {0.9, 0.8, 0.5, 0.5};
  const std::vector<std::uint8_t> labels = {1, 0, 1, 0};
  const std::vector<std::size_t> groups = {0, 0, 1, 1};
  const GroupedRanking ranking(scores, labels, groups, 2);
  // Recall 1/2 at precision 1, then 1 at 2 of 4.
  EXPECT_DOUBLE_EQ(ranking.AveragePrecision(std::vector<std::size_t>{0, 1}), 0.5 + 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(ranking.AveragePrecision(std::vector<std::size_t>{0}), 1.0);
  // Twice group 0: recall 2/3 at 2 of 2, then 1 at 3 of 6.
  EXPECT_DOUBLE_EQ(ranking.AveragePrecision(std::vector<std::size_t>{0, 1, 0}),
                   2.0 / 3.0 + 1.0 / 3.0 * 0.5);
}

TEST(GroupedRanking, HasTheAveragePrecisionOfTheCurve) {
  Rng rng(4);
  std::vector<float> scores;
  std::vector<std::uint8_t> labels;
  for (std::size_t i = 0; i < 300; ++i) {
    scores.push_back(static_cast<float>(rng.UniformInt(40)) / 64.0F);
    labels.push_back(static_cast<std::uint8_t>(rng.UniformInt(2)));
  }
  const std::vector<std::size_t> groups(scores.size(), 0);
  const std::vector<double> as_double(scores.begin(), scores.end());
  const GroupedRanking ranking(as_double, labels, groups, 1);
  double area = 0.0;
  double recall = 0.0;
  for (const PrecisionRecallPoint& point : PrecisionRecallCurve(scores, labels, 1000)) {
    area += (point.recall - recall) * point.precision;
    recall = point.recall;
  }
  EXPECT_NEAR(ranking.AveragePrecision(std::vector<std::size_t>{0}), area, 1e-12);
}

TEST(GroupedRanking, IsUndefinedWithoutBothClasses) {
  const std::vector<double> scores = {0.9, 0.5};
  const std::vector<std::uint8_t> labels = {1, 0};
  const std::vector<std::size_t> groups = {0, 1};
  const GroupedRanking ranking(scores, labels, groups, 2);
  EXPECT_TRUE(std::isnan(ranking.Auc(std::vector<std::size_t>{0, 0})));
  EXPECT_TRUE(std::isnan(ranking.Auc(std::vector<std::size_t>{})));
  EXPECT_TRUE(std::isnan(ranking.AveragePrecision(std::vector<std::size_t>{0, 0})));
  EXPECT_TRUE(std::isnan(ranking.AveragePrecision(std::vector<std::size_t>{1})));
  EXPECT_TRUE(std::isnan(GroupedRanking({}, {}, {}, 0).Auc({})));
}

TEST(GroupedRanking, RefusesBadInputAndNamesIt) {
  const std::vector<double> scores = {0.9, 0.5};
  const std::vector<double> with_nan = {0.9, std::numeric_limits<double>::quiet_NaN()};
  const std::vector<std::uint8_t> labels = {1, 0};
  const std::vector<std::size_t> groups = {0, 1};
  EXPECT_THROWS_MESSAGE(
      GroupedRanking(with_nan, labels, groups, 2), std::logic_error, HasSubstr("1"));
  EXPECT_THROWS_MESSAGE(
      GroupedRanking(scores, labels, groups, 1), std::logic_error, HasSubstr("num_groups"));
  EXPECT_THROWS_MESSAGE(GroupedRanking(scores, {}, groups, 2), std::logic_error, HasSubstr("2, 0"));
  const GroupedRanking ranking(scores, labels, groups, 2);
  EXPECT_THROWS_MESSAGE(
      ranking.Auc(std::vector<std::size_t>{5}), std::logic_error, HasSubstr("5, 2"));
}

}  // namespace
}  // namespace handcraft::experiments
