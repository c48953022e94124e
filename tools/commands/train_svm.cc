// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <filesystem>
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
#include "lib/core/counted.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/core/utf8.h"
#include "lib/model_io/svm_models.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/svm_fit.h"
#include "tools/svm_growth.h"
#include "tools/svm_options.h"
#include "tools/svm_rejection.h"
#include "tools/table_command.h"
#include "tools/text_table.h"
#include "tools/training_table.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/margins.h"
#include "trainers/svm/rejection.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct TrainSvmOptions {
  TableArguments arguments = {};
  SvmFitOptions fit = {};
  SvmGrowth growth = {};
  NovelOptions novel = {};
};

// A machine with all that its file says of it.
struct TrainedSvm {
  datasets::Table table = {};
  datasets::ClassLabels labels = {};
  SvmFit fit = {};
  std::optional<svm::Calibration> rejection = {};
  std::optional<double> dropped_threshold = {};  // of the model a class was added to
  std::string parent = {};                       // its SHA-256
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

Json ToJson(const TrainSvmOptions& options, const TrainedSvm& trained) {
  const svm::Result& result = trained.fit.result;
  const ClassCounts counts = CountClasses(trained.labels, result.model);
  Json json = {{"table", options.arguments.table},
               {"label_column", trained.table.label_column},
               {"classes", trained.labels.names},
               {"num_samples", result.summary.num_samples},
               {"class_samples", counts.samples},
               {"class_support_vectors", counts.support_vectors},
               {"num_features", trained.table.columns.size()}};
  trained.fit.options.VisitFields([&](const char* name, const auto& value) { json[name] = value; });
  json["gamma"] = result.model.similarity.gamma;
  json.update({{"num_machines", result.summary.num_machines},
               {"num_support_vectors", result.summary.num_support_vectors},
               {"iterations", result.summary.iterations},
               {"violation", result.summary.violation},
               {"termination", NameOf(result.summary.termination)},
               {"message", result.summary.message},
               {"model", options.arguments.out}});
  if (trained.fit.held_out) {
    json["num_folds"] = options.fit.num_folds;
    json["num_tried"] = trained.fit.num_tried;
    json["held_out_accuracy"] = trained.fit.held_out->accuracy;
  }
  if (trained.rejection) AddJson(*trained.rejection, json);
  if (trained.dropped_threshold) json["dropped_threshold"] = *trained.dropped_threshold;
  return json;
}

// Only what the kernel reads.
std::string Describe(const svm::Options& options, double gamma) {
  using features::SimilarityType;
  std::string text = fmt::format("kernel {}", features::NameOf(options.kernel));
  if (options.kernel == SimilarityType::kPolynomial) {
    text += fmt::format(", degree {}, coef0 {}", options.degree, options.coef0);
  }
  if (options.kernel != SimilarityType::kLinear) text += fmt::format(", gamma {:.4g}", gamma);
  return text + fmt::format(", C {}", options.penalty);
}

std::string HeldOutText(const TrainedSvm& trained) {
  std::string text;
  if (trained.fit.num_tried > 1) {
    text += fmt::format("Best of {} combinations: {}\n",
                        trained.fit.num_tried,
                        Describe(trained.fit.options, trained.fit.result.model.similarity.gamma));
  }
  if (trained.fit.held_out) {
    text += fmt::format("Held out in turns, {:.2f} % are right\n",
                        100.0 * trained.fit.held_out->accuracy);
  }
  if (trained.rejection) text += tools::ToText(*trained.rejection, "rows");
  return text;
}

std::string ToText(const TrainedSvm& trained) {
  const svm::Result& result = trained.fit.result;
  const ClassCounts counts = CountClasses(trained.labels, result.model);
  TextTable classes({"class", "samples", "support vectors"});
  for (std::size_t c = 0; c < trained.labels.names.size(); ++c) {
    classes.AddRow({trained.labels.names[c],
                    std::to_string(counts.samples[c]),
                    std::to_string(counts.support_vectors[c])});
  }
  return classes.ToText() +
         fmt::format("\n{}, {} trained, {}; {}\n",
                     Counted(result.summary.num_samples, "sample"),
                     Counted(result.summary.num_machines, "machine"),
                     Counted(result.summary.num_support_vectors, "support vector"),
                     result.summary.message) +
         HeldOutText(trained);
}

model_io::Provenance ProvenanceOf(const TrainSvmOptions& options, const TrainedSvm& trained) {
  const svm::Summary& summary = trained.fit.result.summary;
  const ClassCounts counts = CountClasses(trained.labels, trained.fit.result.model);
  model_io::Provenance provenance{
      .name = options.arguments.name,
      .task = "svm",
      .intended_use = "class of a row like those of the training table",
      .algorithm = "svm",
      .data_fingerprint = Sha256Hex(ReadFile(options.arguments.table)),
      .parent = trained.parent,
      .hyper_parameters = FieldsToText(trained.fit.options, "svm."),
      .metrics = {{"train.num_samples", NumberToText(summary.num_samples)},
                  {"train.num_support_vectors", NumberToText(summary.num_support_vectors)},
                  {"train.iterations", NumberToText(summary.iterations)},
                  {"train.violation", NumberToText(summary.violation)},
                  {"train.termination", std::string(NameOf(summary.termination))}}};
  if (trained.rejection) {
    AddMetrics(*trained.rejection, provenance.metrics);
    provenance.hyper_parameters["svm.novel_fingerprint"] = Sha256Hex(ReadFile(options.novel.path));
  }
  for (std::size_t c = 0; c < counts.samples.size(); ++c) {
    provenance.class_counts += fmt::format("{}{}: {}", c == 0 ? "" : ", ", c, counts.samples[c]);
  }
  return provenance;
}

std::vector<std::uint8_t> ModelBytes(const TrainSvmOptions& options, const TrainedSvm& trained) {
  return model_io::Serialise(model_io::MakeSvmModel(trained.fit.result.model,
                                                    {.columns = trained.table.columns,
                                                     .classes = trained.labels.names,
                                                     .label_column = trained.table.label_column},
                                                    ProvenanceOf(options, trained)));
}

void RequireFolds(const TrainSvmOptions& options) {
  const bool has_folds = options.fit.num_folds > 0;
  if (!options.novel.path.empty() && !has_folds) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "--novel needs --folds: novel rows are told from held-out known ones",
                 .remedy = "give --folds 5"});
  }
  if (!options.growth.new_class.empty() && options.novel.path.empty() && has_folds) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "--add-class holds rows out for --novel alone, which is not given",
                 .remedy = "leave --folds out"});
  }
}

