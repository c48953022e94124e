// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_page.h"

#include <string_view>

#include <fmt/format.h>

#include "experiments/evaluation/grasp_point_plots.h"
#include "experiments/evaluation/grasp_point_templates.h"
#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/pixel_cards.h"
#include "lib/core/counted.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kNumHistogramBins = 20;
// More bars than this leave no room for their names.
constexpr std::size_t kMaxPlottedClasses = 12;

std::string HeaderText(const GraspPointEvaluation& evaluation, const ReportContents& contents) {
  const GroupFigures& all = evaluation.all;
  const std::string left_out = all.best_dont_care == 0
                                   ? std::string()
                                   : fmt::format(" {} more on don’t-care ground {} not counted.",
                                                 all.best_dont_care,
                                                 all.best_dont_care == 1 ? "is" : "are");
  const std::string verdict =
      all.best_total == 0
          ? fmt::format("No best pixel lies on labelled ground.{}", left_out)
          : fmt::format("Of the {} best pixels on labelled ground, {} lie where a grasp is good.{}",
                        all.best_total,
                        all.best_good,
                        left_out);
  return fmt::format(fmt::runtime(kHeaderTemplate),
                     fmt::arg("model", EscapeHtml(contents.model_name)),
                     fmt::arg("data", EscapeHtml(contents.data_name)),
                     fmt::arg("images", Counted(all.num_images, "image")),
                     fmt::arg("verdict", verdict));
}

std::string Tile(std::string_view name, const std::string& value, const std::string& range) {
  return fmt::format(fmt::runtime(kTileTemplate),
                     fmt::arg("name", name),
                     fmt::arg("value", value),
                     fmt::arg("range", range));
}

std::string TilesText(const GraspPointEvaluation& evaluation) {
  const GroupFigures& all = evaluation.all;
  return "<div class=\"tiles\">\n" +
         Tile("Best-pixel accuracy",
              PercentText(all.best_pixel_accuracy.value),
              PercentIntervalText(all.best_pixel_accuracy)) +
         Tile(fmt::format("Pixel accuracy at {:g}", evaluation.options.threshold),
              PercentText(all.accuracy.value),
              PercentIntervalText(all.accuracy)) +
         Tile("Area under the ROC curve",
              DecimalText(all.auc.value, 3),
              DecimalIntervalText(all.auc, 3)) +
         Tile("Log-loss",
              DecimalText(all.log_loss.value, 3),
              DecimalIntervalText(all.log_loss, 3) + " guessing: 0.693") +
         "</div>\n";
}

std::string FiguresRow(const GroupFigures& figures, bool is_total) {
  return fmt::format(fmt::runtime(kFiguresRowTemplate),
                     fmt::arg("row_class", is_total ? " class=\"total\"" : ""),
                     fmt::arg("name", EscapeHtml(figures.name)),
                     fmt::arg("images", figures.num_images),
                     fmt::arg("silent", figures.num_images_without_best),
                     fmt::arg("good", figures.best_good),
                     fmt::arg("counted", figures.best_total),
                     fmt::arg("dont_care", figures.best_dont_care),
                     fmt::arg("best", PercentText(figures.best_pixel_accuracy.value)),
                     fmt::arg("best_range", PercentIntervalText(figures.best_pixel_accuracy)),
                     fmt::arg("accuracy", PercentText(figures.accuracy.value)),
                     fmt::arg("accuracy_range", PercentIntervalText(figures.accuracy)),
                     fmt::arg("auc", DecimalText(figures.auc.value, 3)),
                     fmt::arg("auc_range", DecimalIntervalText(figures.auc, 3)),
                     fmt::arg("log_loss", DecimalText(figures.log_loss.value, 3)),
                     fmt::arg("log_loss_range", DecimalIntervalText(figures.log_loss, 3)),
                     fmt::arg("brier", DecimalText(figures.brier.value, 3)),
                     fmt::arg("brier_range", DecimalIntervalText(figures.brier, 3)));
}

std::string FiguresText(const GraspPointEvaluation& evaluation) {
  std::string rows;
  for (const GroupFigures& figures : evaluation.classes) rows += FiguresRow(figures, false);
  rows += FiguresRow(evaluation.all, true);
  std::string text = fmt::format(fmt::runtime(kFiguresTemplate), fmt::arg("rows", rows));
  if (evaluation.classes.size() > 1 && evaluation.classes.size() <= kMaxPlottedClasses) {
    text += fmt::format("<figure class=\"card wide\">{}</figure>\n",
                        PlotBestPixelAccuracy(evaluation).ToInlineText());
  }
  return text;
}

