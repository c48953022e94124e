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

namespace handcraft::tools {

/// What the commands that train on any table read.
struct TrainingTable {
  std::string path;
  datasets::Table table;
  datasets::BinaryLabels labels;

  [[nodiscard]] DesignMatrix<double> Matrix() const noexcept {
    return {.data = table.values.data(),
            .num_samples = table.num_rows,
            .num_features = table.columns.size(),
            .stride = table.columns.size()};
  }
};

/// Reads a table with two labels; before that, sees that `out`, empty for none, can be written and
/// is not the table. Throws Error as RequireWritable, RequireNotAnInput, ReadTable and
/// ToBinaryLabels do.
[[nodiscard]] TrainingTable ReadTrainingTable(const std::string& path,
                                              const std::string& label,
                                              const std::string& out);

/// Calls `train` and gives an Error of it the table's path: a trainer knows no file.
template <class Train>
auto NamingTable(const TrainingTable& table, Train&& train) {
  try {
    return train();
  } catch (const Error& error) {
    Error::Details details = error.details();
    if (details.path.empty()) details.path = table.path;
    throw Error(std::move(details));
  }
}

/// The model file of weights for the table's columns: the provenance gets task, intended use,
/// fingerprint and class counts.
[[nodiscard]] std::vector<std::uint8_t> TableModelBytes(const TrainingTable& table,
                                                        const model_io::LinearModel& model,
                                                        model_io::Provenance provenance);

}  // namespace handcraft::tools
