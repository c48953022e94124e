// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/utf8.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/lda_options.h"
#include "tools/progress_bar.h"
#include "tools/table_command.h"
#include "tools/text_table.h"
#include "tools/training_table.h"
#include "trainers/lda/lda.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct TrainLdaOptions {
  TableArguments arguments = {};
  lda::Options lda = {};
};

Json ToJson(const TrainLdaOptions& options, const TrainingTable& table, const lda::Result& result) {
  const lda::Summary& summary = result.summary;
  Json weights = Json::object();
  for (std::size_t j = 0; j < result.weights.size(); ++j) {
    weights[table.table.columns[j]] = result.weights[j];
  }
  return {{"table", options.arguments.table},
          {"label_column", table.table.label_column},
          {"negative_label", table.labels.negative},
          {"positive_label", table.labels.positive},
          {"num_samples", summary.num_samples},
          {"num_positive", summary.num_positive},
          {"intercept", result.intercept},
          {"weights", weights},
          {"shrinkage", summary.shrinkage},
          {"positive_prior", summary.positive_prior},
          {"reciprocal_condition", summary.reciprocal_condition},
          {"deviance", summary.deviance},
          {"null_deviance", summary.null_deviance},
          {"constant_features", summary.constant_features},
          {"termination", NameOf(summary.termination)},
          {"message", summary.message},
          {"model", options.arguments.out}};
}

std::string ToText(const TrainingTable& table, const lda::Result& result) {
  const lda::Summary& summary = result.summary;
  TextTable weights({"feature", "weight", "weight · spread within classes"});
  for (std::size_t j = 0; j < result.weights.size(); ++j) {
    weights.AddRow({table.table.columns[j],
                    fmt::format("{:.6g}", result.weights[j]),
                    fmt::format("{:.3f}", result.weights[j] * result.feature_scale[j])});
  }
  weights.AddRow({"(intercept)", fmt::format("{:.6g}", result.intercept), "-"});
  return weights.ToText() +
         fmt::format(
             "\n{} samples, {} of them '{}', prior {:.4g}; {}, reciprocal condition {:.1e}\n"
             "Deviance {:.6g} (without features {:.6g})\n",
             summary.num_samples,
             summary.num_positive,
             table.labels.positive,
             summary.positive_prior,
             summary.message,
             summary.reciprocal_condition,
             summary.deviance,
             summary.null_deviance);
}

void WriteModel(const TrainLdaOptions& options,
                const TrainingTable& table,
                const lda::Result& result) {
  const lda::Summary& summary = result.summary;
  WriteFileAtomically(
      options.arguments.out,
      TableModelBytes(table,
                      {.weights = result.weights,
                       .intercept = result.intercept,
                       .feature_mean = result.feature_mean,
                       .feature_scale = result.feature_scale},
                      {.name = options.arguments.name,
                       .algorithm = "lda",
                       .hyper_parameters = FieldsToText(options.lda, "lda."),
                       .metrics = {{"train.deviance", NumberToText(summary.deviance)},
                                   {"train.null_deviance", NumberToText(summary.null_deviance)},
                                   {"train.shrinkage", NumberToText(summary.shrinkage)},
                                   {"train.termination", std::string(NameOf(summary.termination))},
                                   {"train.num_samples", NumberToText(summary.num_samples)}}}));
}

void RunTrainLda(const TrainLdaOptions& options, const Console& console) {
  const TrainingTable table = ReadTrainingTable(options.arguments);
  const lda::Result result = NamingTable(table.path, [&] {
    ProgressBar bar(console);
    lda::Options lda = options.lda;
    lda.progress = bar.Callback();
    return lda::TrainLda(table.Matrix(), table.labels.values, lda);
  });
  RequireUsable(result.summary, table.table.columns, console);
  if (!options.arguments.out.empty()) WriteModel(options, table, result);
  if (options.arguments.json) {
    console.Print(ToJson(options, table, result));
    return;
  }
  console.out << ToText(table, result);
  if (!options.arguments.out.empty()) {
    console.out << "\nModel of P(" << table.table.label_column << " = " << table.labels.positive
                << ") written to " << OnOneLine(options.arguments.out) << '\n';
  }
}

}  // namespace

void AddTrainLda(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainLdaOptions>();
  CLI::App* command = AddTableCommand(
      parent,
      "lda",
      "Linear discriminant analysis on any table with two labels; a logistic model comes out",
      options->arguments);
  AddThreadsOption(*command, options->lda.num_threads);
  AddLdaOptions(*command, options->lda);
  SetExample(*command, "handcraft train lda datasets/samples/tables/breast_w.csv --label class");
  command->callback([options, &console] { RunTrainLda(*options, console); });
}

}  // namespace handcraft::tools
