// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/cloud_commands.h"

#include <cmath>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "datasets/formats/mask_picture.h"
#include "datasets/object_clouds.h"
#include "datasets/view_folds.h"
#include "experiments/evaluation/cloud_evaluation.h"
#include "lib/core/error.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

experiments::CountsAs ParseCountsAs(const std::vector<std::string>& pairs) {
  experiments::CountsAs counts_as;
  for (const std::string& pair : pairs) {
    const std::size_t at = pair.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == pair.size()) {
      throw Error({.kind = Error::Kind::kUsage,
                   .reason = "--counts-as " + pair + ": CLASS=CLASS_OF_THE_MODEL is due",
                   .remedy = "for what is no class of the model: '--counts-as \"CLASS=" +
                             std::string(experiments::kNoneOfThese) + "\"'"});
    }
    counts_as.emplace(pair.substr(0, at), pair.substr(at + 1));
  }
  return counts_as;
}

// Empty when the model rejects nothing and need not.
std::string RejectionText(const svm::Rejection& rejection) {
  if (std::isfinite(rejection.threshold)) {
    std::string counts;
    if (rejection.num_novel > 0) {
      counts = fmt::format(
          " {} of {} novel views found", rejection.num_novel_rejected, rejection.num_novel);
    }
    if (rejection.num_known > 0) {
      counts += fmt::format("{} {} of {} known views lost",
                            counts.empty() ? "" : ",",
                            rejection.num_known_rejected,
                            rejection.num_known);
    }
    return fmt::format("None of these below a margin of {:.4g}:{}\n", rejection.threshold, counts);
  }
  if (rejection.num_novel == 0) return "";
  return "The model has no threshold and takes everything for one of its classes: train it with "
         "--novel.\n";
}

std::string ToText(const experiments::CloudEvaluation& evaluation) {
  std::vector<std::string> header = {""};
  for (const std::string& name : evaluation.classes) header.push_back("predicted " + name);
  if (evaluation.num_rejected > 0) header.emplace_back(experiments::kNoneOfThese);
  TextTable confusion(header);
  for (std::size_t t = 0; t < evaluation.truths.size(); ++t) {
    std::vector<std::string> row = {evaluation.truths[t]};
    for (std::size_t c = 0; c + 1 < header.size(); ++c) {
      row.push_back(std::to_string(evaluation.confusion[t][c]));
    }
    confusion.AddRow(row);
  }
  return fmt::format(
      "{}\n{} of {} views right: accuracy {:.2f} % (95 % interval {:.2f} to {:.2f} %)\n{}",
      confusion.ToText(),
      evaluation.num_correct,
      evaluation.num_views,
      100.0 * evaluation.accuracy.value,
      100.0 * evaluation.accuracy.low,
      100.0 * evaluation.accuracy.high,
      RejectionText(evaluation.rejection));
}

datasets::MaskedCloud ReadObject(const std::string& path,
                                 const PredictCloudsOptions& options,
                                 const datasets::ObjectCloudOptions& clouds) {
  datasets::OrganisedCloud cloud = datasets::ReadPcd(path);
  if (cloud.height <= 1) {
    throw Error({.path = path,
                 .reason = "the cloud has no rows and columns: a point for each pixel is due",
                 .remedy = "give an organised cloud"});
  }
  const std::string& mask_path = options.object_mask;
  if (mask_path.empty()) {
    return datasets::FindObjectCloud(std::move(cloud), options.table, clouds);
  }
  Image mask = datasets::ReadObjectMask(mask_path);
  datasets::RequireSameSize(mask_path, "the mask", datasets::SizeOf(mask), datasets::SizeOf(cloud));
  return datasets::TakeObjectCloud(std::move(cloud), std::move(mask), clouds);
}

}  // namespace

void RefuseCloudOption(const std::string& option) {
  throw Error({.kind = Error::Kind::kUsage,
               .reason = option + " is for models of object classes, and this model is none"});
}

void EvaluateClouds(const hc_model* model,
                    const EvaluateCloudsOptions& options,
                    const Console& console) {
  const experiments::CountsAs counts_as = ParseCountsAs(options.counts_as);
  const datasets::ViewSet whole = datasets::ReadViewSet(options.data);
  RequireNotAnInput(options.json, FilesOf(whole));
  ProgressBar bar(console);
  const experiments::CloudEvaluation evaluation =
      experiments::EvaluateClouds(model,
                                  datasets::OnlySplit(whole, options.split),
                                  experiments::ReadCloudOptions(options.model),
                                  counts_as,
                                  bar.Callback());
  bar.Clear();
  WriteJson(console, options.json, experiments::ToJson(evaluation));
  if (options.json == "-") return;
  console.out << fmt::format(
                     "{} on {} views of {}\n\n", options.model, evaluation.num_views, options.data)
              << ToText(evaluation);
}

Json PredictClouds(const hc_model* model, const PredictCloudsOptions& options) {
  const datasets::ObjectCloudOptions clouds = experiments::ReadCloudOptions(options.model);
  experiments::CloudClassifier classifier(model);
  const double margin_least = experiments::RejectionThreshold(model);
  const Json threshold = std::isfinite(margin_least) ? Json(margin_least) : Json();
  Json predictions = Json::array();
  for (const std::string& path : options.clouds) {
    const experiments::CloudClass found = classifier.Classify(ReadObject(path, options, clouds));
    if (!found.has_points) {
      throw Error({.kind = Error::Kind::kNoResult,
                   .path = path,
                   .reason = "fewer than three points of an object were measured",
                   .remedy = "look at --up, --up-angle and --table-distance, or give "
                             "--object-mask"});
    }
    const std::string nearest = hc_model_class_name(model, found.number);
    predictions.push_back({{"cloud", path},
                           {"class", found.is_rejected ? Json() : Json(nearest)},
                           {"nearest_class", nearest},
                           {"margin", found.margin},
                           {"rejection_threshold", threshold},
                           {"decision_values", found.decision_values}});
  }
  return predictions;
}

std::string CloudTable(const Json& predictions) {
  TextTable table({"cloud", "class", "margin"});
  for (const Json& found : predictions) {
    const auto nearest = found["nearest_class"].get<std::string>();
    table.AddRow({found["cloud"].get<std::string>(),
                  found["class"].is_null()
                      ? fmt::format("{}; the nearest is {}", experiments::kNoneOfThese, nearest)
                      : nearest,
                  fmt::format("{:.4f}", found["margin"].get<double>())});
  }
  return table.ToText();
}

}  // namespace handcraft::tools
