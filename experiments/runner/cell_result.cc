// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/cell_result.h"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "experiments/evaluation/json_text.h"
#include "experiments/runner/result_columns.h"
#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

using Json = nlohmann::ordered_json;

ImageFigures FiguresOf(const ImageScore& score,
                       const datasets::LabelledImage& item,
                       double threshold) {
  ImageFigures figures{.image = item.image,
                       .object_class = item.object_class,
                       .best = CountBestPixels(score),
                       .num_pixels = score.labels.size()};
  if (score.labels.empty()) return figures;
  const ConfusionMatrix matrix = CountConfusion(score.probabilities, score.labels, threshold);
  const auto count = static_cast<double>(score.labels.size());
  figures.num_right = matrix.true_positive + matrix.true_negative;
  figures.log_loss_sum = count * LogLoss(score.probabilities, score.labels);
  figures.squared_error_sum = count * BrierScore(score.probabilities, score.labels);
  return figures;
}

double MedianScoreMs(const std::vector<ImageScore>& images) {
  std::vector<double> times_ms;
  times_ms.reserve(images.size());
  for (const ImageScore& image : images) times_ms.push_back(image.score_ms);
  if (times_ms.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
  std::nth_element(times_ms.begin(), middle, times_ms.end());
  return *middle;
}

// Writes columns into an object; NaN becomes null.
auto WriteInto(Json& json) {
  return [&json](const std::string& name, const auto& number) { json[name] = number; };
}

void ReadNumber(const Json& json, std::size_t& number) { number = json.get<std::size_t>(); }
void ReadNumber(const Json& json, double& number) {
  number = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}
auto ReadFrom(const Json& json) {
  return [&json](const std::string& name, auto& number) { ReadNumber(json.at(name), number); };
}

// At most kMaxCurvePoints of them, both ends kept.
template <class Point>
std::vector<Point> Thinned(const std::vector<Point>& curve) {
  constexpr std::size_t kMost = PixelCurves::kMaxCurvePoints;
  if (curve.size() <= kMost) return curve;
  std::vector<Point> kept;
  kept.reserve(kMost);
  for (std::size_t k = 0; k < kMost; ++k) {
    kept.push_back(curve[k * (curve.size() - 1) / (kMost - 1)]);
  }
  return kept;
}

PixelCurves CurvesOf(const GraspPointEvaluation& evaluation) {
  const PooledPixels pooled = PoolPixels(evaluation.images);
  return {
      .roc = Thinned(evaluation.roc),
      .precision_recall = Thinned(evaluation.precision_recall),
      .reliability = BinProbabilities(pooled.probabilities, pooled.labels, kNumReliabilityBins)};
}

Json ToJson(const PixelCurves& curves) {
  Json json = {
      {"roc", Json::array()}, {"precision_recall", Json::array()}, {"reliability", Json::array()}};
  for (const RocPoint& point : curves.roc) {
    json["roc"].push_back({point.false_positive_rate, point.true_positive_rate});
  }
  for (const PrecisionRecallPoint& point : curves.precision_recall) {
    json["precision_recall"].push_back({point.recall, point.precision});
  }
  for (const ProbabilityBin& bin : curves.reliability) {
    json["reliability"].push_back(
        {bin.low, bin.high, bin.num_good, bin.num_bad, bin.mean_probability});
  }
  return json;
}

PixelCurves CurvesFrom(const Json& json) {
  PixelCurves curves;
  for (const Json& point : json.at("roc")) curves.roc.push_back({point.at(0), point.at(1)});
  for (const Json& point : json.at("precision_recall")) {
    curves.precision_recall.push_back({point.at(0), point.at(1)});
  }
  for (const Json& entry : json.at("reliability")) {
    ProbabilityBin bin{
        .low = entry.at(0), .high = entry.at(1), .num_good = entry.at(2), .num_bad = entry.at(3)};
    ReadNumber(entry.at(4), bin.mean_probability);
    curves.reliability.push_back(bin);
  }
  return curves;
}

Json ToJson(const CellResult& result) {
  Json json = {{"cell", result.id}, {"termination", result.termination}};
  VisitTrainingColumns(result, WriteInto(json));
  VisitTimeColumns(result, WriteInto(json));
  json["groups"] = Json::array();
  for (const GroupFigures& group : result.groups) {
    Json entry = {{"class", group.name}};
    VisitGroupColumns(group, WriteInto(entry));
    json["groups"].push_back(std::move(entry));
  }
  json["images"] = Json::array();
  for (const ImageFigures& image : result.images) {
    Json entry = {{"image", image.image}, {"class", image.object_class}};
    VisitImageColumns(image, WriteInto(entry));
    json["images"].push_back(std::move(entry));
  }
  json["curves"] = ToJson(result.curves);
  json["num_images_without_region"] = result.search_space.num_images_without_region;
  json["search_stages"] = Json::array();
  for (const SearchStageFigures& stage : result.search_space.stages) {
    Json entry = {{"stage", stage.stage}};
    VisitStageColumns(stage, WriteInto(entry));
    json["search_stages"].push_back(std::move(entry));
  }
  return json;
}

CellResult FromJson(const Json& json) {
  CellResult result{.id = json.at("cell"), .termination = json.at("termination")};
  VisitTrainingColumns(result, ReadFrom(json));
  VisitTimeColumns(result, ReadFrom(json));
  for (const Json& entry : json.at("groups")) {
    GroupFigures group{.name = entry.at("class")};
    VisitGroupColumns(group, ReadFrom(entry));
    result.groups.push_back(std::move(group));
  }
  for (const Json& entry : json.at("images")) {
    ImageFigures image{.image = entry.at("image"), .object_class = entry.at("class")};
    VisitImageColumns(image, ReadFrom(entry));
    result.images.push_back(std::move(image));
  }
  result.curves = CurvesFrom(json.at("curves"));
  ReadNumber(json.at("num_images_without_region"), result.search_space.num_images_without_region);
  for (const Json& entry : json.at("search_stages")) {
    SearchStageFigures stage{.stage = entry.at("stage")};
    VisitStageColumns(stage, ReadFrom(entry));
    result.search_space.stages.push_back(std::move(stage));
  }
  return result;
}

}  // namespace

