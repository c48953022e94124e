// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/metrics/binary_metrics.h"
#include "experiments/view_studies/rejection_curve.h"

namespace handcraft::experiments {

/// Of how many views of a group the answer was right.
struct GroupShare {
  std::string name;
  std::size_t num_views = 0;
  std::size_t num_right = 0;
  Estimate share = {};  ///< Wilson: views are taken as independent
};

/// Which answer was given how often: a confusion matrix, or a histogram a row.
struct AnswerCounts {
  std::string row_title;                         ///< what the rows are: "true class"
  std::vector<std::string> rows = {};            ///< what is true
  std::vector<std::string> columns = {};         ///< what was answered
  std::vector<std::vector<std::size_t>> counts;  ///< rows × columns
  std::vector<std::vector<bool>> is_right = {};  ///< rows × columns
  /// What the rows are divided by, one a row: kinds of symmetry; empty: nothing.
  std::vector<std::string> kinds = {};
};

/// How far the answers of a group that were not rejected are from the truth: medians, and the 90th
/// percentiles. NaN where all were rejected.
struct GroupErrors {
  std::string name;
  std::size_t num_asked = 0;
  std::size_t num_kept = 0;
  double median_position_m = 0.0;
  double high_position_m = 0.0;
  double median_rotation_deg = 0.0;
  double high_rotation_deg = 0.0;
};

/// How long something took.
struct TimeFigure {
  std::string name;  ///< with its unit: "training_s"
  double value = 0.0;
};

/// What came out of a cell of a study of views.
struct ViewCellResult {
  std::string id;
  AnswerCounts answers;
  std::vector<GroupShare> groups = {};  ///< one a row of the answers, then those of many rows
  std::vector<TimeFigure> times = {};
  std::vector<GroupErrors> errors = {};        ///< where answers are poses
  std::vector<RejectionPoint> rejection = {};  ///< where answers can be doubted
};

/// The groups of all cells, rows of the answers first, each once.
[[nodiscard]] std::vector<std::string> GroupNames(const std::vector<ViewCellResult>& results);

/// Null when the cell has no such group.
[[nodiscard]] const GroupShare* FindGroup(const ViewCellResult& result, const std::string& name);

/// A group of the row's views.
[[nodiscard]] GroupShare ShareOfRow(const AnswerCounts& answers, std::size_t row);

/// A group of the views of several others.
[[nodiscard]] GroupShare ShareOfAll(std::string name, const std::vector<GroupShare>& parts);

}  // namespace handcraft::experiments
