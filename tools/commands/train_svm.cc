// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/table.h"
#include "experiments/evaluation/class_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/evaluation/table_model.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/svm_models.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/svm_options.h"
#include "tools/table_command.h"
#include "tools/text_table.h"
#include "tools/training_table.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/rejection.h"
#include "trainers/svm/svm.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct TrainSvmOptions {
  TableArguments arguments = {};
  svm::Options svm = {};
  std::size_t num_folds = 0;  // 0: none
  std::string novel = {};     // table of what belongs to no class; empty: none
};

// What was found on rows that a model had not seen.
struct HeldOut {
  std::optional<svm::CrossValidation> validation = {};
  std::optional<svm::Rejection> rejection = {};
};

struct ClassCounts {
  std::vector<std::size_t> samples;
  std::vector<std::size_t> support_vectors;
};

ClassCounts CountClasses(const datasets::ClassLabels& labels, const model_io::SvmModel& model) {
  ClassCounts counts{.samples = std::vector<std::size_t>(labels.names.size()),
                     .support_vectors = std::vector<std::size_t>(labels.names.size())};
  for (const std::uint32_t c : labels.values) ++counts.samples[c];
  for (const std::int32_t c : model.support_classes) {
    ++counts.support_vectors[static_cast<std::size_t>(c)];
  }
  return counts;
}

Json ToJson(const TrainSvmOptions& options,
            const datasets::Table& table,
            const datasets::ClassLabels& labels,
            const svm::Result& result,
            const HeldOut& held_out) {
  const ClassCounts counts = CountClasses(labels, result.model);
  Json json = {{"table", options.arguments.table},
               {"label_column", table.label_column},
               {"classes", labels.names},
               {"num_samples", result.summary.num_samples},
               {"class_samples", counts.samples},
               {"class_support_vectors", counts.support_vectors},
               {"num_features", table.columns.size()},
               {"kernel", features::NameOf(result.model.similarity.type)},
               {"gamma", result.model.similarity.gamma},
               {"num_machines", result.summary.num_machines},
               {"num_support_vectors", result.summary.num_support_vectors},
               {"iterations", result.summary.iterations},
               {"violation", result.summary.violation},
               {"termination", NameOf(result.summary.termination)},
               {"message", result.summary.message},
               {"model", options.arguments.out}};
  if (held_out.validation) {
    json["num_folds"] = options.num_folds;
    json["held_out_accuracy"] = held_out.validation->accuracy;
  }
  if (held_out.rejection) {
    json["rejection_threshold"] = held_out.rejection->threshold;
    json["false_rejection"] = held_out.rejection->false_rejection;
    json["false_acceptance"] = held_out.rejection->false_acceptance;
  }
  return json;
}

std::string HeldOutText(const HeldOut& held_out) {
  std::string text;
  if (held_out.validation) {
    text += fmt::format("Held out in turns, {:.2f} % are right\n",
                        100.0 * held_out.validation->accuracy);
  }
  if (held_out.rejection) {
    text += fmt::format(
        "None of these below a margin of {:.4g}: {:.2f} % of the held-out rows, and all but "
        "{:.2f} % of the novel ones\n",
        held_out.rejection->threshold,
        100.0 * held_out.rejection->false_rejection,
        100.0 * held_out.rejection->false_acceptance);
  }
  return text;
}

std::string ToText(const datasets::ClassLabels& labels, const svm::Result& result) {
  const ClassCounts counts = CountClasses(labels, result.model);
  TextTable classes({"class", "samples", "support vectors"});
  for (std::size_t c = 0; c < labels.names.size(); ++c) {
    classes.AddRow({labels.names[c],
                    std::to_string(counts.samples[c]),
                    std::to_string(counts.support_vectors[c])});
  }
  return classes.ToText() + fmt::format("\n{} samples, {} machines, {} support vectors; {}\n",
                                        result.summary.num_samples,
                                        result.summary.num_machines,
                                        result.summary.num_support_vectors,
                                        result.summary.message);
}

