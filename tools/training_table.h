// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "datasets/formats/table.h"
#include "lib/core/design_matrix.h"
#include "lib/core/error.h"
#include "lib/model_io/linear_models.h"
#include "tools/table_command.h"

namespace handcraft::tools {

/// The numbers of a table, in place.
[[nodiscard]] inline DesignMatrix<double> MatrixOf(const datasets::Table& table) noexcept {
  return {.data = table.values.data(),
          .num_samples = table.num_rows,
          .num_features = table.columns.size(),
          .stride = table.columns.size()};
}

/// What the commands that train on any table with two labels read.
struct TrainingTable {
  std::string path;
  datasets::Table table;
  datasets::BinaryLabels labels;

  [[nodiscard]] DesignMatrix<double> Matrix() const noexcept { return MatrixOf(table); }
};

/// Reads a table with labels; before that, sees that the model, if there is to be one, can be
/// written and is not the table. Throws Error as RequireWritable, RequireNotAnInput and ReadTable
/// do, and Error(kUsage) without a label column where one is needed.
[[nodiscard]] datasets::Table ReadLabelledTable(const TableArguments& arguments);

/// The same for two labels. Throws Error as ToBinaryLabels does besides.
[[nodiscard]] TrainingTable ReadTrainingTable(const TableArguments& arguments);

/// Calls `train` and gives an Error of what it read the table's path: a trainer knows no file.
template <class Train>
auto NamingTable(const std::string& path, Train&& train) {
  try {
    return train();
  } catch (const Error& error) {
    Error::Details details = error.details();
    const bool is_of_table = details.kind != Error::Kind::kUsage;
    if (is_of_table && details.path.empty()) details.path = path;
    throw Error(std::move(details));
  }
}

/// The model file of weights for the table's columns: the provenance gets task, intended use,
/// fingerprint and class counts.
[[nodiscard]] std::vector<std::uint8_t> TableModelBytes(const TrainingTable& table,
                                                        const model_io::LinearModel& model,
                                                        model_io::Provenance provenance);

}  // namespace handcraft::tools
