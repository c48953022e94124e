// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nlohmann/json.hpp>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/grasp_point_figures.h"
#include "experiments/evaluation/json_text.h"
#include "experiments/metrics/probability_bins.h"

namespace handcraft::experiments {
namespace {

using Json = nlohmann::ordered_json;

const char* NameOfMaskValue(std::uint8_t value) {
  if (value == datasets::kMaskGood) return "good";
  return value == datasets::kMaskBad ? "bad" : "dont_care";
}

Json OptionsJson(const EvaluationOptions& options) {
  return {{"threshold", options.threshold},
          {"best_pixels", options.best_pixels},
          {"best_min_probability", options.best_min_probability},
          {"suppression_radius_px", options.suppression_radius_px},
          {"pixels_per_image", options.pixels_per_image},
          {"bootstrap_resamples", options.bootstrap_resamples},
          {"seed", options.seed}};
}

// The same keys for the whole set and for each class.
void AddFigures(const GroupFigures& figures, Json& json) {
  json["num_images"] = figures.num_images;
  json["num_images_without_best_pixel"] = figures.num_images_without_best;
  json["best_pixels_counted"] = figures.best_total;
  json["best_pixels_good"] = figures.best_good;
  json["best_pixels_dont_care"] = figures.best_dont_care;
  AddEstimate("best_pixel_accuracy", figures.best_pixel_accuracy, json);
  json["num_pixels"] = figures.confusion.Total();
  AddEstimate("accuracy", figures.accuracy, json);
  AddEstimate("auc", figures.auc, json);
  AddEstimate("average_precision", figures.average_precision, json);
  AddEstimate("log_loss", figures.log_loss, json);
  AddEstimate("brier", figures.brier, json);
  json["confusion"] = ConfusionJson(figures.confusion);
  AddEstimate("true_positive_rate", figures.rates.true_positive_rate, json);
  AddEstimate("true_negative_rate", figures.rates.true_negative_rate, json);
  AddEstimate("strict_accuracy", figures.strict_accuracy, json);
  json["strict_confusion"] = ConfusionJson(figures.strict_confusion);
  AddEstimate("strict_true_positive_rate", figures.strict_rates.true_positive_rate, json);
  AddEstimate("strict_true_negative_rate", figures.strict_rates.true_negative_rate, json);
}

Json ImageJson(const ImageScore& image, const datasets::LabelledImage& item) {
  const BestPixelCounts counts = CountBestPixels(image);
  Json json = {{"image", item.image},
               {"class", item.object_class},
               {"instance", item.instance},
               {"best_pixels_good", counts.good},
               {"best_pixels_bad", counts.bad},
               {"best_pixels_dont_care", counts.dont_care},
               {"best_pixels", Json::array()}};
  for (const BestPixel& pixel : image.best) {
    json["best_pixels"].push_back({{"u_px", pixel.u_px},
                                   {"v_px", pixel.v_px},
                                   {"probability", ShortestDouble(pixel.probability)},
                                   {"label", NameOfMaskValue(pixel.mask_value)}});
  }
  return json;
}

// [[recall, precision], …]
Json PrecisionRecallJson(const std::vector<PrecisionRecallPoint>& curve) {
  Json json = Json::array();
  for (const PrecisionRecallPoint& point : curve) {
    json.push_back({point.recall, point.precision});
  }
  return json;
}

// [[x, low, high], …]
Json BandJson(const std::vector<BandPoint>& band) {
  Json json = Json::array();
  for (const BandPoint& point : band) json.push_back({point.x, point.low, point.high});
  return json;
}

Json ReliabilityJson(const std::vector<ReliabilityBin>& reliability) {
  Json json = Json::array();
  for (const ReliabilityBin& entry : reliability) {
    Json bin = {{"low", entry.bin.low},
                {"high", entry.bin.high},
                {"good", entry.bin.num_good},
                {"bad", entry.bin.num_bad},
                {"mean_probability", entry.bin.mean_probability}};
    AddEstimate("good_share", entry.good_share, bin);
    json.push_back(std::move(bin));
  }
  return json;
}

}  // namespace

std::string ToJson(const GraspPointEvaluation& evaluation, const datasets::LabelledImageSet& set) {
  Json json = {{"kind", "grasp_point_evaluation"},
               {"data_fingerprint", evaluation.data_fingerprint},
               {"options", OptionsJson(evaluation.options)}};
  AddFigures(evaluation.all, json);
  json["classes"] = Json::array();
  for (const GroupFigures& figures : evaluation.classes) {
    Json entry = {{"class", figures.name}};
    AddFigures(figures, entry);
    json["classes"].push_back(std::move(entry));
  }
  const PixelCurves& curves = evaluation.curves;
  json["roc"] = RocJson(curves.roc);
  json["roc_band"] = BandJson(curves.bands.roc);
  json["precision_recall"] = PrecisionRecallJson(curves.precision_recall);
  json["precision_recall_band"] = BandJson(curves.bands.precision_recall);
  json["reliability"] = ReliabilityJson(curves.reliability);
  json["images"] = Json::array();
  for (const ImageScore& image : evaluation.images) {
    json["images"].push_back(ImageJson(image, set.items.at(image.item)));
  }
  return JsonText(json);
}

}  // namespace handcraft::experiments
