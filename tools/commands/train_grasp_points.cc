// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
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
#include "experiments/evaluation/html_text.h"
#include "experiments/metrics/confusion_percent.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/features/feature_spec.h"
#include "lib/model_io/linear_models.h"
#include "lib/model_io/model_writer.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/feature_names.h"
#include "tools/held_out_figures.h"
#include "tools/labelled_pixels.h"
#include "tools/pixel_fit.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct TrainGraspPointsOptions {
  LabelledPixelsOptions pixels;
  std::string out;
  std::string name = "grasp_points";
  std::string held_out = "test";
  bool held_out_is_given = false;
  PixelFitOptions fit;
  bool json = false;
};

// What training leaves behind, for the model file and for the screen.
struct Training {
  features::FeatureSpec spec;
  datasets::LabelledImageSet set;
  std::optional<datasets::LabelledImageSet> held_out;
  std::size_t num_images = 0;  // that gave samples
  PixelFit fit;
  std::optional<experiments::GraspPointEvaluation> evaluation;  // on held_out
};

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
  training.fit = FitPixels(
      pixels.samples, FeatureNames(training.spec), options.fit, options.pixels.sampling, console);
  return training;
}

model_io::Provenance ProvenanceOf(const TrainGraspPointsOptions& options,
                                  const Training& training) {
  const PixelFit& fit = training.fit;
  model_io::Provenance provenance{
      .name = options.name,
      .task = "grasp_point",
      .licence = fmt::format("trained on pictures under: {}",
                             fmt::join(datasets::LicencesOf(training.set), "; ")),
      .intended_use = "ranks the pixels of a picture by how likely a gripper can close there",
      .limits = "sees local texture and edges alone: best on scenes like the training pictures",
      .algorithm = fit.algorithm,
      .data_fingerprint = datasets::Fingerprint(training.set),
      .class_counts =
          fmt::format("0: {}, 1: {}", fit.num_samples - fit.num_positive, fit.num_positive)};
  provenance.hyper_parameters = FieldsToText(options.pixels.sampling, "sampling.");
  provenance.hyper_parameters.insert(fit.hyper_parameters.begin(), fit.hyper_parameters.end());
  provenance.hyper_parameters["split"] = options.pixels.split;
  provenance.metrics = fit.metrics;
  provenance.metrics["train.num_images"] = NumberToText(training.num_images);
  if (training.evaluation)
    provenance.metrics.merge(MetadataOf(*training.evaluation, options.held_out));
  return provenance;
}

std::vector<std::uint8_t> ModelBytes(const TrainGraspPointsOptions& options,
                                     const Training& training) {
  return model_io::Serialise(model_io::MakeGraspPointModel(
      training.spec, training.fit.model, ProvenanceOf(options, training)));
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

// Of the pixels that the dissertation tested linear discriminant analysis on.
const double kDissertationBadShare = experiments::BadShareOf(experiments::kDissertationLda);

nlohmann::ordered_json HeldOutJson(const Training& training) {
  if (!training.evaluation) return nullptr;
  const experiments::GroupFigures& all = training.evaluation->all;
  return {{"num_images", all.num_images},
          {"auc", all.auc.value},
          {"auc_low", all.auc.low},
          {"auc_high", all.auc.high},
          {"accuracy", all.accuracy.value},
          {"log_loss", all.log_loss.value},
          {"confusion_percent",
           ValuesOf(PercentAtBadShare(all.rates, experiments::BadShareOf(all.confusion)))},
          {"confusion_percent_at_dissertation_ratio",
           ValuesOf(PercentAtBadShare(all.rates, kDissertationBadShare))}};
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
double LogLossOf(double deviance, const PixelFit& fit) {
  return deviance / (2.0 * static_cast<double>(fit.num_samples));
}

// The confusion matrix of section 3.1.4 beside ours: as measured, and at its class ratio.
std::string ConfusionText(const experiments::GroupFigures& all) {
  const auto ours = PercentAtBadShare(all.rates, experiments::BadShareOf(all.confusion));
  const auto weighted = PercentAtBadShare(all.rates, kDissertationBadShare);
  TextTable table({"percent of held-out pixels", "ours", "at its class ratio", "dissertation"});
  const std::array names = {std::array{"bad, called bad", "bad, called good"},
                            std::array{"good, called bad", "good, called good"}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      table.AddRow({names[i][j],
                    experiments::DecimalEstimateText(ours[i][j], 2),
                    experiments::DecimalEstimateText(weighted[i][j], 2),
                    fmt::format("{:.2f}", experiments::kDissertationLda[i][j])});
    }
  }
  return table.ToText();
}

void PrintJson(const Console& console,
               const TrainGraspPointsOptions& options,
               const Training& training,
               const std::string& sha256) {
  const PixelFit& fit = training.fit;
  nlohmann::ordered_json json{{"model", options.out},
                              {"sha256", sha256},
                              {"features", features::ToString(training.spec)},
                              {"num_features", training.spec.NumFeatures()},
                              {"num_images", training.num_images},
                              {"num_samples", fit.num_samples},
                              {"num_good", fit.num_positive},
                              {"algorithm", fit.algorithm},
                              {"log_loss", LogLossOf(fit.deviance, fit)},
                              {"deviance", fit.deviance},
                              {"null_deviance", fit.null_deviance}};
  json.update(fit.json);
  json["held_out"] = HeldOutJson(training);
  console.Print(json);
}

void PrintText(const Console& console,
               const TrainGraspPointsOptions& options,
               const Training& training,
               const std::string& sha256) {
  const PixelFit& fit = training.fit;
  TextTable table;
  table.AddRow({"images",
                fmt::format("{} of {} ({})",
                            training.num_images,
                            training.set.items.size(),
                            options.pixels.split.empty() ? "all" : options.pixels.split)});
  table.AddRow({"samples",
                fmt::format("{} ({} good, {} bad)",
                            fit.num_samples,
                            fit.num_positive,
                            fit.num_samples - fit.num_positive)});
  table.AddRow(
      {"features", fmt::format("{} ({})", training.spec.NumFeatures(), options.pixels.features)});
  table.AddRow({"log-loss",
                fmt::format("{:.6f} (without features {:.6f})",
                            LogLossOf(fit.deviance, fit),
                            LogLossOf(fit.null_deviance, fit))});
  table.AddRow({"training", fit.message});
  if (training.evaluation) {
    table.AddRow({"held out", HeldOutText(training.evaluation->all, options.held_out)});
  }
  table.AddRow({"model", options.out});
  table.AddRow({"sha256", sha256});
  console.out << table.ToText();
  if (training.evaluation && options.fit.method == FitMethod::kLda) {
    console.out << '\n' << ConfusionText(training.evaluation->all);
  }
}

void RunTrainGraspPoints(const TrainGraspPointsOptions& options, const Console& console) {
  RequireWritable(options.out);
  Training training = Train(options, console);
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
  AddPixelFitOptions(*command, options->fit);
  SetExample(*command,
             "handcraft train grasp-points datasets/samples/cornell_mini "
             "--out grasp_points.safetensors");
  command->callback([options, command, held_out, &console] {
    options->held_out_is_given = held_out->count() > 0;
    RefuseUnreadOptions(*command, options->pixels);
    RefuseOptionsOfOtherMethods(*command, options->fit);
    RunTrainGraspPoints(*options, console);
  });
}

}  // namespace handcraft::tools
