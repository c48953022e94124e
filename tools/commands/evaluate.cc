// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/evaluation/class_evaluation.h"
#include "experiments/evaluation/cloud_evaluation.h"
#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/evaluation/table_evaluation.h"
#include "experiments/evaluation/table_model.h"
#include "lib/core/counted.h"
#include "lib/core/error.h"
#include "lib/core/path_kind.h"
#include "lib/core/utf8.h"
#include "tools/cloud_commands.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct EvaluateOptions {
  std::string model;
  std::string data;
  std::string split = "test";
  std::string json;
  std::string html;
  std::vector<std::string> picture_options;  // given, and read by grasp-point models alone
  std::vector<std::string> counts_as;        // read by models of object classes alone
  bool is_split_given = false;
  experiments::EvaluationOptions evaluation;
};

// What cannot be formed is NaN, shown as a dash.
std::string Percent(double share) {
  return std::isnan(share) ? "–" : fmt::format("{:.2f} %", 100.0 * share);
}

std::string IntervalText(const experiments::Estimate& estimate) {
  if (std::isnan(estimate.low) || std::isnan(estimate.high)) return "–";
  return fmt::format("{} to {}", Percent(estimate.low), Percent(estimate.high));
}

// `what` is counted ("rows"). Says why figures are missing when one class has no sample.
void WarnOfOneClass(const experiments::ConfusionMatrix& matrix,
                    const std::string& what,
                    const std::string& negative,
                    const std::string& positive,
                    const Console& console) {
  if (matrix.NumGood() > 0 && matrix.NumBad() > 0) return;
  console.Warn(
      fmt::format("all {} {} are labelled '{}': figures that need '{}' as well, as the area under "
                  "the ROC curve, are left out",
                  matrix.Total(),
                  what,
                  matrix.NumGood() > 0 ? positive : negative,
                  matrix.NumGood() > 0 ? negative : positive));
}

void AddEstimateRow(const std::string& name,
                    const experiments::Estimate& estimate,
                    TextTable& table) {
  table.AddRow({name, Percent(estimate.value), IntervalText(estimate)});
}

void AddNumberRow(const std::string& name,
                  const experiments::Estimate& estimate,
                  TextTable& table) {
  table.AddRow({name,
                fmt::format("{:.4f}", estimate.value),
                std::isnan(estimate.low)
                    ? "–"
                    : fmt::format("{:.4f} to {:.4f}", estimate.low, estimate.high)});
}

// Rows: the truth; columns: what the model says at the threshold.
std::string ConfusionText(const experiments::ConfusionMatrix& matrix,
                          const std::string& negative,
                          const std::string& positive) {
  TextTable table({"", "predicted " + positive, "predicted " + negative});
  table.AddRow(
      {positive, std::to_string(matrix.true_positive), std::to_string(matrix.false_negative)});
  table.AddRow(
      {negative, std::to_string(matrix.false_positive), std::to_string(matrix.true_negative)});
  return table.ToText();
}

std::string ClassesText(const std::vector<experiments::GroupFigures>& classes) {
  TextTable table({"class", "images", "accuracy", "AUC", "best pixels good", "of"});
  for (const experiments::GroupFigures& group : classes) {
    table.AddRow({group.name,
                  std::to_string(group.num_images),
                  Percent(group.accuracy.value),
                  Percent(group.auc.value),
                  std::to_string(group.best_good),
                  std::to_string(group.best_total)});
  }
  return table.ToText();
}

// What calling pixels good above a threshold comes to.
void AddCallRows(double threshold,
                 const experiments::Estimate& accuracy,
                 const experiments::ConfusionRates& rates,
                 TextTable& table) {
  AddEstimateRow(fmt::format("accuracy at {}", threshold), accuracy, table);
  AddEstimateRow(
      fmt::format("good pixels called good at {}", threshold), rates.true_positive_rate, table);
  AddEstimateRow(
      fmt::format("bad pixels called bad at {}", threshold), rates.true_negative_rate, table);
}

void PrintGraspPoints(const Console& console,
                      const EvaluateOptions& options,
                      const experiments::GraspPointEvaluation& evaluation) {
  const experiments::GroupFigures& all = evaluation.all;
  console.out << fmt::format("{} on {} ({}), scored by the runtime\n\n",
                             OnOneLine(options.model),
                             Counted(all.num_images, "image"),
                             options.split.empty() ? "all" : "split " + options.split)
              << ConfusionText(all.confusion, "bad", "good") << '\n';
  TextTable table({"measure", "value", "95 % interval over images"});
  AddCallRows(options.evaluation.threshold, all.accuracy, all.rates, table);
  AddEstimateRow("area under the ROC curve", all.auc, table);
  AddEstimateRow(fmt::format("up to {} best pixels above {} that are good",
                             options.evaluation.best_pixels,
                             options.evaluation.best_min_probability),
                 all.best_pixel_accuracy,
                 table);
  AddCallRows(
      options.evaluation.best_min_probability, all.strict_accuracy, all.strict_rates, table);
  AddEstimateRow("average precision", all.average_precision, table);
  AddNumberRow("log-loss", all.log_loss, table);
  AddNumberRow("Brier score", all.brier, table);
  console.out << table.ToText()
              << fmt::format(
                     "\nBest pixels: {} good of {} on good or bad ground, {} on don't-care "
                     "ground; {} none\n",
                     all.best_good,
                     all.best_total,
                     all.best_dont_care,
                     Counted(all.num_images_without_best, "image has", "images have"));
  if (evaluation.classes.size() > 1) console.out << '\n' << ClassesText(evaluation.classes);
}

