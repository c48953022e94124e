// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/grasp_point_samples.h"
#include "experiments/evaluation/grasp_point_evaluation.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/features/feature_spec.h"
#include "lib/model_io/linear_models.h"
#include "lib/model_io/model_writer.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/held_out_figures.h"
#include "tools/labelled_pixels.h"
#include "tools/logistic_options.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"
#include "tools/training_outcome.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::tools {
namespace {

struct TrainGraspPointsOptions {
  LabelledPixelsOptions pixels;
  std::string out;
  std::string name = "grasp_points";
  std::string held_out = "test";
  bool held_out_is_given = false;
  logistic::Options logistic;
  bool json = false;
};

// Draws and threads are those of the pixels.
logistic::Options TrainerOptions(const TrainGraspPointsOptions& options) {
  logistic::Options logistic = options.logistic;
  logistic.seed = options.pixels.sampling.seed;
  logistic.num_threads = options.pixels.sampling.num_threads;
  return logistic;
}

// What training leaves behind, for the model file and for the screen.
struct Training {
  features::FeatureSpec spec;
  datasets::LabelledImageSet set;
  std::optional<datasets::LabelledImageSet> held_out;
  std::size_t num_images = 0;  // that gave samples
  logistic::Result result;
  std::optional<experiments::GraspPointEvaluation> evaluation;  // on held_out
};

std::vector<std::string> FeatureNames(const features::FeatureSpec& spec) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(spec.NumFeatures()));
  for (int i = 0; i < spec.NumFeatures(); ++i) names.push_back(features::FeatureName(spec, i));
  return names;
}

// The images to measure on, if there are any that training does not see. A split that was asked
// for must be there; the one by default need not.
std::optional<datasets::LabelledImageSet> HeldOutOf(const datasets::LabelledImageSet& set,
                                                    const TrainGraspPointsOptions& options) {
  const bool is_seen = options.pixels.split.empty() || options.pixels.split == options.held_out;
  if (options.held_out_is_given && !options.held_out.empty()) {
    if (is_seen) {
      throw Error(
          {.kind = Error::Kind::kUsage,
           .reason = fmt::format("--held-out {}: training sees these images", options.held_out),
           .remedy = "name another split than --split, or none: --held-out ''"});
    }
    return set.Only(options.held_out);
  }
  const bool is_there = std::any_of(set.items.begin(), set.items.end(), [&](const auto& item) {
    return item.split == options.held_out;
  });
  if (options.held_out.empty() || is_seen || !is_there) return std::nullopt;
  return set.Only(options.held_out);
}

Training Train(const TrainGraspPointsOptions& options, const Console& console) {
  const datasets::LabelledImageSet whole_set =
      datasets::ReadLabelledImageSet(options.pixels.dataset);
  RequireNotAnInput(options.out, FilesOf(whole_set));
  Training training;
  training.held_out = HeldOutOf(whole_set, options);
  LabelledPixels pixels = DrawLabelledPixels(options.pixels, whole_set, console);
  training.spec = pixels.spec;
  training.set = std::move(pixels.set);
  training.num_images = pixels.num_images;
  const datasets::GraspPointSamples& samples = pixels.samples;
  const logistic::DesignMatrix<float> matrix{.data = samples.features.data(),
                                             .num_samples = samples.num_samples(),
                                             .num_features = samples.num_features,
                                             .stride = samples.num_features};
  ProgressBar bar(console);
  logistic::Options logistic = TrainerOptions(options);
  logistic.progress = bar.Callback();
  training.result = logistic::TrainLogistic<float>(matrix, samples.labels, logistic);
  return training;
}

model_io::Provenance ProvenanceOf(const TrainGraspPointsOptions& options,
                                  const Training& training) {
  const logistic::Summary& summary = training.result.summary;
  model_io::Provenance provenance{
      .name = options.name,
      .task = "grasp_point",
      .licence = fmt::format("trained on pictures under: {}",
                             fmt::join(datasets::LicencesOf(training.set), "; ")),
      .intended_use = "ranks the pixels of a picture by how likely a gripper can close there",
      .limits = "sees local texture and edges alone: best on scenes like the training pictures",
      .algorithm = "logistic_irls",
      .data_fingerprint = datasets::Fingerprint(training.set),
      .class_counts = fmt::format(
          "0: {}, 1: {}", summary.num_samples - summary.num_positive, summary.num_positive)};
  provenance.hyper_parameters = FieldsToText(options.pixels.sampling, "sampling.");
  provenance.hyper_parameters.merge(FieldsToText(TrainerOptions(options), "irls."));
  provenance.hyper_parameters["split"] = options.pixels.split;
  provenance.metrics = {{"train.num_samples", NumberToText(summary.num_samples)},
                        {"train.num_images", NumberToText(training.num_images)},
                        {"train.deviance", NumberToText(summary.deviance)},
                        {"train.null_deviance", NumberToText(summary.null_deviance)},
                        {"train.gradient_norm", NumberToText(summary.gradient_norm)},
                        {"train.iterations", NumberToText(summary.iterations)},
                        {"train.termination", std::string(NameOf(summary.termination))}};
  if (training.evaluation)
    provenance.metrics.merge(MetadataOf(*training.evaluation, options.held_out));
  return provenance;
}

std::vector<std::uint8_t> ModelBytes(const TrainGraspPointsOptions& options,
                                     const Training& training) {
  const model_io::LinearModel model{.weights = training.result.weights,
                                    .intercept = training.result.intercept,
                                    .feature_mean = training.result.feature_mean,
                                    .feature_scale = training.result.feature_scale};
  return model_io::Serialise(
      model_io::MakeGraspPointModel(training.spec, model, ProvenanceOf(options, training)));
}