std::string PlotsText(const GraspPointEvaluation& evaluation) {
  const PooledPixels pooled = PoolPixels(evaluation.images);
  const GroupFigures& all = evaluation.all;
  return fmt::format(
      fmt::runtime(kPlotsTemplate),
      fmt::arg("pixels", pooled.labels.size()),
      fmt::arg("cards",
               PixelCards({.confusion = all.confusion,
                           .rates = all.rates,
                           .threshold = evaluation.options.threshold,
                           .strict_confusion = all.strict_confusion,
                           .strict_rates = all.strict_rates,
                           .strict_threshold = evaluation.options.best_min_probability,
                           .auc = all.auc,
                           .average_precision = all.average_precision,
                           .brier = all.brier},
                          evaluation.curves)),
      fmt::arg("histogram",
               PlotScoreHistogram(
                   BinProbabilities(pooled.probabilities, pooled.labels, kNumHistogramBins))
                   .ToInlineText()));
}

std::string VerdictOf(const BestPixelCounts& best, const EvaluationOptions& options) {
  const std::size_t counted = best.good + best.bad;
  if (counted + best.dont_care == 0) {
    return fmt::format("no pixel above {:g}", options.best_min_probability);
  }
  std::string text;
  if (counted > 0) {
    text = fmt::format("<span class=\"{}\">{} of {} good</span>",
                       2 * best.good >= counted ? "good" : "bad",
                       best.good,
                       counted);
  }
  if (best.dont_care > 0) {
    text += fmt::format("{}{} on don’t-care ground", text.empty() ? "" : ", ", best.dont_care);
  }
  return text;
}

std::string PictureText(const ReportPicture& picture, const EvaluationOptions& options) {
  const std::string name = EscapeHtml(picture.name);
  const std::string close_up =
      picture.close_up_jpeg.empty()
          ? std::string()
          : fmt::format(fmt::runtime(kCloseUpTemplate),
                        fmt::arg("name", name),
                        fmt::arg("close_up", DataUri("image/jpeg", picture.close_up_jpeg)));
  return fmt::format(fmt::runtime(kPictureTemplate),
                     fmt::arg("name", name),
                     fmt::arg("class", EscapeHtml(picture.object_class)),
                     fmt::arg("verdict", VerdictOf(picture.best, options)),
                     fmt::arg("overlay", DataUri("image/jpeg", picture.overlay_jpeg)),
                     fmt::arg("mask", DataUri("image/jpeg", picture.mask_jpeg)),
                     fmt::arg("close_up", close_up));
}

std::string GalleryText(const GraspPointEvaluation& evaluation, const ReportContents& contents) {
  std::string cards;
  for (const ReportPicture& picture : contents.pictures) {
    cards += PictureText(picture, evaluation.options);
  }
  const std::string shown =
      contents.pictures.size() == evaluation.images.size()
          ? std::string()
          : fmt::format(" Shown are {} of {} images, evenly spread over the set.",
                        contents.pictures.size(),
                        evaluation.images.size());
  return fmt::format(
      fmt::runtime(kGalleryTemplate), fmt::arg("shown", shown), fmt::arg("cards", cards));
}

std::string ModelText(const ReportContents& contents) {
  std::string facts;
  for (const ModelFact& fact : contents.model_facts) {
    facts += fmt::format("<dt>{}</dt><dd>{}</dd>\n", EscapeHtml(fact.name), EscapeHtml(fact.value));
  }
  return fmt::format(fmt::runtime(kModelTemplate), fmt::arg("facts", facts));
}

std::string MethodText(const GraspPointEvaluation& evaluation) {
  const EvaluationOptions& options = evaluation.options;
  const std::string suppression =
      options.suppression_radius_px == 0
          ? std::string()
          : fmt::format(", more than {} px apart", options.suppression_radius_px);
  return fmt::format(fmt::runtime(kMethodTemplate),
                     fmt::arg("best_pixels", options.best_pixels),
                     fmt::arg("min_probability", fmt::format("{:g}", options.best_min_probability)),
                     fmt::arg("suppression", suppression),
                     fmt::arg("half", options.pixels_per_image / 2),
                     fmt::arg("threshold", fmt::format("{:g}", options.threshold)),
                     fmt::arg("resamples", options.bootstrap_resamples),
                     fmt::arg("seed", options.seed),
                     fmt::arg("fingerprint", EscapeHtml(evaluation.data_fingerprint)));
}

}  // namespace

std::string MakeGraspPointPage(const GraspPointEvaluation& evaluation,
                               const ReportContents& contents) {
  const std::string body = HeaderText(evaluation, contents) + TilesText(evaluation) +
                           FiguresText(evaluation) + PlotsText(evaluation) +
                           GalleryText(evaluation, contents) + ModelText(contents) +
                           MethodText(evaluation);
  return MakeHtmlPage("Grasp points: " + contents.model_name, body);
}

}  // namespace handcraft::experiments
