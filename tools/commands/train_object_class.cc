// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/object_clouds.h"
#include "datasets/view_folds.h"
#include "experiments/metrics/binary_metrics.h"
#include "experiments/object_classes/object_class_training.h"
#include "lib/core/counted.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/object_class_models.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/object_class_options.h"
#include "tools/progress_bar.h"
#include "tools/svm_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using experiments::ObjectClassTraining;

struct TrainObjectClassOptions {
  std::string data;
  std::string split = "train";
  std::string out;
  std::string name = "object_class";
  std::string add_class;
  std::string to;
  bool search = false;
  bool json = false;
  experiments::ObjectClassOptions training;

  // Where the model goes: an old one is replaced unless it shall stay.
  [[nodiscard]] const std::string& Target() const { return out.empty() ? to : out; }
};

std::vector<std::size_t> CountRows(const ObjectClassTraining& training) {
  std::vector<std::size_t> counts(training.model.classes.size());
  for (const std::uint32_t c : training.classes) ++counts[c];
  return counts;
}

std::vector<std::size_t> CountSupportVectors(const ObjectClassTraining& training) {
  std::vector<std::size_t> counts(training.model.classes.size());
  for (const std::int32_t c : training.model.svm.support_classes) {
    ++counts[static_cast<std::size_t>(c)];
  }
  return counts;
}

Json ToJson(const TrainObjectClassOptions& options, const ObjectClassTraining& training) {
  const features::CloudDescriptor& descriptor = training.model.descriptor;
  const features::Similarity& kernel = training.model.svm.similarity;
  Json json = {{"data", options.data},
               {"classes", training.model.classes},
               {"class_rows", CountRows(training)},
               {"class_support_vectors", CountSupportVectors(training)},
               {"descriptor", features::NameOf(descriptor.type)},
               {"num_features", descriptor.NumFeatures()},
               {"kernel", features::NameOf(kernel.type)},
               {"degree", kernel.degree},
               {"gamma", kernel.gamma},
               {"coef0", kernel.coef0},
               {"penalty", training.svm.penalty},
               {"num_machines", training.summary.num_machines},
               {"num_support_vectors", training.summary.num_support_vectors},
               {"iterations", training.summary.iterations},
               {"num_validated", training.num_validated},
               {"num_correct", training.num_correct}};
  for (const experiments::TriedCombination& tried : training.tried) {
    json["tried"].push_back({{"kernel", tried.kernel},
                             {"degree", tried.degree},
                             {"gamma", tried.gamma},
                             {"coef0", tried.coef0},
                             {"penalty", tried.penalty},
                             {"num_correct", tried.num_correct}});
  }
  json["model"] = options.Target();
  return json;
}

std::string ToText(const ObjectClassTraining& training) {
  const std::vector<std::size_t> rows = CountRows(training);
  const std::vector<std::size_t> support_vectors = CountSupportVectors(training);
  TextTable classes({"class", "views and copies", "support vectors"});
  for (std::size_t c = 0; c < rows.size(); ++c) {
    classes.AddRow(
        {training.model.classes[c], std::to_string(rows[c]), std::to_string(support_vectors[c])});
  }
  const features::Similarity& kernel = training.model.svm.similarity;
  std::string text = classes.ToText() +
                     fmt::format("\n{} kernel, gamma {:.4g}; {} trained, {}; {}\n",
                                 features::NameOf(kernel.type),
                                 kernel.gamma,
                                 Counted(training.summary.num_machines, "machine"),
                                 Counted(training.summary.num_support_vectors, "support vector"),
                                 training.summary.message);
  if (training.num_validated > 0) {
    const experiments::Estimate accuracy =
        experiments::WilsonInterval(training.num_correct, training.num_validated);
    text += fmt::format(
        "Cross-validated: {} of {} right, {:.2f} % (95 % interval {:.2f} to {:.2f} %)\n",
        training.num_correct,
        Counted(training.num_validated, "view"),
        100.0 * accuracy.value,
        100.0 * accuracy.low,
        100.0 * accuracy.high);
  }
  return text;
}

