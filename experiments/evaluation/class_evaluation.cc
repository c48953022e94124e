// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/class_evaluation.h"

#include <algorithm>
#include <memory>

#include <nlohmann/json.hpp>

#include "experiments/evaluation/json_text.h"
#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

struct FreeWorkspace {
  void operator()(hc_workspace* workspace) const noexcept { hc_workspace_free(workspace); }
};

}  // namespace

std::vector<RowClass> ClassifyTable(const hc_model* model, const datasets::Table& table) {
  const std::size_t num_features = hc_model_num_features(model);
  HC_CHECK(table.columns.size() == num_features, table.columns.size(), num_features);
  hc_workspace* scratch = nullptr;
  const hc_status created = hc_row_workspace_create(model, &scratch);
  HC_CHECK(created == HC_OK, hc_status_message(created));
  const std::unique_ptr<hc_workspace, FreeWorkspace> workspace(scratch);
  std::vector<RowClass> classes;
  for (std::size_t row = 0; row < table.num_rows; ++row) {
    hc_class_prediction prediction{};
    const hc_status status = hc_classify_row(model,
                                             workspace.get(),
                                             table.values.data() + row * num_features,
                                             num_features,
                                             &prediction);
    HC_CHECK(status == HC_OK, hc_status_message(status));
    classes.push_back({.number = static_cast<std::size_t>(prediction.number),
                       .is_rejected = prediction.rejected != 0,
                       .margin = prediction.margin});
  }
  return classes;
}

ClassEvaluation EvaluateClasses(const hc_model* model,
                                const TableModel& names,
                                const datasets::Table& table,
                                const std::filesystem::path& path) {
  if (table.num_rows == 0) {
    throw Error({.path = path.string(), .reason = "the table has no rows to evaluate"});
  }
  RequireLabelsOf(names, table, path);
  const std::size_t num_classes = names.classes.size();
  ClassEvaluation evaluation{
      .num_rows = table.num_rows,
      .label_column = names.label_column,
      .classes = names.classes,
      .confusion = std::vector(num_classes, std::vector<std::size_t>(num_classes + 1, 0)),
      .accuracy = {}};
  const std::vector<RowClass> predictions = ClassifyTable(model, table);
  for (std::size_t row = 0; row < table.num_rows; ++row) {
    const auto label = std::find(names.classes.begin(), names.classes.end(), table.labels[row]);
    const auto truth = static_cast<std::size_t>(label - names.classes.begin());
    const RowClass& said = predictions[row];
    ++evaluation.confusion[truth][said.is_rejected ? num_classes : said.number];
    evaluation.num_correct += !said.is_rejected && said.number == truth ? 1 : 0;
    evaluation.num_rejected += said.is_rejected ? 1 : 0;
  }
  evaluation.accuracy = WilsonInterval(evaluation.num_correct, evaluation.num_rows);
  return evaluation;
}

std::string ToJson(const ClassEvaluation& evaluation) {
  nlohmann::ordered_json json = {{"kind", "class_evaluation"},
                                 {"num_rows", evaluation.num_rows},
                                 {"label_column", evaluation.label_column},
                                 {"classes", evaluation.classes}};
  AddEstimate("accuracy", evaluation.accuracy, json);
  json["num_correct"] = evaluation.num_correct;
  json["num_rejected"] = evaluation.num_rejected;
  json["confusion"] = evaluation.confusion;
  return JsonText(json);
}

}  // namespace handcraft::experiments
