// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/table_prediction.h"

#include <utility>
#include <vector>

#include "datasets/formats/csv_records.h"
#include "experiments/evaluation/class_evaluation.h"
#include "lib/core/fields.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string ProbabilitiesCsv(const experiments::TableModel& model,
                             const std::vector<double>& probabilities) {
  std::string text = datasets::CsvField("probability of " + model.positive_label) + "\n";
  for (const double probability : probabilities) text += NumberToText(probability) + "\n";
  return text;
}

TablePrediction PredictProbabilities(const hc_model* model,
                                     const experiments::TableModel& names,
                                     const datasets::Table& table) {
  const std::vector<double> probabilities = experiments::PredictTable(model, table);
  return {.json = {{"positive_label", names.positive_label}, {"probabilities", probabilities}},
          .csv = ProbabilitiesCsv(names, probabilities)};
}

// A rejected row has no class: an empty field, null.
TablePrediction PredictClasses(const hc_model* model,
                               const experiments::TableModel& names,
                               const datasets::Table& table) {
  TablePrediction prediction{.json = {{"classes", Json::array()}, {"margins", Json::array()}},
                             .csv = "class,margin\n"};
  for (const experiments::RowClass& row : experiments::ClassifyTable(model, table)) {
    const Json name = row.is_rejected ? Json() : Json(names.classes[row.number]);
    prediction.json["classes"].push_back(name);
    prediction.json["margins"].push_back(row.margin);
    if (!row.is_rejected) prediction.csv += datasets::CsvField(names.classes[row.number]);
    prediction.csv += ',';
    prediction.csv += NumberToText(row.margin);
    prediction.csv += '\n';
  }
  return prediction;
}

}  // namespace

TablePrediction PredictTable(const hc_model* model,
                             const experiments::TableModel& table_model,
                             const datasets::Table& table) {
  return hc_model_kind(model) == HC_KIND_SVM ? PredictClasses(model, table_model, table)
                                             : PredictProbabilities(model, table_model, table);
}

}  // namespace handcraft::tools
