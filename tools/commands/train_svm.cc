// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/table.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/svm_models.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/svm_options.h"
#include "tools/table_command.h"
#include "tools/text_table.h"
#include "tools/training_table.h"
#include "trainers/svm/svm.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct TrainSvmOptions {
  TableArguments arguments = {};
  svm::Options svm = {};
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
            const svm::Result& result) {
  const ClassCounts counts = CountClasses(labels, result.model);
  return {{"table", options.arguments.table},
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

void RunTrainSvm(const TrainSvmOptions& options, const Console& console) {
  const datasets::Table table = ReadLabelledTable(options.arguments);
  const datasets::ClassLabels labels = datasets::ToClassLabels(table, options.arguments.table);
  const svm::Result result = NamingTable(options.arguments.table, [&] {
    ProgressBar bar(console);
    svm::Options svm = options.svm;
    svm.progress = bar.Callback();
    return svm::TrainSvm(MatrixOf(table), labels.values, svm);
  });
  RequireUsable(result.summary);
  const std::string& out = options.arguments.out;
  if (!out.empty()) WriteFileAtomically(out, ModelBytes(options, table, labels, result));
  if (options.arguments.json) {
    console.Print(ToJson(options, table, labels, result));
    return;
  }
  console.out << ToText(labels, result);
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
  SetExample(*command,
             "handcraft train svm datasets/samples/tables/breast_w.csv --label class --kernel rbf");
  command->callback([options, &console] { RunTrainSvm(*options, console); });
}

}  // namespace handcraft::tools
