// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/table.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {

/// What a logistic model or a support vector machine reads from a table, and what it says about a
/// row.
struct TableModel {
  std::vector<std::string> columns;  ///< in the order of the weights
  std::string label_column;
  std::string negative_label;  ///< of a logistic model, as the next one
  std::string positive_label;
  std::vector<std::string> classes = {};  ///< every label; of a logistic model negative, positive
};

/// Reads the names from the model file. Throws Error(kBadInput) for another kind of model.
[[nodiscard]] TableModel ReadTableModel(const std::filesystem::path& path);

/// The columns the model reads, in its order, wherever they stand in the file; others are left out.
/// An NPY file has no names, libsvm's text has numbers: one with as many columns as the model is
/// taken as it is. The labels are read when the file has the model's label column, and left empty
/// otherwise. Throws Error that names the columns that are missing.
[[nodiscard]] datasets::Table ReadTableFor(const TableModel& model,
                                           const std::filesystem::path& path);

/// Probability of the positive label for every row of such a table, by the runtime. Throws
/// std::logic_error when the table has other columns than the model.
[[nodiscard]] std::vector<double> PredictTable(const hc_model* model, const datasets::Table& table);

/// Throws Error(kBadInput) naming `path` when the table has no labels, or naming the row of one
/// that is not among the model's.
void RequireLabelsOf(const TableModel& model,
                     const datasets::Table& table,
                     const std::filesystem::path& path);

}  // namespace handcraft::experiments