datasets::Table ReadNovelRows(const TrainSvmOptions& options, const TrainedSvm& trained) {
  const std::string& path = options.novel.path;
  datasets::Table novel = experiments::ReadTableFor({.columns = trained.table.columns,
                                                     .label_column = trained.table.label_column,
                                                     .negative_label = {},
                                                     .positive_label = {},
                                                     .classes = trained.labels.names},
                                                    path);
  for (const std::string& label : novel.labels) {
    const auto& known = trained.labels.names;
    if (std::find(known.begin(), known.end(), label) == known.end()) continue;
    throw Error({.path = path,
                 .reason = fmt::format(
                     "a row of the class '{}', which is one to tell, is not novel", label),
                 .remedy = "give rows of no class"});
  }
  return novel;
}

void RejectNovelRows(const TrainSvmOptions& options, TrainedSvm& trained) {
  if (options.novel.path.empty()) return;
  const datasets::Table novel = ReadNovelRows(options, trained);
  trained.rejection = NamingTable(options.novel.path, [&] {
    return svm::RejectNovel(trained.fit.held_out->margins,
                            MatrixOf(novel),
                            options.novel.max_lost,
                            options.fit.svm.num_threads,
                            trained.fit.result.model);
  });
}

TrainedSvm TrainAll(const TrainSvmOptions& options) {
  TrainedSvm trained;
  trained.table = ReadLabelledTable(options.arguments);
  trained.labels = datasets::ToClassLabels(trained.table, options.arguments.table);
  trained.fit = NamingTable(options.arguments.table, [&] {
    return FitSvm(MatrixOf(trained.table), trained.labels.values, options.fit);
  });
  return trained;
}

TrainedSvm TrainNewClass(const TrainSvmOptions& options) {
  const std::array inputs = {std::filesystem::path(options.arguments.table),
                             std::filesystem::path(options.growth.model)};
  RequireWritable(options.arguments.out);
  RequireNotAnInput(options.arguments.out, inputs);
  const GrowingSvm growing = ReadGrowingSvm(options.growth);
  TrainedSvm trained;
  trained.table = experiments::ReadTableFor({.columns = growing.names.columns,
                                             .label_column = growing.names.label_column,
                                             .negative_label = {},
                                             .positive_label = {}},
                                            options.arguments.table);
  trained.labels =
      LabelsAmong(growing.names.classes, trained.table.labels, options.arguments.table);
  trained.parent = growing.sha256;
  trained.fit.options = growing.OptionsOf(options.fit.svm);
  trained.fit.result = NamingTable(options.arguments.table, [&] {
    return svm::AddClass(
        growing.model, MatrixOf(trained.table), trained.labels.values, trained.fit.options);
  });
  RequireUsable(trained.fit.result.summary);
  trained.dropped_threshold = growing.model.rejection_threshold;
  if (!options.novel.path.empty()) {
    trained.fit.held_out = NamingTable(options.arguments.table, [&] {
      return svm::CrossValidateLike(
          growing.model,
          MatrixOf(trained.table),
          trained.labels.values,
          svm::StratifiedFolds(trained.labels.values, options.fit.num_folds),
          trained.fit.options);
    });
    trained.dropped_threshold.reset();
  }
  return trained;
}

void RunTrainSvm(TrainSvmOptions options, const Console& console) {
  ProgressBar bar(console);
  options.fit.svm.progress = bar.Callback();
  RequireFolds(options);
  TrainedSvm trained =
      options.growth.new_class.empty() ? TrainAll(options) : TrainNewClass(options);
  RejectNovelRows(options, trained);
  bar.Clear();
  if (trained.dropped_threshold) console.Warn(DroppedThresholdText(*trained.dropped_threshold));
  const std::string& out = options.arguments.out;
  if (!out.empty()) WriteFileAtomically(out, ModelBytes(options, trained));
  if (options.arguments.json) {
    console.Print(ToJson(options, trained));
    return;
  }
  console.out << ToText(trained);
  if (!out.empty())
    console.out << "\nModel of " << trained.table.label_column << " written to " << OnOneLine(out)
                << '\n';
}

}  // namespace

void AddTrainSvm(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainSvmOptions>();
  CLI::App* command = AddTableCommand(parent,
                                      "svm",
                                      "Support vector machine on any table with two labels or more",
                                      options->arguments);
  AddThreadsOption(*command, options->fit.svm.num_threads);
  AddSvmFitOptions(*command, options->fit);
  AddNovelOptions(*command, "TABLE", "rows", options->novel);
  AddSvmGrowthOptions(*command, "Model to add the class to", options->growth);
  SetExample(*command,
             "handcraft train svm datasets/samples/tables/breast_w.csv --label class --kernel rbf");
  command->callback([options, &console] { RunTrainSvm(*options, console); });
}

}  // namespace handcraft::tools
