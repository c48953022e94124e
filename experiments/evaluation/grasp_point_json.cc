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
  AddEstimate("strict_accuracy", figures.strict_accuracy, json);
  json["strict_confusion"] = ConfusionJson(figures.strict_confusion);
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

Json ReliabilityJson(const std::vector<ImageScore>& images) {
  const PooledPixels pooled = PoolPixels(images);
  Json json = Json::array();
  for (const ProbabilityBin& bin :
       BinProbabilities(pooled.probabilities, pooled.labels, kNumReliabilityBins)) {
    json.push_back({{"low", bin.low},
                    {"high", bin.high},
                    {"good", bin.num_good},
                    {"bad", bin.num_bad},
                    {"mean_probability", bin.mean_probability}});
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
  json["roc"] = RocJson(evaluation.roc);
  json["precision_recall"] = PrecisionRecallJson(evaluation.precision_recall);
  json["reliability"] = ReliabilityJson(evaluation.images);
  json["images"] = Json::array();
  for (const ImageScore& image : evaluation.images) {
    json["images"].push_back(ImageJson(image, set.items.at(image.item)));
  }
  return JsonText(json);
}

}  // namespace handcraft::experiments