// Measures the model on the images held out. What is wrong with those must not cost the model.
void MeasureHeldOut(const TrainGraspPointsOptions& options,
                    const Console& console,
                    Training& training) {
  if (!training.held_out) return;
  ProgressBar bar(console);
  try {
    training.evaluation = EvaluateHeldOut(ModelBytes(options, training),
                                          *training.held_out,
                                          {.seed = options.pixels.sampling.seed,
                                           .num_threads = options.pixels.sampling.num_threads,
                                           .progress = bar.Callback()});
  } catch (const Error& error) {
    bar.Clear();
    console.Warn(fmt::format("no held-out figures: {}", error.what()));
  }
}

nlohmann::ordered_json HeldOutJson(const Training& training) {
  if (!training.evaluation) return nullptr;
  const experiments::GroupFigures& all = training.evaluation->all;
  return {{"num_images", all.num_images},
          {"auc", all.auc.value},
          {"auc_low", all.auc.low},
          {"auc_high", all.auc.high},
          {"accuracy", all.accuracy.value},
          {"log_loss", all.log_loss}};
}

// What cannot be formed is NaN, shown as a dash.
std::string Rounded(double value) { return std::isnan(value) ? "–" : fmt::format("{:.3f}", value); }

std::string HeldOutText(const experiments::GroupFigures& all, const std::string& split) {
  return fmt::format("AUC {} ({} to {}), accuracy {} on {} images ({})",
                     Rounded(all.auc.value),
                     Rounded(all.auc.low),
                     Rounded(all.auc.high),
                     Rounded(all.accuracy.value),
                     all.num_images,
                     split);
}

// Mean over samples of −ln(probability given to the right label).
double LogLossOf(const logistic::Summary& summary) {
  return summary.deviance / (2.0 * static_cast<double>(summary.num_samples));
}

void PrintJson(const Console& console,
               const TrainGraspPointsOptions& options,
               const Training& training,
               const std::string& sha256) {
  const logistic::Summary& summary = training.result.summary;
  console.Print({{"model", options.out},
                 {"sha256", sha256},
                 {"features", features::ToString(training.spec)},
                 {"num_features", training.spec.NumFeatures()},
                 {"num_images", training.num_images},
                 {"num_samples", summary.num_samples},
                 {"num_good", summary.num_positive},
                 {"log_loss", LogLossOf(summary)},
                 {"deviance", summary.deviance},
                 {"null_deviance", summary.null_deviance},
                 {"gradient_norm", summary.gradient_norm},
                 {"iterations", summary.iterations},
                 {"termination", NameOf(summary.termination)},
                 {"message", summary.message},
                 {"held_out", HeldOutJson(training)}});
}

void PrintText(const Console& console,
               const TrainGraspPointsOptions& options,
               const Training& training,
               const std::string& sha256) {
  const logistic::Summary& summary = training.result.summary;
  TextTable table;
  table.AddRow({"images",
                fmt::format("{} of {} ({})",
                            training.num_images,
                            training.set.items.size(),
                            options.pixels.split.empty() ? "all" : options.pixels.split)});
  table.AddRow({"samples",
                fmt::format("{} ({} good, {} bad)",
                            summary.num_samples,
                            summary.num_positive,
                            summary.num_samples - summary.num_positive)});
  table.AddRow(
      {"features", fmt::format("{} ({})", training.spec.NumFeatures(), options.pixels.features)});
  table.AddRow({"log-loss",
                fmt::format("{:.6f} (without features {:.6f})",
                            LogLossOf(summary),
                            LogLossOf(summary) * summary.null_deviance / summary.deviance)});
  table.AddRow(
      {"training",
       fmt::format("{}, gradient {:.1e} a sample", summary.message, summary.gradient_norm)});
  if (training.evaluation) {
    table.AddRow({"held out", HeldOutText(training.evaluation->all, options.held_out)});
  }
  table.AddRow({"model", options.out});
  table.AddRow({"sha256", sha256});
  console.out << table.ToText();
}

void RunTrainGraspPoints(const TrainGraspPointsOptions& options, const Console& console) {
  RequireWritable(options.out);
  Training training = Train(options, console);
  RequireUsable(training.result.summary, FeatureNames(training.spec), console);
  MeasureHeldOut(options, console, training);
  const std::vector<std::uint8_t> bytes = ModelBytes(options, training);
  WriteFileAtomically(options.out, bytes);
  if (options.json) {
    PrintJson(console, options, training, Sha256Hex(bytes));
  } else {
    PrintText(console, options, training, Sha256Hex(bytes));
  }
}

}  // namespace

void AddTrainGraspPoints(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainGraspPointsOptions>();
  CLI::App* command = parent.add_subcommand(
      "grasp-points", "Learn which pixels can be grasped from a labelled image set");
  AddLabelledPixelsOptions(*command, options->pixels);
  command->add_option("--out", options->out, "Model file to write")->type_name("FILE")->required();
  CLI::Option* held_out =
      command
          ->add_option("--held-out",
                       options->held_out,
                       "Split to measure the model on, kept in the file; '' for none")
          ->capture_default_str();
  command->add_option("--name", options->name, "Name of the model, stored in it")
      ->capture_default_str();
  AddJsonFlag(*command, options->json);
  AddLogisticOptions(*command, options->logistic);
  SetExample(*command,
             "handcraft train grasp-points datasets/samples/cornell_mini "
             "--out grasp_points.safetensors");
  command->callback([options, command, held_out, &console] {
    options->held_out_is_given = held_out->count() > 0;
    RefuseUnreadOptions(*command, options->pixels);
    RunTrainGraspPoints(*options, console);
  });
}

}  // namespace handcraft::tools
