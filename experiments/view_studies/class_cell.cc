// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/class_cell.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "experiments/evaluation/class_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/model_io/svm_models.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/grid_search.h"

namespace handcraft::experiments {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The views of the classes that a cell learns, with their features.
struct Samples {
  std::vector<std::string> classes = {};
  std::vector<std::uint32_t> numbers = {};
  std::vector<float> values = {};
  std::size_t num_features = 0;

  [[nodiscard]] DesignMatrix<float> Matrix() const noexcept {
    return {values.data(), numbers.size(), num_features, num_features};
  }
};

Samples SamplesOf(const ViewCell& cell,
                  const ViewData& data,
                  const datasets::CloudFeatures& features) {
  Samples samples{.classes = data.classes, .num_features = features.num_features};
  const std::size_t limit = cell.settings.num_classes;
  if (limit > data.classes.size()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("cell {}: num_classes is {}, and there are {} classes",
                                       cell.id,
                                       limit,
                                       data.classes.size())});
  }
  if (limit > 0) samples.classes.resize(limit);
  const std::vector<std::uint32_t> numbers = LabelNumbers(data.labels, data.classes);
  for (std::size_t view = 0; view < numbers.size(); ++view) {
    if (numbers[view] >= samples.classes.size()) continue;
    samples.numbers.push_back(numbers[view]);
    const float* const row = features.values.data() + view * features.num_features;
    samples.values.insert(samples.values.end(), row, row + features.num_features);
  }
  return samples;
}

// Which classes of the machine are right for a class of the test views.
std::vector<bool> RightFor(const ViewStudy& study,
                           const std::string& name,
                           const std::vector<std::string>& classes) {
  const auto entry = study.associations.find(name);
  const std::vector<std::string> right =
      entry == study.associations.end() ? std::vector<std::string>{name} : entry->second;
  std::vector<bool> is_right(classes.size());
  for (const std::uint32_t number : LabelNumbers(right, classes)) is_right[number] = true;
  return is_right;
}

AnswerCounts NoAnswers(const ViewStudy& study,
                       const std::vector<std::string>& rows,
                       const std::vector<std::string>& columns) {
  AnswerCounts answers{
      .row_title = "object",
      .rows = rows,
      .columns = columns,
      .counts = std::vector(rows.size(), std::vector<std::size_t>(columns.size()))};
  for (const std::string& row : rows) answers.is_right.push_back(RightFor(study, row, columns));
  return answers;
}

model_io::SvmNames NamesOf(const Samples& samples) {
  model_io::SvmNames names{.columns = {}, .classes = samples.classes, .label_column = "class"};
  names.columns.reserve(samples.num_features);
  for (std::size_t i = 0; i < samples.num_features; ++i) names.columns.push_back(NumberToText(i));
  return names;
}

svm::Result Train(const Samples& samples, const svm::Options& options) {
  svm::Result result = svm::TrainSvm(samples.Matrix(), samples.numbers, options);
  if (result.summary.termination != svm::Termination::kConverged) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "no support vector machine: " + result.summary.message,
                 .remedy = "set standardize = \"yes\" or a smaller C"});
  }
  return result;
}

// What the runtime says of the rows.
std::vector<RowClass> Classify(const svm::Result& machine,
                               const Samples& samples,
                               const datasets::CloudFeatures& features) {
  const model_io::SvmNames names = NamesOf(samples);
  const LoadedModel model =
      LoadModel(model_io::Serialise(model_io::MakeSvmModel(machine.model, names, {})));
  datasets::Table table;
  table.columns = names.columns;
  table.values.assign(features.values.begin(), features.values.end());
  table.num_rows = features.num_views;
  return ClassifyTable(model.get(), table);
}

