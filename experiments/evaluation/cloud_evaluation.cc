// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/cloud_evaluation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include <nlohmann/json.hpp>

#include "datasets/view_folds.h"
#include "experiments/evaluation/json_text.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/object_class_models.h"
#include "lib/runtime/model_handle.h"

namespace handcraft::experiments {
namespace {

std::vector<std::string> ClassNamesOf(const hc_model* model) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < hc_model_num_classes(model); ++c) {
    names.emplace_back(hc_model_class_name(model, c));
  }
  return names;
}

// The numbers of the model's classes that are right for each truth.
std::vector<std::set<std::size_t>> RightClasses(const std::vector<std::string>& truths,
                                                const std::vector<std::string>& classes,
                                                const CountsAs& counts_as,
                                                const datasets::ViewSet& set) {
  const auto number_of = [&](const std::string& name) {
    if (name == kNoneOfThese) return classes.size();
    const auto found = std::find(classes.begin(), classes.end(), name);
    if (found != classes.end()) return static_cast<std::size_t>(found - classes.begin());
    std::string list;
    for (const std::string& known : classes) {
      list += list.empty() ? "" : ", ";
      list += known;
    }
    throw Error({.path = (set.root).string(),
                 .reason = "the class '" + name + "' is not one of the model's: " + list,
                 .remedy = "say which it counts as: --counts-as " + name + "=CLASS, or '" + name +
                           "=" + std::string(kNoneOfThese) + "'"});
  };
  std::vector<std::set<std::size_t>> right;
  for (const std::string& truth : truths) {
    std::set<std::size_t> numbers;
    const auto [begin, end] = counts_as.equal_range(truth);
    for (auto entry = begin; entry != end; ++entry) numbers.insert(number_of(entry->second));
    if (begin == end) numbers.insert(number_of(truth));
    right.push_back(std::move(numbers));
  }
  return right;
}

void Count(bool is_novel, bool is_rejected, svm::Rejection& rejection) {
  ++(is_novel ? rejection.num_novel : rejection.num_known);
  if (is_rejected) ++(is_novel ? rejection.num_novel_rejected : rejection.num_known_rejected);
}

}  // namespace

datasets::ObjectCloudOptions ReadCloudOptions(const std::filesystem::path& model) {
  const model_io::ObjectClassModel read =
      model_io::ReadObjectClassModel(model_io::Parse(ReadFile(model), model.string()));
  return {.frame = read.descriptor.frame, .outlier_step = read.outlier_step};
}

double RejectionThreshold(const hc_model* model) noexcept {
  const runtime::SvmModel* const svm = model == nullptr ? nullptr : model->Svm();
  return svm == nullptr ? -std::numeric_limits<double>::infinity() : svm->RejectionThreshold();
}

CloudClassifier::CloudClassifier(const hc_model* model) : model_(model) {
  if (hc_model_kind(model) != HC_KIND_OBJECT_CLASS) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "the model reads no clouds: it is not of kind object_class",
                 .remedy = "give a model made by 'handcraft train object-class'"});
  }
  hc_workspace* workspace = nullptr;
  const hc_status created = hc_row_workspace_create(model, &workspace);
  HC_CHECK(created == HC_OK, hc_status_message(created));
  workspace_.reset(workspace);
}

CloudClass CloudClassifier::Classify(const datasets::MaskedCloud& object) {
  const features::ObjectCloud view = object.View();
  const hc_cloud cloud{.points = view.points,
                       .width = view.width,
                       .height = view.height,
                       .row_stride = view.row_stride,
                       .point_stride = view.point_stride,
                       .mask = view.mask,
                       .mask_stride = view.mask_stride};
  CloudClass found;
  found.decision_values.resize(hc_model_num_machines(model_));
  hc_class_prediction prediction{};
  const hc_status status = hc_classify_cloud(
      model_, workspace_.get(), &cloud, &prediction, found.decision_values.data());
  if (status == HC_ERROR_CLOUD) return {};
  HC_CHECK(status == HC_OK, hc_status_message(status));
  found.has_points = true;
  found.number = static_cast<std::size_t>(prediction.number);
  found.is_rejected = prediction.rejected != 0;
  found.margin = prediction.margin;
  return found;
}

CloudEvaluation EvaluateClouds(const hc_model* model,
                               const datasets::ViewSet& set,
                               const datasets::ObjectCloudOptions& options,
                               const CountsAs& counts_as,
                               const Progress& progress) {
  CloudClassifier classifier(model);
  const datasets::ViewClasses truths = datasets::ClassesOf(set);
  CloudEvaluation evaluation{.num_views = set.items.size(),
                             .truths = truths.names,
                             .classes = ClassNamesOf(model),
                             .rejection = {.threshold = RejectionThreshold(model)},
                             .accuracy = {}};
  const std::size_t num_classes = evaluation.classes.size();
  const auto right = RightClasses(truths.names, evaluation.classes, counts_as, set);
  evaluation.confusion.assign(truths.names.size(), std::vector<std::size_t>(num_classes + 1));
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    Report(progress, "classifying", i, set.items.size());
    const CloudClass said = classifier.Classify(datasets::ReadObjectCloud(set, i, options));
    const bool has_class = said.has_points && !said.is_rejected;
    const std::size_t truth = truths.values[i];
    const std::size_t answer = has_class ? said.number : num_classes;
    const bool is_right = right[truth].contains(answer);
    ++evaluation.confusion[truth][answer];
    evaluation.answers.push_back({.truth = truth,
                                  .answer = answer,
                                  .margin = said.margin,
                                  .has_points = said.has_points,
                                  .is_right = is_right});
    evaluation.num_correct += is_right ? 1 : 0;
    evaluation.num_rejected += has_class ? 0 : 1;
    Count(right[truth] == std::set{num_classes}, !has_class, evaluation.rejection);
  }
  evaluation.accuracy = WilsonInterval(evaluation.num_correct, evaluation.num_views);
  return evaluation;
}

std::string ToJson(const CloudEvaluation& evaluation) {
  nlohmann::ordered_json json = {{"kind", "cloud_evaluation"},
                                 {"num_views", evaluation.num_views},
                                 {"truths", evaluation.truths},
                                 {"classes", evaluation.classes}};
  AddEstimate("accuracy", evaluation.accuracy, json);
  json["num_correct"] = evaluation.num_correct;
  json["num_rejected"] = evaluation.num_rejected;
  json["confusion"] = evaluation.confusion;
  const svm::Rejection& rejection = evaluation.rejection;
  const bool rejects = std::isfinite(rejection.threshold);
  json["rejection_threshold"] = rejects ? nlohmann::ordered_json(rejection.threshold) : nullptr;
  json["num_known"] = rejection.num_known;
  json["num_known_rejected"] = rejection.num_known_rejected;
  json["num_novel"] = rejection.num_novel;
  json["num_novel_rejected"] = rejection.num_novel_rejected;
  return JsonText(json);
}

}  // namespace handcraft::experiments
