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
#include "lib/core/sha256.h"

namespace handcraft::experiments {
namespace {

using Json = nlohmann::ordered_json;

ImageFigures FiguresOf(const ImageScore& score,
                       const datasets::LabelledImage& item,
                       const EvaluationOptions& options) {
  ImageFigures figures{.image = item.image,
                       .object_class = item.object_class,
                       .best = CountBestPixels(score),
                       .num_pixels = score.labels.size()};
  if (score.labels.empty()) return figures;
  figures.confusion = CountConfusion(score.probabilities, score.labels, options.threshold);
  figures.strict_confusion =
      CountConfusion(score.probabilities, score.labels, options.best_min_probability);
  const auto count = static_cast<double>(score.labels.size());
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

// At most 101 of them, both ends kept.
template <class Point>
std::vector<Point> Thinned(const std::vector<Point>& curve) {
  constexpr std::size_t kMost = 101;
  if (curve.size() <= kMost) return curve;
  std::vector<Point> kept;
  kept.reserve(kMost);
  for (std::size_t k = 0; k < kMost; ++k) {
    kept.push_back(curve[k * (curve.size() - 1) / (kMost - 1)]);
  }
  return kept;
}

PixelCurves Thinned(const PixelCurves& curves) {
  return {.roc = Thinned(curves.roc),
          .precision_recall = Thinned(curves.precision_recall),
          .bands = curves.bands,
          .reliability = curves.reliability};
}

Json ToJson(const std::vector<BandPoint>& band) {
  Json json = Json::array();
  for (const BandPoint& point : band) json.push_back({point.x, point.low, point.high});
  return json;
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
  for (const auto& [bin, share] : curves.reliability) {
    json["reliability"].push_back({bin.low,
                                   bin.high,
                                   bin.num_good,
                                   bin.num_bad,
                                   bin.mean_probability,
                                   share.value,
                                   share.low,
                                   share.high});
  }
  json["roc_band"] = ToJson(curves.bands.roc);
  json["precision_recall_band"] = ToJson(curves.bands.precision_recall);
  return json;
}

std::vector<BandPoint> BandFrom(const Json& json) {
  std::vector<BandPoint> band;
  for (const Json& entry : json) {
    BandPoint point{.x = entry.at(0)};
    ReadNumber(entry.at(1), point.low);
    ReadNumber(entry.at(2), point.high);
    band.push_back(point);
  }
  return band;
}

PixelCurves CurvesFrom(const Json& json) {
  PixelCurves curves;
  for (const Json& point : json.at("roc")) curves.roc.push_back({point.at(0), point.at(1)});
  for (const Json& point : json.at("precision_recall")) {
    curves.precision_recall.push_back({point.at(0), point.at(1)});
  }
  for (const Json& entry : json.at("reliability")) {
    ReliabilityBin bin{.bin = {.low = entry.at(0),
                               .high = entry.at(1),
                               .num_good = entry.at(2),
                               .num_bad = entry.at(3)}};
    ReadNumber(entry.at(4), bin.bin.mean_probability);
    ReadNumber(entry.at(5), bin.good_share.value);
    ReadNumber(entry.at(6), bin.good_share.low);
    ReadNumber(entry.at(7), bin.good_share.high);
    curves.reliability.push_back(bin);
  }
  curves.bands = {.roc = BandFrom(json.at("roc_band")),
                  .precision_recall = BandFrom(json.at("precision_recall_band"))};
  return curves;
}

Json ToJson(const CellResult& result) {
  Json json = {{"cell", result.id},
               {"model_sha256", result.model_sha256},
               {"termination", result.termination}};
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
  CellResult result{.id = json.at("cell"),
                    .model_sha256 = json.at("model_sha256"),
                    .termination = json.at("termination")};
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

constexpr const char* kChecksum = "sha256";

// Numbers are written with as many digits as tell them apart, so that the text can be formed again.
std::string ChecksumOf(const Json& without_checksum) {
  const std::string text = JsonText(without_checksum);
  return Sha256Hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
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
                    .curves = Thinned(evaluation.curves),
                    .search_space = SearchSpaceOf(evaluation.images),
                    .features_time_s = training.features_time_s,
                    .training_time_s = training.training_time_s,
                    .score_time_ms = MedianScoreMs(evaluation.images)};
  result.groups.push_back(evaluation.all);
  for (const ImageScore& image : evaluation.images) {
    result.images.push_back(FiguresOf(image, test.items.at(image.item), evaluation.options));
  }
  return result;
}

void WriteCellResult(const std::filesystem::path& path, const CellResult& result) {
  Json json = ToJson(result);
  json[kChecksum] = ChecksumOf(json);
  WriteFileAtomically(path, JsonText(json));
}

CellResult ReadCellResult(const std::filesystem::path& path, const std::string& id) {
  const auto fail = [&path](const std::string& reason) -> Error {
    return Error({.path = path.string(), .reason = reason});
  };
  const std::string text = ReadTextFile(path);
  try {
    Json json = Json::parse(text);
    const std::string written = json.at(kChecksum);
    json.erase(kChecksum);
    if (ChecksumOf(json) != written) throw fail("has been changed since it was written");
    CellResult result = FromJson(json);
    if (result.groups.empty()) throw fail("has no figures");
    if (result.id != id) throw fail("holds the cell " + result.id + ", not " + id);
    return result;
  } catch (const Json::exception& error) {
    throw fail(std::string("is no result of a cell: ") + error.what());
  }
}

}  // namespace handcraft::experiments
