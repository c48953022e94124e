// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/training_table.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "datasets/formats/libsvm_table.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/model_writer.h"
#include "tools/common_options.h"

namespace handcraft::tools {

datasets::Table ReadLabelledTable(const TableArguments& arguments) {
  RequireWritable(arguments.out);
  const std::array inputs = {std::filesystem::path(arguments.table)};
  RequireNotAnInput(arguments.out, inputs);
  if (arguments.label.empty() && !datasets::IsLibsvmText(arguments.table)) {
    throw Error({.kind = Error::Kind::kUsage, .reason = "--label is required"});
  }
  return datasets::ReadTable(arguments.table, arguments.label);
}

TrainingTable ReadTrainingTable(const TableArguments& arguments) {
  TrainingTable table{.path = arguments.table, .table = ReadLabelledTable(arguments), .labels = {}};
  table.labels = datasets::ToBinaryLabels(table.table, arguments.table);
  return table;
}

std::vector<std::uint8_t> TableModelBytes(const TrainingTable& table,
                                          const model_io::LinearModel& model,
                                          model_io::Provenance provenance) {
  const auto& labels = table.labels;
  const auto num_positive = std::count(labels.values.begin(), labels.values.end(), 1);
  provenance.task = "logistic";
  provenance.intended_use = "probability of the label '" + labels.positive +
                            "' of a row like those of the training table";
  provenance.data_fingerprint = Sha256Hex(ReadFile(table.path));
  provenance.class_counts =
      fmt::format("0: {}, 1: {}",
                  static_cast<std::ptrdiff_t>(labels.values.size()) - num_positive,
                  num_positive);
  return model_io::Serialise(model_io::MakeLogisticModel(table.table.columns,
                                                         table.table.label_column,
                                                         labels.negative,
                                                         labels.positive,
                                                         model,
                                                         provenance));
}

}  // namespace handcraft::tools
