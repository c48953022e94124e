// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/object_clouds.h"
#include "datasets/view_folds.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/metrics/binary_metrics.h"
#include "experiments/object_classes/novel_views.h"
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
#include "tools/svm_growth.h"
#include "tools/svm_options.h"
#include "tools/svm_rejection.h"
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
  SvmGrowth growth;
  NovelOptions novel;
  std::string novel_split;
  bool search = false;
  bool is_folds_given = false;
  bool json = false;
  experiments::ObjectClassOptions training;

  // Where the model goes: an old one is replaced unless it shall stay.
  [[nodiscard]] const std::string& Target() const { return out.empty() ? growth.model : out; }
};

struct TrainedObjectClass {
  ObjectClassTraining training = {};
  std::optional<svm::Calibration> rejection = {};
  std::optional<double> dropped_threshold = {};  // of the model a class was added to
  std::string parent = {};                       // its SHA-256
  std::string novel_fingerprint = {};            // of the novel views
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

Json ToJson(const TrainObjectClassOptions& options, const TrainedObjectClass& trained) {
  const ObjectClassTraining& training = trained.training;
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
  if (trained.rejection) AddJson(*trained.rejection, json);
  if (trained.dropped_threshold) json["dropped_threshold"] = *trained.dropped_threshold;
  json["model"] = options.Target();
  return json;
}

std::string ToText(const TrainedObjectClass& trained) {
  const ObjectClassTraining& training = trained.training;
  const std::vector<std::size_t> rows = CountRows(training);
  const std::vector<std::size_t> support_vectors = CountSupportVectors(training);
  // Classes that were there and have no views are told from by their support vectors.
  TextTable classes({"class",
                     trained.parent.empty() ? "views and copies" : "views, copies or vectors",
                     "support vectors"});
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
  if (trained.rejection) text += tools::ToText(*trained.rejection, "views");
  return text;
}

std::vector<std::uint8_t> ModelBytes(const TrainObjectClassOptions& options,
                                     const datasets::ViewSet& set,
                                     const TrainedObjectClass& trained) {
  const ObjectClassTraining& training = trained.training;
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
  model_io::Provenance provenance{
      .name = options.name,
      .task = "object-class",
      .intended_use = "class of an object that stands on a table, from its point cloud",
      .algorithm = "svm",
      .data_fingerprint = datasets::Fingerprint(set),
      .class_counts = class_counts,
      .parent = trained.parent,
      .hyper_parameters = FieldsToText(used, "object_class."),
      .metrics = {{"train.num_samples", NumberToText(training.summary.num_samples)},
                  {"train.num_support_vectors", NumberToText(training.summary.num_support_vectors)},
                  {"train.iterations", NumberToText(training.summary.iterations)},
                  {"train.termination", std::string(NameOf(training.summary.termination))}}};
  if (trained.rejection) {
    AddMetrics(*trained.rejection, provenance.metrics);
    provenance.hyper_parameters["object_class.novel_fingerprint"] = trained.novel_fingerprint;
  }
  return model_io::Serialise(
      model_io::MakeObjectClassModel(training.model, object.View(), provenance));
}

// Only what a robot would load.
model_io::ObjectClassModel ReadOldModel(const std::string& path) {
  static_cast<void>(experiments::LoadModel(path));
  return model_io::ReadObjectClassModel(model_io::Parse(ReadFile(path), path));
}

// Those that the model is to tell.
std::vector<std::string> ClassesToTell(const TrainObjectClassOptions& options,
                                       const datasets::ViewSet& set) {
  if (options.growth.new_class.empty()) return datasets::ClassesOf(set).names;
  std::vector<std::string> classes = ReadOldModel(options.growth.model).classes;
  classes.push_back(options.growth.new_class);
  return classes;
}

// More folds than views would leave some empty.
void RequireFoldsFit(const TrainObjectClassOptions& options, const datasets::ViewSet& set) {
  if (!options.is_folds_given) return;
  std::map<std::string, int> counts;
  for (const datasets::ObjectView& view : set.items) ++counts[view.object_class];
  const auto fewest =
      std::min_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      });
  if (options.training.num_folds <= std::max(2, fewest->second)) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = fmt::format("--folds: {} given; it must be at most {}, the views of the "
                                     "smallest class, '{}'",
                                     options.training.num_folds,
                                     std::max(2, fewest->second),
                                     fewest->first),
               .remedy = "-1 holds each view out alone"});
}