void RequireNotInputs(const EvaluateOptions& options,
                      const std::vector<std::filesystem::path>& inputs) {
  RequireNotAnInput(options.json, inputs);
  RequireNotAnInput(options.html, inputs);
}

void EvaluateGraspPoints(const hc_model* model,
                         const EvaluateOptions& options,
                         const Console& console) {
  if (KindOf(options.data) == PathKind::kFile) {
    throw Error({.path = options.data,
                 .reason = "a grasp-point model is evaluated on a labelled image set; this is a "
                           "file",
                 .remedy = "give the folder with manifest.csv"});
  }
  const datasets::LabelledImageSet whole_set = datasets::ReadLabelledImageSet(options.data);
  RequireNotInputs(options, FilesOf(whole_set));
  const datasets::LabelledImageSet set = whole_set.Only(options.split);
  ProgressBar bar(console);
  experiments::EvaluationOptions evaluation_options = options.evaluation;
  evaluation_options.progress = bar.Callback();
  const experiments::GraspPointEvaluation evaluation =
      experiments::EvaluateGraspPoints(model, set, evaluation_options);
  bar.Clear();
  WarnOfOneClass(evaluation.all.confusion, "pixels measured", "bad", "good", console);
  if (!options.html.empty()) {
    experiments::WriteHtmlReport(options.html, evaluation, set, model);
  }
  WriteJson(console, options.json, experiments::ToJson(evaluation, set));
  if (options.json != "-") PrintGraspPoints(console, options, evaluation);
}

void PrintTable(const Console& console,
                const EvaluateOptions& options,
                const experiments::TableEvaluation& evaluation) {
  console.out << fmt::format("{} on {} of {}\n\n",
                             OnOneLine(options.model),
                             Counted(evaluation.num_rows, "row"),
                             OnOneLine(options.data))
              << ConfusionText(
                     evaluation.confusion, evaluation.negative_label, evaluation.positive_label)
              << '\n';
  TextTable table({"measure", "value", "95 % interval"});
  AddEstimateRow(
      fmt::format("accuracy at {}", evaluation.options.threshold), evaluation.accuracy, table);
  AddEstimateRow("area under the ROC curve", evaluation.auc, table);
  table.AddRow({"log-loss", fmt::format("{:.4f}", evaluation.log_loss), ""});
  table.AddRow({"Brier score", fmt::format("{:.4f}", evaluation.brier), ""});
  console.out << table.ToText();
}

void EvaluateTable(const hc_model* model, const EvaluateOptions& options, const Console& console) {
  RefusePictureOptions(options.picture_options);
  const experiments::TableModel table_model = experiments::ReadTableModel(options.model);
  const datasets::Table table = experiments::ReadTableFor(table_model, options.data);
  experiments::RequireLabelsOf(table_model, table, options.data);
  const experiments::TableEvaluation evaluation =
      experiments::EvaluateTable(model,
                                 table,
                                 options.data,
                                 {.threshold = options.evaluation.threshold,
                                  .bootstrap_resamples = options.evaluation.bootstrap_resamples,
                                  .seed = options.evaluation.seed,
                                  .num_threads = options.evaluation.num_threads});
  WarnOfOneClass(
      evaluation.confusion, "rows", evaluation.negative_label, evaluation.positive_label, console);
  WriteJson(console, options.json, experiments::ToJson(evaluation));
  if (options.json != "-") PrintTable(console, options, evaluation);
}

void PrintClasses(const Console& console,
                  const EvaluateOptions& options,
                  const experiments::ClassEvaluation& evaluation) {
  console.out << fmt::format("{} on {} of {}\n\n",
                             OnOneLine(options.model),
                             Counted(evaluation.num_rows, "row"),
                             OnOneLine(options.data));
  std::vector<std::string> header = {""};
  for (const std::string& name : evaluation.classes) header.push_back("predicted " + name);
  if (evaluation.num_rejected > 0) header.emplace_back(experiments::kNoneOfThese);
  TextTable confusion(header);
  for (std::size_t c = 0; c < evaluation.classes.size(); ++c) {
    std::vector<std::string> row = {evaluation.classes[c]};
    for (std::size_t k = 0; k + 1 < header.size(); ++k) {
      row.push_back(std::to_string(evaluation.confusion[c][k]));
    }
    confusion.AddRow(row);
  }
  TextTable table({"measure", "value", "95 % interval"});
  AddEstimateRow("accuracy", evaluation.accuracy, table);
  console.out << confusion.ToText() << '\n' << table.ToText();
}

