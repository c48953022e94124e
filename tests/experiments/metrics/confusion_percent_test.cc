// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/confusion_percent.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

constexpr ConfusionRates kRates{.true_positive_rate = {0.6, 0.5, 0.75},
                                .true_negative_rate = {0.8, 0.7, 0.9}};

TEST(ConfusionPercent, ScalesRatesAndIntervalsByTheClassShares) {
  const ConfusionPercentEstimate percent = PercentAtBadShare(kRates, 0.5);
  EXPECT_DOUBLE_EQ(percent[0][0].value, 40.0);
  EXPECT_DOUBLE_EQ(percent[0][0].low, 35.0);
  EXPECT_DOUBLE_EQ(percent[0][0].high, 45.0);
  EXPECT_DOUBLE_EQ(percent[0][1].value, 10.0);
  EXPECT_DOUBLE_EQ(percent[0][1].low, 5.0);
  EXPECT_DOUBLE_EQ(percent[0][1].high, 15.0);
  EXPECT_DOUBLE_EQ(percent[1][0].value, 20.0);
  EXPECT_DOUBLE_EQ(percent[1][1].value, 30.0);
  EXPECT_DOUBLE_EQ(percent[1][1].high, 37.5);
}

TEST(ConfusionPercent, AtAnotherRatioKeepsTheRates) {
  const ConfusionPercentEstimate percent = PercentAtBadShare(kRates, 0.8);
  EXPECT_DOUBLE_EQ(percent[0][0].value, 64.0);  // four in five of the bad ones
  EXPECT_DOUBLE_EQ(percent[0][1].value, 16.0);
  EXPECT_NEAR(percent[1][0].value, 8.0, 1e-13);
  EXPECT_NEAR(percent[1][1].value, 12.0, 1e-13);
  EXPECT_THROW(static_cast<void>(PercentAtBadShare(kRates, 1.1)), std::logic_error);
}

TEST(ConfusionPercent, LeavesIntervalsOut) {
  const ConfusionPercent values = ValuesOf(PercentAtBadShare(kRates, 0.5));
  EXPECT_DOUBLE_EQ(values[0][1], 10.0);
  EXPECT_DOUBLE_EQ(values[1][0], 20.0);
}

TEST(ConfusionPercent, KnowsTheShareOfBadSamplesOfAMatrix) {
  EXPECT_DOUBLE_EQ(
      BadShareOf(ConfusionMatrix{.true_positive = 1, .false_positive = 2, .true_negative = 1}),
      0.75);
  EXPECT_EQ(BadShareOf(ConfusionMatrix{}), 0.0);
}

TEST(ConfusionPercent, OfTheDissertationAddUp) {
  EXPECT_NEAR(BadShareOf(kDissertationLda), 0.6234, 1e-12);
}

TEST(ConfusionPercent, OfAMissingClassIsNotANumber) {
  const ConfusionRates rates{.true_positive_rate = {0.5, 0.4, 0.6},
                             .true_negative_rate = {std::nan(""), std::nan(""), std::nan("")}};
  EXPECT_TRUE(std::isnan(PercentAtBadShare(rates, 0.5)[0][1].value));
}

}  // namespace
}  // namespace handcraft::experiments
