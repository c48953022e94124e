// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/pixel_cards.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(PixelCards, ShowsBothMatricesCurvesAndIntervals) {
  const PixelCurves curves{
      .roc = {{0.0, 0.0}, {0.25, 0.75}, {1.0, 1.0}},
      .precision_recall = {{0.5, 0.9}, {1.0, 0.6}},
      .bands = {.roc = {{0.0, 0.0, 0.2}, {1.0, 1.0, 1.0}}},
      .reliability = {{{0.0, 0.5, 1, 3, 0.25}, {0.25, 0.1, 0.4}}},
  };
  const std::string cards = PixelCards({.confusion = {.true_positive = 1234},
                                        .rates = {.true_positive_rate = {0.75, 0.625, 0.875}},
                                        .strict_confusion = {.false_negative = 5678},
                                        .strict_rates = {.true_negative_rate = {0.5, 0.25, 0.75}},
                                        .auc = {0.875, 0.8, 0.95},
                                        .average_precision = {0.5, std::nan(""), std::nan("")},
                                        .brier = {0.125, 0.1, 0.15}},
                                       curves);
  EXPECT_THAT(cards,
              AllOf(HasSubstr("(above 0.5)"),
                    HasSubstr("(above 0.9)"),
                    HasSubstr("1234"),
                    HasSubstr("5678"),
                    HasSubstr("[62.5, 87.5]"),
                    HasSubstr("[25.0, 75.0]"),
                    HasSubstr("<h3>ROC curve, area 0.875 [0.800, 0.950]</h3>"),
                    HasSubstr("average precision 0.500</h3>"),
                    HasSubstr("Brier score 0.125 [0.100, 0.150]"),
                    HasSubstr("<title>Reliability diagram</title>"),
                    HasSubstr("class=\"band first\""),
                    Not(HasSubstr("nan"))));
}

TEST(PixelCards, DrawsEmptyFramesWithoutCurves) {
  const Estimate none = {std::nan(""), std::nan(""), std::nan("")};
  EXPECT_THAT(PixelCards({.rates = {none, none},
                          .strict_rates = {none, none},
                          .auc = none,
                          .average_precision = none,
                          .brier = none},
                         {}),
              AllOf(HasSubstr("<title>ROC curve</title>"), Not(HasSubstr("nan"))));
}

}  // namespace
}  // namespace handcraft::experiments
