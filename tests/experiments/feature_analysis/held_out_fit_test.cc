// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/held_out_fit.h"

#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/feature_analysis/drawn_data.h"

namespace handcraft::experiments {
namespace {

const std::vector<std::size_t> kAll = {0, 1, 2, 3};
const std::vector<std::size_t> kFirstTwo = {0, 1};

TEST(HeldOutFit, FindsTheWeightsOfTheModelThatDrewTheLabels) {
  const HeldOutData data = DrawHeldOut(30000, 3);
  const HeldOutFit fit = FitColumns(data, kFirstTwo, nullptr, {});
  EXPECT_NEAR(fit.weights[0], 2.0, 0.1);
  EXPECT_NEAR(fit.weights[1], 1.0, 0.1);
  EXPECT_NEAR(fit.intercept, 0.0, 0.1);
  EXPECT_GT(fit.auc, 0.85);
}

TEST(HeldOutFit, AddsItsLossesUpByGroup) {
  const HeldOutData data = DrawHeldOut(900, 5);
  const HeldOutFit fit = FitColumns(data, kAll, nullptr, {});
  EXPECT_EQ(fit.group_losses.size(), 5U);
  EXPECT_NEAR(std::accumulate(fit.group_losses.begin(), fit.group_losses.end(), 0.0) /
                  static_cast<double>(data.held_out_labels.size()),
              fit.log_loss,
              1e-13);
}

// The same optimum wherever it begins, in fewer steps from nearby.
TEST(HeldOutFit, BegunAtALargerFitEndsAtTheSameOptimum) {
  const HeldOutData data = DrawHeldOut(3000, 7);
  const HeldOutFit all = FitColumns(data, kAll, nullptr, {});
  const std::vector<std::size_t> without_noise = {0, 1, 2};
  const HeldOutFit cold = FitColumns(data, without_noise, nullptr, {});
  const HeldOutFit warm = FitColumns(data, without_noise, &all, {});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(warm.weights[k], cold.weights[k], 1e-9);
  EXPECT_NEAR(warm.intercept, cold.intercept, 1e-9);
  EXPECT_NEAR(warm.log_loss, cold.log_loss, 1e-10);
  EXPECT_LT(warm.iterations, cold.iterations);
}

TEST(HeldOutFit, IncreaseIsPairedOverGroups) {
  const HeldOutData data = DrawHeldOut(3000, 9);
  const HeldOutFit all = FitColumns(data, kAll, nullptr, {});
  const std::vector<std::size_t> second = {1};
  const HeldOutFit poor = FitColumns(data, second, &all, {});
  const Estimate increase = LossIncrease(poor, all, data, 1);
  EXPECT_NEAR(increase.value, poor.log_loss - all.log_loss, 1e-12);
  EXPECT_GT(increase.low, 0.0);
  EXPECT_GE(increase.high, increase.value);
  EXPECT_EQ(LossIncrease(all, all, data, 1).high, 0.0);
}

TEST(HeldOutFit, RefusesColumnsThatAreNotThere) {
  const HeldOutData data = DrawHeldOut(300, 11);
  const HeldOutFit some = FitColumns(data, kFirstTwo, nullptr, {});
  const std::vector<std::size_t> beyond = {4};
  EXPECT_THROW(static_cast<void>(FitColumns(data, beyond, nullptr, {})), std::logic_error);
  EXPECT_THROW(static_cast<void>(FitColumns(data, {}, nullptr, {})), std::logic_error);
  EXPECT_THROW(static_cast<void>(FitColumns(data, kAll, &some, {})), std::logic_error);
}

}  // namespace
}  // namespace handcraft::experiments
