// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/confusion_percent.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

constexpr ConfusionMatrix kMatrix{
    .true_positive = 30, .false_positive = 10, .true_negative = 40, .false_negative = 20};

TEST(ConfusionPercent, OfAHundredSamplesByHand) {
  const ConfusionPercent percent = PercentOf(kMatrix);
  EXPECT_DOUBLE_EQ(percent[0][0], 40.0);
  EXPECT_DOUBLE_EQ(percent[0][1], 10.0);
  EXPECT_DOUBLE_EQ(percent[1][0], 20.0);
  EXPECT_DOUBLE_EQ(percent[1][1], 30.0);
  EXPECT_DOUBLE_EQ(BadShareOf(percent), 0.5);
}

TEST(ConfusionPercent, AtAnotherRatioKeepsTheRates) {
  const ConfusionPercent percent = PercentAtBadShare(kMatrix, 0.8);
  EXPECT_DOUBLE_EQ(percent[0][0], 64.0);  // four in five of the bad ones
  EXPECT_DOUBLE_EQ(percent[0][1], 16.0);
  EXPECT_NEAR(percent[1][0], 8.0, 1e-13);
  EXPECT_NEAR(percent[1][1], 12.0, 1e-13);
  EXPECT_NEAR(BadShareOf(percent), 0.8, 1e-15);
  EXPECT_THROW(static_cast<void>(PercentAtBadShare(kMatrix, 1.1)), std::logic_error);
}

TEST(ConfusionPercent, OfTheDissertationAddUp) {
  EXPECT_NEAR(BadShareOf(kDissertationLda), 0.6234, 1e-12);
}

TEST(ConfusionPercent, OfNothingIsNotANumber) {
  EXPECT_TRUE(std::isnan(PercentOf({})[0][0]));
  EXPECT_TRUE(std::isnan(PercentAtBadShare({.true_positive = 1}, 0.5)[0][1]));
}

}  // namespace
}  // namespace handcraft::experiments
