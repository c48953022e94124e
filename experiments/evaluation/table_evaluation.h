// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/table.h"
#include "experiments/metrics/binary_metrics.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {

struct TableEvaluationOptions {
  double threshold = 0.5;  ///< of the confusion matrix, (0, 1)
  std::size_t bootstrap_resamples = 1000;
  std::uint64_t seed = 1;
  int num_threads = 1;
  void Validate() const;
};

/// Figures of a logistic model on a table. Positive is the model's label 1.
struct TableEvaluation {
  TableEvaluationOptions options;
  std::size_t num_rows = 0;
  std::string label_column;
  std::string negative_label;
  std::string positive_label;
  ConfusionMatrix confusion;
  Estimate accuracy;  ///< Wilson: rows are taken as independent
  Estimate auc;       ///< bootstrap over rows
  double log_loss = 0.0;
  double brier = 0.0;
  std::vector<RocPoint> roc;
};

/// Scores every row with the runtime (hc_predict_row). The table holds the model's columns in the
/// model's order (ReadTableFor); `path` is named in errors. Throws Error when the model is no
/// logistic one, or the table has no rows, no labels, or a label the model does not know; and
/// std::logic_error on another number of columns. A table with one label alone is fine: what needs
/// both is NaN.
[[nodiscard]] TableEvaluation EvaluateTable(const hc_model* model,
                                            const datasets::Table& table,
                                            const std::filesystem::path& path,
                                            const TableEvaluationOptions& options = {});

/// JSON text with stable keys ("accuracy", "confusion", …); two runs give the same bytes.
[[nodiscard]] std::string ToJson(const TableEvaluation& evaluation);

}  // namespace handcraft::experiments
