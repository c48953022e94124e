// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/grouped_auc.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/metrics/binary_metrics.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

TEST(GroupedAuc, CountsRepeatedGroupsByHand) {
  // Group 0: good .9, bad .5; group 1: good .5, bad .1.
  const std::vector<double> scores = {0.9, 0.5, 0.5, 0.1};
  const std::vector<std::uint8_t> labels = {1, 0, 1, 0};
  const std::vector<std::size_t> groups = {0, 0, 1, 1};
  const GroupedAuc auc(scores, labels, groups, 2);
  EXPECT_DOUBLE_EQ(auc.OfResample(std::vector<std::size_t>{0, 1}), 3.5 / 4.0);
  EXPECT_DOUBLE_EQ(auc.OfResample(std::vector<std::size_t>{1}), 1.0);
  // Two of group 0, one of group 1: 9 pairs, of which the two (.5, .5) are ties.
  EXPECT_DOUBLE_EQ(auc.OfResample(std::vector<std::size_t>{0, 1, 0}), 8.0 / 9.0);
}

TEST(GroupedAuc, EqualsRocAucOfTheSamplesWrittenOut) {
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
  const GroupedAuc auc(scores, labels, groups, kNumGroups);
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
    EXPECT_EQ(auc.OfResample(drawn), RocAuc(resampled_scores, resampled_labels));
  }
}

TEST(GroupedAuc, IsUndefinedWithoutBothClasses) {
  const std::vector<double> scores = {0.9, 0.5};
  const std::vector<std::uint8_t> labels = {1, 0};
  const std::vector<std::size_t> groups = {0, 1};
  const GroupedAuc auc(scores, labels, groups, 2);
  EXPECT_TRUE(std::isnan(auc.OfResample(std::vector<std::size_t>{0, 0})));
  EXPECT_TRUE(std::isnan(auc.OfResample(std::vector<std::size_t>{})));
  EXPECT_TRUE(std::isnan(GroupedAuc({}, {}, {}, 0).OfResample({})));
}

TEST(GroupedAuc, RefusesBadInputAndNamesIt) {
  const std::vector<double> scores = {0.9, 0.5};
  const std::vector<double> with_nan = {0.9, std::numeric_limits<double>::quiet_NaN()};
  const std::vector<std::uint8_t> labels = {1, 0};
  const std::vector<std::size_t> groups = {0, 1};
  EXPECT_THROWS_MESSAGE(GroupedAuc(with_nan, labels, groups, 2), std::logic_error, HasSubstr("1"));
  EXPECT_THROWS_MESSAGE(
      GroupedAuc(scores, labels, groups, 1), std::logic_error, HasSubstr("num_groups"));
  EXPECT_THROWS_MESSAGE(GroupedAuc(scores, {}, groups, 2), std::logic_error, HasSubstr("2, 0"));
  const GroupedAuc auc(scores, labels, groups, 2);
  EXPECT_THROWS_MESSAGE(
      auc.OfResample(std::vector<std::size_t>{5}), std::logic_error, HasSubstr("5, 2"));
}

}  // namespace
}  // namespace handcraft::experiments
