// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/backward_elimination.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/feature_analysis/drawn_data.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;

// What has the largest variance goes first or second, for it tells nothing; the copy tells nothing
// that feature 0 does not; the most useful one stays.
TEST(BackwardElimination, KeepsWhatTheClassifierNeeds) {
  const HeldOutData data = DrawHeldOut(30000, 3);
  const BackwardElimination result = EliminateBackward(data, {0, 1, 2, 3}, 4, {});
  ASSERT_EQ(result.order.size(), 4U);
  EXPECT_EQ(result.order[0] + result.order[1], 5U);  // 2 and 3
  EXPECT_EQ(result.order[2], 1U);
  EXPECT_EQ(result.order[3], 0U);
  ASSERT_EQ(result.steps.size(), 3U);
  EXPECT_EQ(result.steps[2].num_columns, 1U);
  EXPECT_NEAR(result.steps[1].increase.value, 0.0, 1e-3);
  EXPECT_GT(result.steps[2].increase.low, 0.01);
  EXPECT_NEAR(
      result.steps[2].log_loss, result.all.log_loss + result.steps[2].increase.value, 1e-12);
}

// At each step the chosen set is the one whose going leaves the least loss: brute force.
TEST(BackwardElimination, TakesTheLeastLossAtEachStep) {
  const HeldOutData data = DrawHeldOut(1200, 5);
  const BackwardElimination result = EliminateBackward(data, {0, 1, 2, 3}, 4, {});
  std::vector<std::size_t> left = {0, 1, 2, 3};
  for (const EliminationStep& step : result.steps) {
    double least = 1e300;
    std::size_t chosen = 0;
    for (const std::size_t without : left) {
      std::vector<std::size_t> columns = left;
      std::erase(columns, without);
      const double loss = FitColumns(data, columns, nullptr, {}).log_loss;
      if (loss < least) {
        least = loss;
        chosen = without;
      }
    }
    EXPECT_EQ(step.removed, chosen);
    EXPECT_NEAR(step.log_loss, least, 1e-9);
    std::erase(left, chosen);
  }
}

TEST(BackwardElimination, TakesAllColumnsOfASetAtOnce) {
  const HeldOutData data = DrawHeldOut(1200, 7);
  const BackwardElimination result = EliminateBackward(data, {0, 1, 0, 1}, 2, {});
  EXPECT_THAT(result.order, ElementsAre(1, 0));
  EXPECT_EQ(result.steps[0].num_columns, 2U);
}

TEST(BackwardElimination, IsTheSameForAnyNumberOfThreads) {
  const HeldOutData data = DrawHeldOut(1200, 9);
  const BackwardElimination one = EliminateBackward(data, {0, 1, 2, 3}, 4, {.num_threads = 1});
  const BackwardElimination three = EliminateBackward(data, {0, 1, 2, 3}, 4, {.num_threads = 3});
  EXPECT_EQ(one.order, three.order);
  for (std::size_t s = 0; s < one.steps.size(); ++s) {
    EXPECT_EQ(one.steps[s].log_loss, three.steps[s].log_loss);
  }
}

TEST(BackwardElimination, OfOneSetHasNoStep) {
  const BackwardElimination result = EliminateBackward(DrawHeldOut(300, 11), {0, 0, 0, 0}, 1, {});
  EXPECT_TRUE(result.steps.empty());
  EXPECT_THAT(result.order, ElementsAre(0));
}

TEST(BackwardElimination, RefusesSetsThatDoNotFit) {
  const HeldOutData data = DrawHeldOut(300, 13);
  EXPECT_THROW(static_cast<void>(EliminateBackward(data, {0, 1}, 2, {})), std::logic_error);
  EXPECT_THROW(static_cast<void>(EliminateBackward(data, {0, 1, 2, 3}, 3, {})), std::logic_error);
  EXPECT_THROW(static_cast<void>(EliminateBackward(data, {0, 1, 1, 0}, 3, {})), std::logic_error);
}

}  // namespace
}  // namespace handcraft::experiments