std::vector<std::uint8_t> ModelBytes(const TrainSvmOptions& options,
                                     const datasets::Table& table,
                                     const datasets::ClassLabels& labels,
                                     const svm::Result& result) {
  const svm::Summary& summary = result.summary;
  const ClassCounts counts = CountClasses(labels, result.model);
  std::string class_counts;
  for (std::size_t c = 0; c < counts.samples.size(); ++c) {
    class_counts += fmt::format("{}{}: {}", c == 0 ? "" : ", ", c, counts.samples[c]);
  }
  return model_io::Serialise(model_io::MakeSvmModel(
      result.model,
      {.columns = table.columns, .classes = labels.names, .label_column = table.label_column},
      {.name = options.arguments.name,
       .task = "svm",
       .intended_use = "class of a row like those of the training table",
       .algorithm = "svm",
       .data_fingerprint = Sha256Hex(ReadFile(options.arguments.table)),
       .class_counts = class_counts,
       .hyper_parameters = FieldsToText(options.svm, "svm."),
       .metrics = {{"train.num_samples", NumberToText(summary.num_samples)},
                   {"train.num_support_vectors", NumberToText(summary.num_support_vectors)},
                   {"train.iterations", NumberToText(summary.iterations)},
                   {"train.violation", NumberToText(summary.violation)},
                   {"train.termination", std::string(NameOf(summary.termination))}}}));
}

// Margins of the novel rows, as the robot's runtime gives them.
std::vector<double> NovelMargins(const TrainSvmOptions& options,
                                 const datasets::Table& table,
                                 const datasets::ClassLabels& labels,
                                 const svm::Result& result) {
  const experiments::LoadedModel model =
      experiments::LoadModel(ModelBytes(options, table, labels, result));
  const experiments::TableModel names{.columns = table.columns,
                                      .label_column = table.label_column,
                                      .negative_label = {},
                                      .positive_label = {},
                                      .classes = labels.names};
  std::vector<double> margins;
  for (const experiments::RowClass& row :
       experiments::ClassifyTable(model.get(), experiments::ReadTableFor(names, options.novel))) {
    margins.push_back(row.margin);
  }
  return margins;
}

// Cross-validates if asked to, and sets the model's threshold when there are novel rows.
HeldOut HoldOut(const TrainSvmOptions& options,
                const datasets::Table& table,
                const datasets::ClassLabels& labels,
                svm::Result& result) {
  HeldOut held_out;
  if (options.num_folds == 0) {
    if (options.novel.empty()) return held_out;
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = "--novel needs --folds: the margins of known rows must be held-out ones"});
  }
  held_out.validation = NamingTable(options.arguments.table, [&] {
    return svm::CrossValidateRows(MatrixOf(table),
                                  labels.values,
                                  svm::StratifiedFolds(labels.values, options.num_folds),
                                  options.svm);
  });
  if (options.novel.empty()) return held_out;
  held_out.rejection = svm::CalibrateRejection(held_out.validation->margins,
                                               NovelMargins(options, table, labels, result));
  result.model.rejection_threshold = held_out.rejection->threshold;
  return held_out;
}

void RunTrainSvm(const TrainSvmOptions& options, const Console& console) {
  const datasets::Table table = ReadLabelledTable(options.arguments);
  const datasets::ClassLabels labels = datasets::ToClassLabels(table, options.arguments.table);
  svm::Result result = NamingTable(options.arguments.table, [&] {
    ProgressBar bar(console);
    svm::Options svm = options.svm;
    svm.progress = bar.Callback();
    return svm::TrainSvm(MatrixOf(table), labels.values, svm);
  });
  RequireUsable(result.summary);
  const HeldOut held_out = HoldOut(options, table, labels, result);
  const std::string& out = options.arguments.out;
  if (!out.empty()) WriteFileAtomically(out, ModelBytes(options, table, labels, result));
  if (options.arguments.json) {
    console.Print(ToJson(options, table, labels, result, held_out));
    return;
  }
  console.out << ToText(labels, result) << HeldOutText(held_out);
  if (!out.empty())
    console.out << "\nModel of " << table.label_column << " written to " << out << '\n';
}

}  // namespace

void AddTrainSvm(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainSvmOptions>();
  CLI::App* command = AddTableCommand(parent,
                                      "svm",
                                      "Support vector machine on any table with two labels or more",
                                      options->arguments);
  AddThreadsOption(*command, options->svm.num_threads);
  AddSvmOptions(*command, options->svm);
  AddNumber(*command,
            "--folds",
            options->num_folds,
            AnyNumber<std::size_t>(),
            "Cross-validate in so many folds, the same share of every class in each; 0: not")
      ->group(kSvmGroup);
  command
      ->add_option("--novel",
                   options->novel,
                   "Table of rows of no class: sets the margin below which a row is none of these")
      ->type_name("TABLE")
      ->group(kSvmGroup);
  SetExample(*command,
             "handcraft train svm datasets/samples/tables/breast_w.csv --label class --kernel rbf");
  command->callback([options, &console] { RunTrainSvm(*options, console); });
}

}  // namespace handcraft::tools
