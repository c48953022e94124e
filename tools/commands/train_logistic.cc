// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/formats/table.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/utf8.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/logistic_options.h"
#include "tools/progress_bar.h"
#include "tools/table_command.h"
#include "tools/training_outcome.h"
#include "tools/training_table.h"
#include "trainers/logistic_irls/logistic_irls.h"
#include "trainers/logistic_irls/summary_text.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct TrainLogisticOptions {
  TableArguments arguments = {};
  logistic::Options logistic = {};
};

// One line of R's table of coefficients; what is not known is null.
Json CoefficientJson(const std::string& name, double coefficient, double standard_error) {
  const logistic::WaldTest test = logistic::ComputeWaldTest(coefficient, standard_error);
  return {{"name", name},
          {"coefficient", coefficient},
          {"standard_error", standard_error},
          {"z", test.z},
          {"p_value", test.p_value}};
}

Json ToJson(const TrainLogisticOptions& options,
            const datasets::Table& table,
            const datasets::BinaryLabels& labels,
            const logistic::Result& result) {
  const logistic::Summary& summary = result.summary;
  const bool has_errors = !result.standard_errors.empty();
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  Json coefficients = Json::array();
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    coefficients.push_back(CoefficientJson(
        table.columns[j], result.weights[j], has_errors ? result.standard_errors[j] : kUnknown));
  }
  return {{"table", options.arguments.table},
          {"label_column", table.label_column},
          {"negative_label", labels.negative},
          {"positive_label", labels.positive},
          {"num_samples", summary.num_samples},
          {"num_positive", summary.num_positive},
          {"intercept",
           CoefficientJson("(intercept)",
                           result.intercept,
                           has_errors ? result.intercept_standard_error : kUnknown)},
          {"coefficients", std::move(coefficients)},
          {"deviance", summary.deviance},
          {"null_deviance", summary.null_deviance},
          {"aic", summary.aic},
          {"rank", summary.rank},
          {"aliased_features", summary.aliased_features},
          {"iterations", summary.iterations},
          {"warm_start_iterations", summary.warm_start_iterations},
          {"step_halvings", summary.step_halvings},
          {"fell_back_to_double", summary.fell_back_to_double},
          {"gradient_norm", summary.gradient_norm},
          {"reciprocal_condition", summary.reciprocal_condition},
          {"termination", NameOf(summary.termination)},
          {"message", summary.message},
          {"model", options.arguments.out}};
}

std::vector<std::uint8_t> ModelBytes(const TrainLogisticOptions& options,
                                     const TrainingTable& table,
                                     const logistic::Result& result) {
  const logistic::Summary& summary = result.summary;
  return TableModelBytes(
      table,
      {.weights = result.weights,
       .intercept = result.intercept,
       .feature_mean = result.feature_mean,
       .feature_scale = result.feature_scale},
      {.name = options.arguments.name,
       .algorithm = "logistic_irls",
       .hyper_parameters = FieldsToText(options.logistic, "irls."),
       .metrics = {{"train.deviance", NumberToText(summary.deviance)},
                   {"train.null_deviance", NumberToText(summary.null_deviance)},
                   {"train.aic", NumberToText(summary.aic)},
                   {"train.gradient_norm", NumberToText(summary.gradient_norm)},
                   {"train.iterations", NumberToText(summary.iterations)},
                   {"train.termination", std::string(NameOf(summary.termination))},
                   {"train.num_samples", NumberToText(summary.num_samples)}}});
}

logistic::Result Train(const TrainLogisticOptions& options,
                       const TrainingTable& table,
                       const Console& console) {
  ProgressBar bar(console);
  logistic::Options logistic = options.logistic;
  logistic.progress = bar.Callback();
  return NamingTable(table.path, [&] {
    return logistic::TrainLogistic(table.Matrix(), table.labels.values, logistic);
  });
}

// The summary is printed before RequireUsable throws: it is what shows why there is no model.
void RunTrainLogistic(const TrainLogisticOptions& options, const Console& console) {
  const TrainingTable training = ReadTrainingTable(options.arguments);
  const datasets::Table& table = training.table;
  const datasets::BinaryLabels& labels = training.labels;
  const logistic::Result result = Train(options, training, console);
  if (!options.arguments.out.empty() && IsUsable(result.summary)) {
    WriteFileAtomically(options.arguments.out, ModelBytes(options, training, result));
  }
  if (options.arguments.json) {
    console.Print(ToJson(options, table, labels, result));
  } else {
    console.out << logistic::SummaryTable(result, table.columns);
    if (!options.arguments.out.empty() && IsUsable(result.summary)) {
      console.out << "\nModel of P(" << table.label_column << " = " << labels.positive
                  << ") written to " << OnOneLine(options.arguments.out) << '\n';
    }
  }
  RequireUsable(result.summary, table.columns, console);
}

}  // namespace

void AddTrainLogistic(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainLogisticOptions>();
  CLI::App* command =
      AddTableCommand(parent,
                      "logistic",
                      "Logistic regression on any table with two labels, with standard errors",
                      options->arguments);
  AddSeedOption(*command, options->logistic.seed);
  AddThreadsOption(*command, options->logistic.num_threads);
  AddLogisticOptions(*command, options->logistic);
  SetExample(*command,
             "handcraft train logistic datasets/samples/tables/breast_w.csv --label class");
  command->callback([options, &console] { RunTrainLogistic(*options, console); });
}

}  // namespace handcraft::tools
