// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/grouped_ratio.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

TEST(EstimateRatio, DividesTheSums) {
  const std::vector<GroupRatio> groups = {{1, 4}, {0, 0}, {3, 4}};
  const Estimate estimate = EstimateRatio(groups, 200, 1);
  EXPECT_DOUBLE_EQ(estimate.value, 0.5);
  EXPECT_DOUBLE_EQ(estimate.low, 0.25);
  EXPECT_DOUBLE_EQ(estimate.high, 0.75);
  EXPECT_TRUE(std::isnan(EstimateRatio({}, 10, 1).value));
}

TEST(EstimateRatio, HasNoIntervalOfOneGroupThatCounts) {
  const std::vector<GroupRatio> groups = {{1, 4}, {0, 0}, {0, 0}};
  const Estimate estimate = EstimateRatio(groups, 200, 1);
  EXPECT_DOUBLE_EQ(estimate.value, 0.25);
  EXPECT_TRUE(std::isnan(estimate.low));
  EXPECT_TRUE(std::isnan(estimate.high));
}

// The delta method's standard error of a ratio of means: var(sum − ratio · count) / (n mean
// count²).
TEST(EstimateRatio, IsAsWideAsTheDeltaMethodSays) {
  constexpr int kNumGroups = 400;
  Rng rng(5);
  std::vector<GroupRatio> groups;
  GroupRatio all;
  for (int i = 0; i < kNumGroups; ++i) {
    const double count =
        rng.UniformInt(4) == 0 ? 0.0 : 10.0 + static_cast<double>(rng.UniformInt(6));
    groups.push_back({count * (0.4 + 0.4 * rng.Uniform()), count});
    all += groups.back();
  }
  double squares = 0.0;
  for (const GroupRatio& group : groups)
    squares += std::pow(group.sum - all.Value() * group.count, 2);
  const double standard_error = std::sqrt(squares) / all.count;
  const Estimate estimate = EstimateRatio(groups, 4000, 1);
  EXPECT_DOUBLE_EQ(estimate.value, all.Value());
  // 4000 resamples know a percentile to some hundredths of the width.
  EXPECT_NEAR((estimate.high - estimate.low) / (2.0 * 1.96 * standard_error), 1.0, 0.08);
}

TEST(EstimateShare, IsNotCertainOfNoneOrAll) {
  const std::vector<GroupRatio> none = {{0, 4}, {0, 5}, {0, 0}};
  EXPECT_EQ(EstimateShare(none, 50, 1).high, WilsonInterval(0, 2).high);
  const std::vector<GroupRatio> all = {{4, 4}, {5, 5}, {0, 0}};
  EXPECT_EQ(EstimateShare(all, 50, 1).low, WilsonInterval(2, 2).low);
  const std::vector<GroupRatio> one = {{4, 4}, {0, 0}};
  EXPECT_TRUE(std::isnan(EstimateShare(one, 50, 1).low)) << "one image tells of no spread";
}

TEST(EstimateShare, GivesTheSameForAnyNumberOfThreads) {
  const std::vector<GroupRatio> groups = {{1, 4}, {2, 3}, {3, 9}, {0, 2}};
  const Estimate one = EstimateShare(groups, 100, 3, 1);
  const Estimate three = EstimateShare(groups, 100, 3, 3);
  EXPECT_EQ(one.low, three.low);
  EXPECT_EQ(one.high, three.high);
}

}  // namespace
}  // namespace handcraft::experiments