// Read and compared before the long work.
std::optional<datasets::ViewSet> ReadNovelViews(const TrainObjectClassOptions& options,
                                                const datasets::ViewSet& known,
                                                const std::vector<std::string>& classes) {
  if (options.novel.path.empty()) return std::nullopt;
  if (options.training.num_folds == 0) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "--novel needs --folds: novel views are told from held-out known ones",
                 .remedy = "leave out --folds 0"});
  }
  const datasets::ViewSet whole = datasets::ReadViewSet(options.novel.path);
  RequireNotAnInput(options.Target(), FilesOf(whole));
  datasets::ViewSet novel = datasets::OnlySplit(whole, options.novel_split);
  experiments::RequireNovel(novel, known, classes);
  return novel;
}

void AddNewClass(const TrainObjectClassOptions& options,
                 const datasets::ViewSet& set,
                 experiments::ObjectClassOptions training,
                 TrainedObjectClass& trained) {
  const model_io::ObjectClassModel model = ReadOldModel(options.growth.model);
  trained.parent = Sha256Hex(ReadFile(options.growth.model));
  // Views are held out for the threshold alone: the point is to train few machines.
  if (options.novel.path.empty()) training.num_folds = 0;
  trained.training = experiments::AddObjectClass(model, set, options.growth.new_class, training);
  if (options.novel.path.empty()) trained.dropped_threshold = model.svm.rejection_threshold;
}

TrainedObjectClass Train(const TrainObjectClassOptions& options,
                         const datasets::ViewSet& set,
                         const experiments::ObjectClassOptions& training) {
  const std::optional<datasets::ViewSet> novel =
      ReadNovelViews(options, set, ClassesToTell(options, set));
  TrainedObjectClass trained;
  if (!options.growth.new_class.empty()) {
    AddNewClass(options, set, training, trained);
  } else {
    trained.training = options.search ? experiments::SearchObjectClasses(set, training)
                                      : experiments::TrainObjectClasses(set, training);
  }
  RequireUsable(trained.training.summary);
  if (novel) {
    trained.rejection = experiments::RejectNovelViews(
        *novel, options.novel.max_lost, training.svm.num_threads, trained.training);
    trained.novel_fingerprint = datasets::Fingerprint(*novel);
  }
  return trained;
}

void RunTrainObjectClass(const TrainObjectClassOptions& options, const Console& console) {
  RequireWritable(options.Target());
  const datasets::ViewSet whole = datasets::ReadViewSet(options.data);
  RequireNotAnInput(options.Target(), FilesOf(whole));
  const datasets::ViewSet set = datasets::OnlySplit(whole, options.split);
  RequireFoldsFit(options, set);
  ProgressBar bar(console);
  experiments::ObjectClassOptions training = options.training;
  training.svm.progress = bar.Callback();
  const TrainedObjectClass trained = Train(options, set, training);
  bar.Clear();
  if (trained.dropped_threshold) console.Warn(DroppedThresholdText(*trained.dropped_threshold));
  const std::string& target = options.Target();
  if (!target.empty()) WriteFileAtomically(target, ModelBytes(options, set, trained));
  if (options.json) {
    console.Print(ToJson(options, trained));
    return;
  }
  console.out << ToText(trained);
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
  command->add_flag(
      "--search", options->search, "Choose kernel, degree, gamma and C by cross-validation");
  AddObjectClassOptions(*command, options->training);
  AddNovelOptions(*command, "DIR", "views", options->novel);
  command->add_option("--novel-split", options->novel_split, "Split of --novel; all without it")
      ->needs("--novel")
      ->group(kSvmGroup);
  AddSvmGrowthOptions(
      *command, "Model to add the class to: replaced unless --out is given", options->growth);
  AddSeedOption(*command, options->training.moved.seed);
  AddThreadsOption(*command, options->training.svm.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft train object-class out/turntable --out object_class.safetensors");
  command->callback([options, command, &console] {
    options->is_folds_given = command->count("--folds") > 0;
    RunTrainObjectClass(*options, console);
  });
}

}  // namespace handcraft::tools
