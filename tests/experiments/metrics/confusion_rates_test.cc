// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/confusion_rates.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/metrics/grouped_ratio.h"

namespace handcraft::experiments {
namespace {

TEST(EstimateRates, OfThreeImagesByHand) {
  const std::array<ConfusionMatrix, 3> images = {{
      {.true_positive = 3, .false_positive = 1, .true_negative = 4, .false_negative = 1},
      {.true_positive = 1, .false_positive = 0, .true_negative = 5, .false_negative = 3},
      {.true_positive = 2, .false_positive = 2, .true_negative = 3, .false_negative = 0},
  }};
  const ConfusionRates rates = EstimateRates(images, 200, 1);
  EXPECT_DOUBLE_EQ(rates.true_positive_rate.value, 6.0 / 10.0);
  EXPECT_DOUBLE_EQ(rates.true_negative_rate.value, 12.0 / 15.0);
  const std::vector<GroupRatio> good = {{3.0, 4.0}, {1.0, 4.0}, {2.0, 2.0}};
  const Estimate share = EstimateShare(good, 200, 1);
  EXPECT_EQ(rates.true_positive_rate.low, share.low);
  EXPECT_EQ(rates.true_positive_rate.high, share.high);
}

TEST(EstimateRates, OfAMissingKindIsNotANumber) {
  const std::array<ConfusionMatrix, 2> images = {{{.true_positive = 3}, {.true_positive = 1}}};
  const ConfusionRates rates = EstimateRates(images, 50, 1);
  EXPECT_EQ(rates.true_positive_rate.value, 1.0);
  EXPECT_LT(rates.true_positive_rate.low, 1.0) << "Wilson's, where the bootstrap varies nothing";
  EXPECT_TRUE(std::isnan(rates.true_negative_rate.value));
  EXPECT_TRUE(std::isnan(EstimateRates({}, 50, 1).true_positive_rate.value));
}

TEST(Complement, TurnsTheIntervalRound) {
  const Estimate rest = Complement({0.75, 0.5, 1.0});
  EXPECT_EQ(rest.value, 0.25);
  EXPECT_EQ(rest.low, 0.0);
  EXPECT_EQ(rest.high, 0.5);
}

}  // namespace
}  // namespace handcraft::experiments