// `parent`: the SHA-256 of the model that a class was added to.
std::vector<std::uint8_t> ModelBytes(const TrainObjectClassOptions& options,
                                     const datasets::ViewSet& set,
                                     const ObjectClassTraining& training,
                                     const std::string& parent) {
  const std::vector<std::size_t> rows = CountRows(training);
  std::string class_counts;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    class_counts += fmt::format("{}{}: {}", c == 0 ? "" : ", ", c, rows[c]);
  }
  experiments::ObjectClassOptions used = options.training;
  used.svm = training.svm;
  const datasets::MaskedCloud object = datasets::ReadObjectCloud(
      set,
      0,
      {.frame = training.model.descriptor.frame, .outlier_step = training.model.outlier_step});
  return model_io::Serialise(model_io::MakeObjectClassModel(
      training.model,
      object.View(),
      {.name = options.name,
       .task = "object-class",
       .intended_use = "class of an object that stands on a table, from its point cloud",
       .algorithm = "svm",
       .data_fingerprint = datasets::Fingerprint(set),
       .class_counts = class_counts,
       .parent = parent,
       .hyper_parameters = FieldsToText(used, "object_class."),
       .metrics = {
           {"train.num_samples", NumberToText(training.summary.num_samples)},
           {"train.num_support_vectors", NumberToText(training.summary.num_support_vectors)},
           {"train.iterations", NumberToText(training.summary.iterations)},
           {"train.termination", std::string(NameOf(training.summary.termination))}}}));
}

void RequireFitting(const TrainObjectClassOptions& options) {
  if (options.add_class.empty() == options.to.empty() && !(options.search && !options.to.empty())) {
    return;
  }
  throw Error({.kind = Error::Kind::kUsage,
               .reason = "--add-class NEW and --to MODEL belong together, without --search"});
}

ObjectClassTraining Train(const TrainObjectClassOptions& options,
                          const datasets::ViewSet& set,
                          const experiments::ObjectClassOptions& training) {
  if (options.to.empty()) {
    return options.search ? experiments::SearchObjectClasses(set, training)
                          : experiments::TrainObjectClasses(set, training);
  }
  const model_io::ObjectClassModel model =
      model_io::ReadObjectClassModel(model_io::Parse(ReadFile(options.to), options.to));
  return experiments::AddObjectClass(model, set, options.add_class, training);
}

void RunTrainObjectClass(const TrainObjectClassOptions& options, const Console& console) {
  RequireFitting(options);
  RequireWritable(options.Target());
  const datasets::ViewSet whole = datasets::ReadViewSet(options.data);
  RequireNotAnInput(options.Target(), FilesOf(whole));
  const datasets::ViewSet set = datasets::OnlySplit(whole, options.split);
  const std::string parent = options.to.empty() ? "" : Sha256Hex(ReadFile(options.to));
  ProgressBar bar(console);
  experiments::ObjectClassOptions training_options = options.training;
  training_options.svm.progress = bar.Callback();
  const ObjectClassTraining training = Train(options, set, training_options);
  bar.Clear();
  RequireUsable(training.summary);
  const std::string& target = options.Target();
  if (!target.empty()) WriteFileAtomically(target, ModelBytes(options, set, training, parent));
  if (options.json) {
    console.Print(ToJson(options, training));
    return;
  }
  console.out << ToText(training);
  if (!target.empty()) console.out << "\nModel written to " << target << '\n';
}

}  // namespace

void AddTrainObjectClass(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainObjectClassOptions>();
  CLI::App* command = parent.add_subcommand(
      "object-class", "Which object it is, from its point cloud: support vector machines");
  command->add_option("VIEWS", options->data, "View set: a folder with views.csv")->required();
  command->add_option("--split", options->split, "Split to train on; '' for all views")
      ->capture_default_str();
  command->add_option("--out", options->out, "Model file to write")->type_name("FILE");
  command->add_option("--name", options->name, "Name of the model, stored in it")
      ->capture_default_str();
  command
      ->add_option("--add-class",
                   options->add_class,
                   "Add this class of the views to a model, training its pairs alone")
      ->type_name("NEW");
  command
      ->add_option("--to", options->to, "… to this model, which is replaced unless --out is given")
      ->type_name("MODEL");
  command->add_flag(
      "--search", options->search, "Choose kernel, degree, gamma and C by cross-validation");
  AddObjectClassOptions(*command, options->training);
  AddSeedOption(*command, options->training.moved.seed);
  AddThreadsOption(*command, options->training.svm.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft train object-class out/turntable --out object_class.safetensors");
  command->callback([options, &console] { RunTrainObjectClass(*options, console); });
}

}  // namespace handcraft::tools
