// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_cell_result.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

AnswerCounts TwoRows() {
  return {.row_title = "object",
          .rows = {"can", "box"},
          .columns = {"can", "drill", "mug"},
          .counts = {{5, 1, 0}, {2, 3, 4}},
          .is_right = {{true, false, false}, {true, true, false}}};
}

TEST(ShareOfRow, CountsEveryRightAnswer) {
  const GroupShare box = ShareOfRow(TwoRows(), 1);
  EXPECT_EQ(box.name, "box");
  EXPECT_EQ(box.num_views, 9U);
  EXPECT_EQ(box.num_right, 5U);
  EXPECT_EQ(box.share.value, 5.0 / 9.0);
  EXPECT_EQ(box.share.low, WilsonInterval(5, 9).low);
}

TEST(GroupNames, HasRowsBeforeSums) {
  const AnswerCounts answers = TwoRows();
  const GroupShare can = ShareOfRow(answers, 0);
  const GroupShare all = ShareOfAll("all", {can});
  const std::vector<ViewCellResult> results = {
      {.id = "a", .answers = answers, .groups = {can, ShareOfRow(answers, 1), all}},
      {.id = "b", .answers = answers, .groups = {can, {.name = "later"}, all}}};
  EXPECT_EQ(GroupNames(results), (std::vector<std::string>{"can", "box", "later", "all"}));
  EXPECT_EQ(FindGroup(results[0], "all")->num_right, 5U);
  EXPECT_EQ(FindGroup(results[0], "later"), nullptr);
}

TEST(ShareOfAll, AddsViewsUp) {
  const GroupShare all = ShareOfAll("all", {ShareOfRow(TwoRows(), 0), ShareOfRow(TwoRows(), 1)});
  EXPECT_EQ(all.num_views, 15U);
  EXPECT_EQ(all.num_right, 10U);
  EXPECT_TRUE(std::isnan(ShareOfAll("none", {}).share.value));
}

}  // namespace
}  // namespace handcraft::experiments
