// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_cell_result.h"

#include <utility>

namespace handcraft::experiments {

GroupShare ShareOfRow(const AnswerCounts& answers, std::size_t row) {
  GroupShare group{.name = answers.rows[row]};
  for (std::size_t column = 0; column < answers.columns.size(); ++column) {
    group.num_views += answers.counts[row][column];
    if (answers.is_right[row][column]) group.num_right += answers.counts[row][column];
  }
  group.share = WilsonInterval(group.num_right, group.num_views);
  return group;
}

GroupShare ShareOfAll(std::string name, const std::vector<GroupShare>& parts) {
  GroupShare group{.name = std::move(name)};
  for (const GroupShare& part : parts) {
    group.num_views += part.num_views;
    group.num_right += part.num_right;
  }
  group.share = WilsonInterval(group.num_right, group.num_views);
  return group;
}

}  // namespace handcraft::experiments
