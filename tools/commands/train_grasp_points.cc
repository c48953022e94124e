// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
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
#include "tools/logistic_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"
#include "tools/training_outcome.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::tools {
namespace {

struct TrainGraspPointsOptions {
  std::string dataset;
  std::string out;
  std::string name = "grasp_points";
  std::string features = "all500,energy=log";
  std::string split = "train";
  std::string held_out = "test";
  bool held_out_is_given = false;
  datasets::SamplingOptions sampling;
  logistic::Options logistic;
  std::uint64_t seed = 1;
  int num_threads = 1;
  bool json = false;
};

// What training leaves behind, for the model file and for the screen.
struct Training {
  features::FeatureSpec spec;
  datasets::LabelledImageSet set;
  std::optional<datasets::LabelledImageSet> held_out;
  std::size_t num_images = 0;  // that gave samples
  std::vector<std::string> left_out;
  logistic::Result result;
  std::optional<experiments::GraspPointEvaluation> evaluation;  // on held_out
};

std::vector<std::string> FeatureNames(const features::FeatureSpec& spec) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(spec.NumFeatures()));
  for (int i = 0; i < spec.NumFeatures(); ++i) names.push_back(features::FeatureName(spec, i));
  return names;
}

std::size_t NumImages(const std::vector<datasets::PixelSample>& pixels) {
  std::set<std::uint32_t> images;
  for (const datasets::PixelSample& pixel : pixels) images.insert(pixel.image);
  return images.size();
}

// The images to measure on, if there are any that training does not see. A split that was asked
// for must be there; the one by default need not.
std::optional<datasets::LabelledImageSet> HeldOutOf(const datasets::LabelledImageSet& set,
                                                    const TrainGraspPointsOptions& options) {
  const bool is_seen = options.split.empty() || options.split == options.held_out;
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
  const datasets::LabelledImageSet whole_set = datasets::ReadLabelledImageSet(options.dataset);
  RequireNotAnInput(options.out, FilesOf(whole_set));
  Training training{.spec = features::ParseFeatureSpec(options.features),
                    .set = whole_set.Only(options.split),
                    .held_out = HeldOutOf(whole_set, options),
                    .num_images = 0,
                    .left_out = {},
                    .result = {},
                    .evaluation = {}};
  ProgressBar bar(console);
  datasets::SamplingOptions sampling = options.sampling;
  logistic::Options logistic = options.logistic;
  sampling.seed = logistic.seed = options.seed;
  sampling.num_threads = logistic.num_threads = options.num_threads;
  sampling.progress = logistic.progress = bar.Callback();
  sampling.left_out = [&](const std::string& image, std::string_view reason) {
    training.left_out.push_back(fmt::format("left out: {}, {}", image, reason));
  };
  const std::vector<datasets::PixelSample> pixels = datasets::DrawSamples(training.set, sampling);
  training.num_images = NumImages(pixels);
  const datasets::GraspPointSamples samples =
      datasets::ComputeSampleFeatures(training.set, pixels, training.spec, sampling);
  const logistic::DesignMatrix<float> matrix{.data = samples.features.data(),
                                             .num_samples = samples.num_samples(),
                                             .num_features = samples.num_features,
                                             .stride = samples.num_features};
  training.result = logistic::TrainLogistic<float>(matrix, samples.labels, logistic);
  return training;
}

model_io::Provenance ProvenanceOf(const TrainGraspPointsOptions& options,
                                  const Training& training) {
  const logistic::Summary& summary = training.result.summary;
  datasets::SamplingOptions sampling = options.sampling;
  logistic::Options logistic = options.logistic;
  sampling.seed = logistic.seed = options.seed;
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
  provenance.hyper_parameters = FieldsToText(sampling, "sampling.");
  provenance.hyper_parameters.merge(FieldsToText(logistic, "irls."));
  provenance.hyper_parameters["split"] = options.split;
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
    training.evaluation = EvaluateHeldOut(
        ModelBytes(options, training),
        *training.held_out,
        {.seed = options.seed, .num_threads = options.num_threads, .progress = bar.Callback()});
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
                            options.split.empty() ? "all" : options.split)});
  table.AddRow({"samples",
                fmt::format("{} ({} good, {} bad)",
                            summary.num_samples,
                            summary.num_positive,
                            summary.num_samples - summary.num_positive)});
  table.AddRow({"features", fmt::format("{} ({})", training.spec.NumFeatures(), options.features)});
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

