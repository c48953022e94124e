// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "datasets/formats/table.h"
#include "experiments/evaluation/table_model.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::tools {

/// What a logistic model or a support vector machine says of the rows of a table.
struct TablePrediction {
  nlohmann::ordered_json json;  ///< {"positive_label", "probabilities"} or {"classes", "margins"}
  std::string csv;              ///< with a header line
};

/// By the runtime. A rejected row has the class null, in CSV an empty one. Throws std::logic_error
/// when the table has other columns than the model.
[[nodiscard]] TablePrediction PredictTable(const hc_model* model,
                                           const experiments::TableModel& table_model,
                                           const datasets::Table& table);

}  // namespace handcraft::tools
