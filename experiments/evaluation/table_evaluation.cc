// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/table_evaluation.h"

#include <numeric>

#include "experiments/evaluation/json_text.h"
#include "experiments/evaluation/table_model.h"
#include "experiments/metrics/grouped_ranking.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kMaxRocPoints = 201;

TableModel NamesOf(const hc_model* model, const std::filesystem::path& path) {
  HC_CHECK(model != nullptr);
  if (hc_model_kind(model) != HC_KIND_LOGISTIC) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = path.string(),
                 .reason = "the model reads no tables: it is no logistic model",
                 .remedy = "evaluate it on a labelled image set"});
  }
  const auto metadata = [model](const char* key) {
    const char* value = hc_model_metadata(model, key);
    return std::string(value == nullptr ? "" : value);
  };
  return {.columns = {},
          .label_column = metadata("hc.label_column"),
          .negative_label = metadata("hc.labels.0"),
          .positive_label = metadata("hc.labels.1"),
          .classes = {metadata("hc.labels.0"), metadata("hc.labels.1")}};
}

// Rows are drawn as they are: each is a group of its own.
Estimate EstimateAuc(const std::vector<double>& probabilities,
                     const std::vector<std::uint8_t>& labels,
                     const TableEvaluationOptions& options) {
  std::vector<std::size_t> rows(labels.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const GroupedRanking ranking(probabilities, labels, rows, rows.size());
  return ranking.Bootstrap(options.bootstrap_resamples, options.seed, options.num_threads).auc;
}

}  // namespace

void TableEvaluationOptions::Validate() const {
  RequireOption(threshold > 0.0 && threshold < 1.0,
                "TableEvaluationOptions.threshold",
                threshold,
                "in (0, 1)");
  RequireOption(bootstrap_resamples >= 1,
                "TableEvaluationOptions.bootstrap_resamples",
                bootstrap_resamples,
                "at least 1");
  RequireOption(num_threads >= 1, "TableEvaluationOptions.num_threads", num_threads, "at least 1");
}

TableEvaluation EvaluateTable(const hc_model* model,
                              const datasets::Table& table,
                              const std::filesystem::path& path,
                              const TableEvaluationOptions& options) {
  options.Validate();
  const TableModel names = NamesOf(model, path);
  if (table.num_rows == 0) {
    throw Error({.path = path.string(), .reason = "the table has no rows to evaluate"});
  }
  RequireLabelsOf(names, table, path);
  std::vector<std::uint8_t> labels;
  labels.reserve(table.num_rows);
  for (const std::string& label : table.labels) labels.push_back(label == names.positive_label);
  const std::vector<double> probabilities = PredictTable(model, table);

  TableEvaluation evaluation;
  evaluation.options = options;
  evaluation.num_rows = table.num_rows;
  evaluation.label_column = names.label_column;
  evaluation.negative_label = names.negative_label;
  evaluation.positive_label = names.positive_label;
  evaluation.confusion = CountConfusion(probabilities, labels, options.threshold);
  evaluation.accuracy =
      WilsonInterval(evaluation.confusion.true_positive + evaluation.confusion.true_negative,
                     evaluation.confusion.Total());
  evaluation.auc = EstimateAuc(probabilities, labels, options);
  evaluation.log_loss = LogLoss(probabilities, labels);
  evaluation.brier = BrierScore(probabilities, labels);
  evaluation.roc = RocCurve(probabilities, labels, kMaxRocPoints);
  return evaluation;
}

std::string ToJson(const TableEvaluation& evaluation) {
  nlohmann::ordered_json json = {{"kind", "table_evaluation"},
                                 {"options",
                                  {{"threshold", evaluation.options.threshold},
                                   {"bootstrap_resamples", evaluation.options.bootstrap_resamples},
                                   {"seed", evaluation.options.seed}}},
                                 {"num_rows", evaluation.num_rows},
                                 {"label_column", evaluation.label_column},
                                 {"negative_label", evaluation.negative_label},
                                 {"positive_label", evaluation.positive_label}};
  AddEstimate("accuracy", evaluation.accuracy, json);
  AddEstimate("auc", evaluation.auc, json);
  json["log_loss"] = evaluation.log_loss;
  json["brier"] = evaluation.brier;
  json["confusion"] = ConfusionJson(evaluation.confusion);
  json["roc"] = RocJson(evaluation.roc);
  return JsonText(json);
}

}  // namespace handcraft::experiments
