// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_cell_result.h"

#include <algorithm>
#include <utility>

namespace handcraft::experiments {

std::vector<std::string> GroupNames(const std::vector<ViewCellResult>& results) {
  std::vector<std::string> names;
  std::vector<std::string> sums;
  for (const ViewCellResult& result : results) {
    for (std::size_t g = 0; g < result.groups.size(); ++g) {
      std::vector<std::string>& list = g < result.answers.rows.size() ? names : sums;
      const std::string& name = result.groups[g].name;
      if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
    }
  }
  names.insert(names.end(), sums.begin(), sums.end());
  return names;
}

const GroupShare* FindGroup(const ViewCellResult& result, const std::string& name) {
  const auto found = std::find_if(result.groups.begin(),
                                  result.groups.end(),
                                  [&](const GroupShare& group) { return group.name == name; });
  return found == result.groups.end() ? nullptr : &*found;
}

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
