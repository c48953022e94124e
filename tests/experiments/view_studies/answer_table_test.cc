// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/answer_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(AnswerTable, TintsByShareOfTheRow) {
  const std::string text = AnswerTable({.row_title = "object",
                                        .rows = {"can", "a<b"},
                                        .columns = {"can", "mug"},
                                        .counts = {{3, 1}, {0, 0}},
                                        .is_right = {{true, false}, {false, true}}});
  EXPECT_THAT(text,
              AllOf(HasSubstr("rgba(20, 140, 130, 0.46)\">3</td>"),  // 0.08 + 0.5 · 3/4
                    HasSubstr("title=\"25.0 %\""),
                    HasSubstr("rgba(205, 95, 40, 0.21)\">1</td>"),
                    HasSubstr("a&lt;b"),
                    HasSubstr("<td class=\"number\"></td>"),
                    Not(HasSubstr(">0</td>"))));
}

TEST(AnswerTable, PutsLongNamesOfManyColumnsUpright) {
  AnswerCounts answers{.row_title = "object", .rows = {"can"}, .counts = {{}}, .is_right = {{}}};
  for (int column = 0; column < 9; ++column) {
    answers.columns.push_back(std::to_string(10 * column) + "°");
    answers.counts[0].push_back(1);
    answers.is_right[0].push_back(true);
  }
  EXPECT_THAT(AnswerTable(answers), HasSubstr("<table class=\"dense\">"));
  answers.columns[8] = "shampoo_bottle";
  EXPECT_THAT(AnswerTable(answers),
              AllOf(HasSubstr("<table class=\"dense upright\">"),
                    HasSubstr("<span>shampoo_<wbr>bottle</span>")));
}

}  // namespace
}  // namespace handcraft::experiments