CellResult MakeCellResult(const std::string& id,
                          const CellTraining& training,
                          const GraspPointEvaluation& evaluation,
                          const datasets::LabelledImageSet& test) {
  CellResult result{.id = id,
                    .num_training_images = training.num_images,
                    .num_samples = training.num_samples,
                    .num_features = training.num_features,
                    .termination = training.termination,
                    .training_log_loss = training.log_loss,
                    .groups = evaluation.classes,
                    .curves = CurvesOf(evaluation),
                    .search_space = SearchSpaceOf(evaluation.images),
                    .features_time_s = training.features_time_s,
                    .training_time_s = training.training_time_s,
                    .score_time_ms = MedianScoreMs(evaluation.images)};
  result.groups.push_back(evaluation.all);
  for (const ImageScore& image : evaluation.images) {
    result.images.push_back(
        FiguresOf(image, test.items.at(image.item), evaluation.options.threshold));
  }
  return result;
}

void WriteCellResult(const std::filesystem::path& path, const CellResult& result) {
  WriteFileAtomically(path, JsonText(ToJson(result)));
}

CellResult ReadCellResult(const std::filesystem::path& path, const std::string& id) {
  const std::string text = ReadTextFile(path);
  const std::string remedy = "remove the file: its cell will be worked out again";
  try {
    CellResult result = FromJson(Json::parse(text));
    if (result.groups.empty()) {
      throw Error({.path = path.string(), .reason = "has no figures", .remedy = remedy});
    }
    if (result.id == id) return result;
    throw Error({.path = path.string(),
                 .reason = "holds the cell " + result.id + ", not " + id,
                 .remedy = remedy});
  } catch (const Json::exception& error) {
    throw Error({.path = path.string(),
                 .reason = std::string("is no result of a cell: ") + error.what(),
                 .remedy = remedy});
  }
}

}  // namespace handcraft::experiments
