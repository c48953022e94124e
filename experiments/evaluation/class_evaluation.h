// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/table.h"
#include "experiments/evaluation/table_model.h"
#include "experiments/metrics/binary_metrics.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {

/// What the runtime says about a row.
struct RowClass {
  std::size_t number = 0;
  bool is_rejected = false;
  double margin = 0.0;
};

/// The class of every row of a table with the model's columns (ReadTableFor), by the runtime
/// (hc_classify_row). Throws std::logic_error when the table has other columns than the model.
[[nodiscard]] std::vector<RowClass> ClassifyTable(const hc_model* model,
                                                  const datasets::Table& table);

/// Figures of a model of classes on a table.
struct ClassEvaluation {
  std::size_t num_rows = 0;
  std::string label_column = {};
  std::vector<std::string> classes = {};
  /// Rows: the truth; columns: what the model says, the last one kNoneOfThese.
  std::vector<std::vector<std::size_t>> confusion = {};
  std::size_t num_correct = 0;
  std::size_t num_rejected = 0;
  Estimate accuracy = {};  ///< Wilson: rows are taken as independent; a rejected row is not correct
};

/// Classifies every row. `path` is named in errors. Throws Error when the table has no rows, no
/// labels, or a label the model does not know.
[[nodiscard]] ClassEvaluation EvaluateClasses(const hc_model* model,
                                              const TableModel& names,
                                              const datasets::Table& table,
                                              const std::filesystem::path& path);

/// JSON text with stable keys ("accuracy", "confusion", …); two runs give the same bytes.
[[nodiscard]] std::string ToJson(const ClassEvaluation& evaluation);

}  // namespace handcraft::experiments
