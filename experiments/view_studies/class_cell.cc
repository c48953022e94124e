// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/class_cell.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "datasets/view_folds.h"
#include "experiments/evaluation/cloud_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/view_studies/view_data.h"
#include "lib/core/error.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/object_class_models.h"
#include "trainers/svm/rejection.h"

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
    const std::vector<std::string> classes = RightClasses(study, row);
    std::vector<bool>& right = is_right.emplace_back();
    for (const std::string& column : answers.columns) {
      right.push_back(std::find(classes.begin(), classes.end(), column) != classes.end());
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

// With what is below its class's threshold taken back.
AnswerCounts CountsOf(const CloudEvaluation& evaluation, const std::vector<double>& thresholds) {
  const std::size_t none = evaluation.classes.size();
  AnswerCounts answers{
      .row_title = "object",
      .rows = evaluation.truths,
      .columns = evaluation.classes,
      .counts = std::vector(evaluation.truths.size(), std::vector<std::size_t>(none + 1))};
  answers.columns.emplace_back(kNoneOfThese);
  for (const CloudAnswer& said : evaluation.answers) {
    const bool is_rejected = said.has_points && said.margin < thresholds[said.truth];
    ++answers.counts[said.truth][is_rejected ? none : said.answer];
  }
  return answers;
}

// Whether "none of these" is right for each class that is asked about.
std::vector<bool> NovelOnes(const ViewStudy& study, const CloudEvaluation& evaluation) {
  std::vector<bool> is_novel;
  for (const std::string& truth : evaluation.truths) {
    const auto entry = study.associations.find(truth);
    is_novel.push_back(entry != study.associations.end() &&
                       entry->second == std::vector<std::string>{std::string(kNoneOfThese)});
  }
  return is_novel;
}

// A class's threshold is set by the views of all others.
double ThresholdOf(std::size_t truth,
                   const std::vector<bool>& is_novel,
                   const CloudEvaluation& evaluation) {
  std::vector<double> known;
  std::vector<double> novel;
  for (const CloudAnswer& said : evaluation.answers) {
    if (said.truth == truth || !said.has_points) continue;
    (is_novel[said.truth] ? novel : known).push_back(said.margin);
  }
  if (known.empty() || novel.empty()) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format("rejection = calibrated: without \"{}\" no {} object is left",
                               evaluation.truths[truth],
                               known.empty() ? "known" : "novel"),
         .remedy = "ask about two of each kind at least; [association] has "
                   "NAME = \"none of these\" for novel ones"});
  }
  return svm::CalibrateRejection(known, novel).threshold;
}

std::vector<double> Thresholds(const ViewStudy& study,
                               ClassRejection rejection,
                               const CloudEvaluation& evaluation) {
  std::vector<double> thresholds(evaluation.truths.size(),
                                 -std::numeric_limits<double>::infinity());
  if (rejection == ClassRejection::kNone) return thresholds;
  const std::vector<bool> is_novel = NovelOnes(study, evaluation);
  for (std::size_t truth = 0; truth < thresholds.size(); ++truth) {
    thresholds[truth] = ThresholdOf(truth, is_novel, evaluation);
  }
  return thresholds;
}

std::vector<JudgedAnswer> JudgedOnes(const CloudEvaluation& evaluation) {
  std::vector<JudgedAnswer> judged;
  for (const CloudAnswer& said : evaluation.answers) {
    if (said.has_points) judged.push_back({.doubt = -said.margin, .is_right = said.is_right});
  }
  return judged;
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

void RequireTest(const ViewCell& cell, const datasets::ViewSet* test) {
  if (test == nullptr && cell.settings.rejection != ClassRejection::kNone) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = "rejection is calibrated on other objects, and there is no [data.test]"});
  }
}

void TakeAnswers(const ViewStudy& study,
                 const ViewCell& cell,
                 const CloudEvaluation& evaluation,
                 ViewCellResult& result) {
  result.answers = CountsOf(evaluation, Thresholds(study, cell.settings.rejection, evaluation));
  result.rejection = RejectionCurve(JudgedOnes(evaluation));
}

}  // namespace

ViewCellResult TellClasses(const ViewStudy& study,
                           const ViewCell& cell,
                           const datasets::ViewSet& train,
                           const datasets::ViewSet* test,
                           int num_threads,
                           const Progress& progress) {
  RequireTest(cell, test);
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
  if (test == nullptr) {
    result.answers = CountsOf(learnt, training.predicted);
  } else {
    TakeAnswers(study,
                cell,
                EvaluateClouds(model.get(), *test, clouds, CountsAsOf(study), progress),
                result);
  }
  result.answers.is_right = RightAnswers(study, result.answers);
  result.times.push_back({"classify_ms", ClassifyMs(model.get(), example)});
  for (std::size_t row = 0; row < result.answers.rows.size(); ++row) {
    result.groups.push_back(ShareOfRow(result.answers, row));
  }
  result.groups.push_back(ShareOfAll("all", result.groups));
  return result;
}

}  // namespace handcraft::experiments