void EvaluateClasses(const hc_model* model,
                     const EvaluateOptions& options,
                     const Console& console) {
  RefusePictureOptions(options.picture_options);
  const experiments::TableModel names = experiments::ReadTableModel(options.model);
  const datasets::Table table = experiments::ReadTableFor(names, options.data);
  const experiments::ClassEvaluation evaluation =
      experiments::EvaluateClasses(model, names, table, options.data);
  WriteJson(console, options.json, experiments::ToJson(evaluation));
  if (options.json != "-") PrintClasses(console, options, evaluation);
}

// Without --split all views are taken.
void EvaluateObjectClasses(const hc_model* model,
                           const EvaluateOptions& options,
                           const Console& console) {
  std::vector<std::string> picture_options = options.picture_options;
  std::erase(picture_options, "--split");
  RefusePictureOptions(picture_options);
  EvaluateClouds(model,
                 {.model = options.model,
                  .data = options.data,
                  .split = options.is_split_given ? options.split : "",
                  .counts_as = options.counts_as,
                  .json = options.json},
                 console);
}

// What evaluates a model of this kind.
auto EvaluatorOf(hc_kind kind) {
  if (kind == HC_KIND_GRASP_POINT) return EvaluateGraspPoints;
  if (kind == HC_KIND_OBJECT_CLASS) return EvaluateObjectClasses;
  return kind == HC_KIND_SVM ? EvaluateClasses : EvaluateTable;
}

void RunEvaluate(const EvaluateOptions& options, const Console& console) {
  if (options.json != "-") RequireWritable(options.json);
  RequireWritable(options.html);
  RequireNotInputs(options, {options.model, options.data});
  if (!options.html.empty() && std::filesystem::weakly_canonical(options.html) ==
                                   std::filesystem::weakly_canonical(options.json)) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = options.html,
                 .reason = "--json and --html name the same file"});
  }
  const experiments::LoadedModel model = experiments::LoadModel(options.model);
  const hc_kind kind = hc_model_kind(model.get());
  if (!options.counts_as.empty() && kind != HC_KIND_OBJECT_CLASS) RefuseCloudOption("--counts-as");
  EvaluatorOf(kind)(model.get(), options, console);
}

void AddMeasureOptions(CLI::App& command, experiments::EvaluationOptions& evaluation) {
  AddNumber(command,
            "--threshold",
            evaluation,
            &experiments::EvaluationOptions::threshold,
            "Probability above which is 'good'");
  AddNumber(command,
            "--top",
            evaluation,
            &experiments::EvaluationOptions::best_pixels,
            "Best pixels counted an image")
      ->group(kPictureGroup);
  AddNumber(command,
            "--min-probability",
            evaluation,
            &experiments::EvaluationOptions::best_min_probability,
            "… if their probability is above this")
      ->group(kPictureGroup);
  AddNumber(command,
            "--suppression-radius",
            evaluation,
            &experiments::EvaluationOptions::suppression_radius_px,
            "… and they are farther apart than this [px]")
      ->group(kPictureGroup);
  AddNumber(command,
            "--pixels-per-image",
            evaluation,
            &experiments::EvaluationOptions::pixels_per_image,
            "Labelled pixels scored an image, half of them good")
      ->group(kPictureGroup);
  AddNumber(command,
            "--resamples",
            evaluation,
            &experiments::EvaluationOptions::bootstrap_resamples,
            "Bootstrap resamples of intervals");
}

}  // namespace

void AddEvaluate(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = parent.add_subcommand(
      "evaluate", "Measure a model on labelled data: confusion matrix, accuracy, intervals");
  command->add_option("MODEL", options->model, "Model file")->required();
  command
      ->add_option("DATA",
                   options->data,
                   "Labelled image set or view set (folder), or table (.csv, .npy, .libsvm, .svm)")
      ->required();
  command->add_option("--split", options->split, "Split of an image set or view set; '' for all")
      ->capture_default_str()
      ->group(kPictureGroup);
  AddJsonFileOption(*command, options->json);
  command->add_option("--html", options->html, "Write a page with figures and overlays")
      ->type_name("FILE")
      ->group(kPictureGroup);
  command
      ->add_option("--counts-as",
                   options->counts_as,
                   "A class of the views that the model does not know, and the one that is right "
                   "for it, or 'none of these'; may be given again")
      ->type_name("CLASS=CLASS")
      ->group(kCloudGroup);
  AddMeasureOptions(*command, options->evaluation);
  AddSeedOption(*command, options->evaluation.seed);
  AddThreadsOption(*command, options->evaluation.num_threads);
  SetExample(*command,
             "handcraft evaluate out/demo/grasp_points.safetensors "
             "datasets/samples/cornell_mini");
  command->callback([options, command, &console] {
    options->picture_options = GivenOptions(*command, kPictureGroup);
    options->is_split_given = command->count("--split") > 0;
    RunEvaluate(*options, console);
  });
}

}  // namespace handcraft::tools
