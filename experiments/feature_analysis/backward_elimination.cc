// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/backward_elimination.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/parallel.h"

namespace handcraft::experiments {
namespace {

// The columns of the sets that are left, but one.
std::vector<std::size_t> ColumnsWithout(const std::vector<std::size_t>& set_of_column,
                                        const std::vector<std::size_t>& left,
                                        std::size_t without) {
  std::vector<std::size_t> columns;
  for (std::size_t j = 0; j < set_of_column.size(); ++j) {
    const std::size_t set = set_of_column[j];
    if (set != without && std::find(left.begin(), left.end(), set) != left.end()) {
      columns.push_back(j);
    }
  }
  return columns;
}

void CheckSets(const std::vector<std::size_t>& set_of_column,
               std::size_t num_sets,
               std::size_t num_columns) {
  HC_CHECK(num_sets >= 1 && set_of_column.size() == num_columns, num_sets, set_of_column.size());
  std::vector<bool> is_there(num_sets, false);
  for (const std::size_t set : set_of_column) {
    HC_CHECK(set < num_sets, set, num_sets);
    is_there[set] = true;
  }
  HC_CHECK(std::find(is_there.begin(), is_there.end(), false) == is_there.end(), num_sets);
}

}  // namespace

BackwardElimination EliminateBackward(const HeldOutData& data,
                                      const std::vector<std::size_t>& set_of_column,
                                      std::size_t num_sets,
                                      const BackwardEliminationOptions& options) {
  CheckSets(set_of_column, num_sets, data.num_features);
  std::vector<std::size_t> left(num_sets);
  std::iota(left.begin(), left.end(), 0U);
  std::vector<std::size_t> every_column(data.num_features);
  std::iota(every_column.begin(), every_column.end(), 0U);
  const std::size_t num_fits = num_sets * (num_sets + 1) / 2;
  std::size_t num_done = 1;
  Report(options.progress, "backward elimination", 0, num_fits);
  BackwardElimination result{
      .all = FitColumns(data, every_column, nullptr, options.fit), .steps = {}, .order = {}};
  HeldOutFit current = result.all;
  while (left.size() > 1) {
    Report(options.progress, "backward elimination", num_done, num_fits);
    std::vector<HeldOutFit> fits(left.size());
    ParallelFor(left.size(), options.num_threads, [&](std::size_t k) {
      fits[k] =
          FitColumns(data, ColumnsWithout(set_of_column, left, left[k]), &current, options.fit);
    });
    num_done += fits.size();
    const auto best = std::min_element(fits.begin(), fits.end(), [](const auto& a, const auto& b) {
      return a.log_loss < b.log_loss;
    });
    const auto index = best - fits.begin();
    current = std::move(*best);
    result.order.push_back(left[static_cast<std::size_t>(index)]);
    left.erase(left.begin() + index);
    result.steps.push_back({.removed = result.order.back(),
                            .log_loss = current.log_loss,
                            .auc = current.auc,
                            .increase = LossIncrease(current, result.all, data, options.fit.seed),
                            .num_columns = current.columns.size()});
  }
  result.order.push_back(left.front());
  return result;
}

}  // namespace handcraft::experiments
