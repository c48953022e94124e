// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/confusion_table.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ConfusionTable, ShowsCountsAndSharesOfTheRowWithIntervals) {
  EXPECT_THAT(
      ConfusionTable(
          {.true_positive = 3, .false_positive = 1, .true_negative = 7, .false_negative = 1},
          {.true_positive_rate = {0.75, 0.5, 0.8}, .true_negative_rate = {0.875, 0.6, 1.0}},
          0.9),
      AllOf(HasSubstr("(above 0.9)"),
            HasSubstr(">3</span><span class=\"share\">75.0 %</span>"
                      "<span class=\"range\">[50.0, 80.0]"),
            HasSubstr(">1</span><span class=\"share\">25.0 %</span>"
                      "<span class=\"range\">[20.0, 50.0]"),
            HasSubstr(">1</span><span class=\"share\">12.5 %</span>"
                      "<span class=\"range\">[0.0, 40.0]"),
            HasSubstr(">7</span><span class=\"share\">87.5 %")));
}

TEST(ConfusionTable, ShowsADashForARowWithoutPixels) {
  const double nan = std::nan("");
  EXPECT_THAT(
      ConfusionTable({.true_negative = 2},
                     {.true_positive_rate = {nan, nan, nan}, .true_negative_rate = {1.0, nan, nan}},
                     0.5),
      AllOf(HasSubstr(">0</span><span class=\"share\">–</span><span class=\"range\"></span>"),
            Not(HasSubstr("nan"))));
}

}  // namespace
}  // namespace handcraft::experiments
