// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/confusion_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ConfusionTable, ShowsCountsAndSharesOfTheRow) {
  EXPECT_THAT(
      ConfusionTable(
          {.true_positive = 3, .false_positive = 1, .true_negative = 7, .false_negative = 1}, 0.9),
      AllOf(HasSubstr("(above 0.9)"),
            HasSubstr(">3</span><span class=\"share\">75.0 %"),
            HasSubstr(">7</span><span class=\"share\">87.5 %")));
}

TEST(ConfusionTable, ShowsADashForARowWithoutPixels) {
  EXPECT_THAT(ConfusionTable({.true_negative = 2}, 0.5),
              HasSubstr(">0</span><span class=\"share\">–"));
}

}  // namespace
}  // namespace handcraft::experiments
