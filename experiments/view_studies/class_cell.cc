// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/class_cell.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "datasets/view_folds.h"
#include "experiments/evaluation/cloud_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/view_studies/view_data.h"
#include "lib/core/error.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/object_class_models.h"

namespace handcraft::experiments {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void RequireConverged(const svm::Summary& summary) {
  if (summary.termination == svm::Termination::kConverged) return;
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "no support vector machine: " + summary.message,
               .remedy = "set standardize = \"yes\" or a smaller C"});
}

// What is right for each row: the class itself, or those it is associated with.
std::vector<std::vector<bool>> RightAnswers(const ViewStudy& study, const AnswerCounts& answers) {
  std::vector<std::vector<bool>> is_right;
  for (const std::string& row : answers.rows) {
    const auto entry = study.associations.find(row);
    std::vector<bool>& right = is_right.emplace_back();
    for (const std::string& column : answers.columns) {
      right.push_back(entry == study.associations.end()
                          ? column == row
                          : std::find(entry->second.begin(), entry->second.end(), column) !=
                                entry->second.end());
    }
  }
  return is_right;
}

AnswerCounts CountsOf(const datasets::ViewSet& set, const std::vector<std::uint32_t>& predicted) {
  const datasets::ViewClasses classes = datasets::ClassesOf(set);
  const std::size_t num_classes = classes.names.size();
  AnswerCounts answers{.row_title = "object",
                       .rows = classes.names,
                       .columns = classes.names,
                       .counts = std::vector(num_classes, std::vector<std::size_t>(num_classes))};
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    ++answers.counts[classes.values[i]][predicted[i]];
  }
  return answers;
}

AnswerCounts CountsOf(const CloudEvaluation& evaluation) {
  AnswerCounts answers{.row_title = "object",
                       .rows = evaluation.truths,
                       .columns = evaluation.classes,
                       .counts = evaluation.confusion};
  answers.columns.emplace_back("none of these");
  return answers;
}

// The model as a robot would have it.
LoadedModel Load(const ObjectClassTraining& training, const datasets::MaskedCloud& example) {
  return LoadModel(
      model_io::Serialise(model_io::MakeObjectClassModel(training.model, example.View(), {})));
}

// Of one view's cloud, the median.
double ClassifyMs(const hc_model* model, const datasets::MaskedCloud& example) {
  CloudClassifier classifier(model);
  std::array<double, 21> times_ms{};
  for (double& time_ms : times_ms) {
    const Clock::time_point start = Clock::now();
    static_cast<void>(classifier.Classify(example));
    time_ms = 1e3 * SecondsSince(start);
  }
  std::nth_element(times_ms.begin(), times_ms.begin() + 10, times_ms.end());
  return times_ms[10];
}

CountsAs CountsAsOf(const ViewStudy& study) {
  CountsAs counts_as;
  for (const auto& [name, right] : study.associations) {
    for (const std::string& one : right) counts_as.emplace(name, one);
  }
  return counts_as;
}

}  // namespace

ViewCellResult TellClasses(const ViewStudy& study,
                           const ViewCell& cell,
                           const datasets::ViewSet& train,
                           const datasets::ViewSet* test,
                           int num_threads,
                           const Progress& progress) {
  ObjectClassOptions options = cell.settings.classes;
  options.num_folds = test == nullptr ? kLeaveOneOut : 0;
  options.svm.num_threads = num_threads;
  options.svm.progress = progress;
  const datasets::ViewSet learnt = OnlyFirstClasses(train, cell.settings.num_classes);
  const Clock::time_point start = Clock::now();
  const ObjectClassTraining training = TrainObjectClasses(learnt, options);
  ViewCellResult result{.id = cell.id, .answers = {}};
  result.times.push_back({"training_s", SecondsSince(start)});
  RequireConverged(training.summary);
  const datasets::ObjectCloudOptions clouds{.frame = options.descriptor.frame,
                                            .outlier_step = options.outlier_step};
  const datasets::MaskedCloud example = datasets::ReadObjectCloud(learnt, 0, clouds);
  const LoadedModel model = Load(training, example);
  result.answers =
      test == nullptr
          ? CountsOf(learnt, training.predicted)
          : CountsOf(EvaluateClouds(model.get(), *test, clouds, CountsAsOf(study), progress));
  result.answers.is_right = RightAnswers(study, result.answers);
  result.times.push_back({"classify_ms", ClassifyMs(model.get(), example)});
  for (std::size_t row = 0; row < result.answers.rows.size(); ++row) {
    result.groups.push_back(ShareOfRow(result.answers, row));
  }
  result.groups.push_back(ShareOfAll("all", result.groups));
  return result;
}

}  // namespace handcraft::experiments