// The images may not have as many good pixels as were asked for; rounding is not worth a word.
void WarnOfFewSamples(const datasets::SamplingOptions& sampling,
                      const logistic::Summary& summary,
                      const Console& console) {
  if (summary.num_samples >= sampling.num_samples / 100 * 99) return;
  console.Warn(fmt::format(
      "{} samples were asked for; the images give {}", sampling.num_samples, summary.num_samples));
}

void RunTrainGraspPoints(const TrainGraspPointsOptions& options, const Console& console) {
  RequireWritable(options.out);
  Training training = Train(options, console);
  for (const std::string& warning : training.left_out) console.Warn(warning);
  RequireUsable(training.result.summary, FeatureNames(training.spec), console);
  WarnOfFewSamples(options.sampling, training.result.summary, console);
  MeasureHeldOut(options, console, training);
  const std::vector<std::uint8_t> bytes = ModelBytes(options, training);
  WriteFileAtomically(options.out, bytes);
  if (options.json) {
    PrintJson(console, options, training, Sha256Hex(bytes));
  } else {
    PrintText(console, options, training, Sha256Hex(bytes));
  }
}

void AddSamplingOptions(CLI::App& command, datasets::SamplingOptions& sampling) {
  const std::string group = "Sampling";
  AddNumber(command,
            "--samples",
            sampling,
            &datasets::SamplingOptions::num_samples,
            "Pixels to draw in all; 0: every one")
      ->group(group);
  AddNumber(command,
            "--bad-per-good",
            sampling,
            &datasets::SamplingOptions::bad_per_good,
            "Bad pixels for each good one")
      ->group(group);
  AddNumber(command,
            "--image-share",
            sampling,
            &datasets::SamplingOptions::image_share,
            "Share of the images to use, (0, 1]")
      ->group(group);
  CLI::Option* share = AddNumber(command,
                                 "--hard-negatives",
                                 sampling,
                                 &datasets::SamplingOptions::hard_negative_share,
                                 "Share of the bad pixels to draw near good ones, [0, 1]");
  share->group(group);
  AddNumber(command,
            "--hard-negative-radius",
            sampling,
            &datasets::SamplingOptions::hard_negative_radius_px,
            "… no farther than this from a good one [px]")
      ->needs(share)
      ->group(group);
}

// Options that nothing reads when every pixel is taken.
void RefuseRatios(const CLI::App& command) {
  for (const char* name : {"--bad-per-good", "--hard-negatives"}) {
    if (command.count(name) == 0) continue;
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = std::string(name) + " says which pixels to draw: --samples 0 takes all"});
  }
}

}  // namespace

void AddTrainGraspPoints(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainGraspPointsOptions>();
  CLI::App* command = parent.add_subcommand(
      "grasp-points", "Learn which pixels can be grasped from a labelled image set");
  command->add_option("DATASET", options->dataset, "Folder with manifest.csv")->required();
  command->add_option("--out", options->out, "Model file to write")->type_name("FILE")->required();
  command
      ->add_option("--features",
                   options->features,
                   "all500, edges150, window180, edges54 or saxena459, then changes such as "
                   "energy=square|abs|log, window=3, filters=edges+laplacian")
      ->type_name("SPEC")
      ->capture_default_str();
  command->add_option("--split", options->split, "Split to train on; '' for all images")
      ->capture_default_str();
  CLI::Option* held_out =
      command
          ->add_option("--held-out",
                       options->held_out,
                       "Split to measure the model on, kept in the file; '' for none")
          ->capture_default_str();
  command->add_option("--name", options->name, "Name of the model, stored in it")
      ->capture_default_str();
  AddSeedOption(*command, options->seed);
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  AddSamplingOptions(*command, options->sampling);
  AddLogisticOptions(*command, options->logistic);
  SetExample(*command,
             "handcraft train grasp-points datasets/samples/cornell_mini "
             "--out grasp_points.safetensors");
  command->callback([options, command, held_out, &console] {
    options->held_out_is_given = held_out->count() > 0;
    if (options->sampling.num_samples == 0) RefuseRatios(*command);
    RunTrainGraspPoints(*options, console);
  });
}

}  // namespace handcraft::tools