// Each view by machines that were trained without it.
AnswerCounts LeaveOneOut(const ViewStudy& study,
                         const Samples& samples,
                         const svm::Options& options,
                         std::vector<TimeFigure>& times) {
  const Clock::time_point start = Clock::now();
  const svm::Grid grid{.kernels = {options.kernel},
                       .degrees = {options.degree},
                       .gammas = {options.gamma},
                       .coef0s = {options.coef0},
                       .penalties = {options.penalty}};
  const svm::GridSearch search =
      svm::SearchGridOfRows(samples.Matrix(),
                            samples.numbers,
                            svm::LeaveOneOutFolds(samples.numbers.size()),
                            grid,
                            options);
  times.push_back({"leave_one_out_s", SecondsSince(start)});
  AnswerCounts answers = NoAnswers(study, samples.classes, samples.classes);
  const std::vector<std::uint32_t>& predicted = search.points.front().validation.predicted;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    ++answers.counts[samples.numbers[i]][predicted[i]];
  }
  return answers;
}

AnswerCounts ClassifyOthers(const ViewStudy& study,
                            const Samples& samples,
                            const svm::Result& machine,
                            const ViewData& test,
                            const datasets::CloudFeatures& features,
                            std::vector<TimeFigure>& times) {
  AnswerCounts answers = NoAnswers(study, test.classes, samples.classes);
  const std::vector<std::uint32_t> numbers = LabelNumbers(test.labels, test.classes);
  const Clock::time_point start = Clock::now();
  const std::vector<RowClass> said = Classify(machine, samples, features);
  times.push_back({"classify_ms", 1e3 * SecondsSince(start) / static_cast<double>(said.size())});
  for (std::size_t i = 0; i < said.size(); ++i) ++answers.counts[numbers[i]][said[i].number];
  return answers;
}

}  // namespace

const datasets::CloudFeatures& DescribedViews::Of(const std::string& name,
                                                  const ViewData& data,
                                                  const ViewSettings& settings,
                                                  int num_threads,
                                                  const Progress& progress) {
  const features::CloudDescriptor& descriptor = settings.descriptor;
  const std::string key = fmt::format("{} {} {} {} {} {}",
                                      name,
                                      features::NameOf(descriptor.type),
                                      descriptor.grid_size,
                                      features::NameOf(descriptor.scaling),
                                      features::NameOf(settings.cloud.frame),
                                      settings.cloud.outlier_step);
  const auto [entry, is_new] = features_.try_emplace(key);
  datasets::CloudFeatures& all = entry->second;
  if (!is_new) return all;
  all.num_features = descriptor.NumFeatures();
  for (const datasets::ViewSet& set : data.sets) {
    const datasets::CloudFeatures part =
        datasets::DescribeViews(set, descriptor, settings.cloud, num_threads, progress);
    all.values.insert(all.values.end(), part.values.begin(), part.values.end());
    all.num_views += part.num_views;
  }
  return all;
}

ViewCellResult TellClasses(const ViewStudy& study,
                           const ViewCell& cell,
                           const ViewData& train,
                           const ViewData* test,
                           DescribedViews& described,
                           int num_threads,
                           const Progress& progress) {
  svm::Options options = cell.settings.svm;
  options.num_threads = num_threads;
  options.progress = progress;
  const Samples samples =
      SamplesOf(cell, train, described.Of("train", train, cell.settings, num_threads, progress));
  ViewCellResult result{.id = cell.id, .answers = {}};
  if (test == nullptr) {
    result.answers = LeaveOneOut(study, samples, options, result.times);
  } else {
    const Clock::time_point start = Clock::now();
    const svm::Result machine = Train(samples, options);
    result.times.push_back({"training_s", SecondsSince(start)});
    result.answers =
        ClassifyOthers(study,
                       samples,
                       machine,
                       *test,
                       described.Of("test", *test, cell.settings, num_threads, progress),
                       result.times);
  }
  for (std::size_t row = 0; row < result.answers.rows.size(); ++row) {
    result.groups.push_back(ShareOfRow(result.answers, row));
  }
  result.groups.push_back(ShareOfAll("all", result.groups));
  return result;
}

}  // namespace handcraft::experiments
