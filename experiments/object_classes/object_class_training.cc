// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/object_classes/object_class_training.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "datasets/object_clouds.h"
#include "datasets/view_folds.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/gram_matrix.h"
#include "trainers/svm/margins.h"

namespace handcraft::experiments {
namespace {

using features::SimilarityType;

// The features of a set's views and what all machines share.
struct Described {
  datasets::CloudFeatures features;
  datasets::ViewClasses classes;  // of the views, then of their copies
  std::size_t num_views = 0;
  svm::Samples samples;
  svm::SampleMatrix inner_products;

  // 1 / the mean squared length of the samples: kernels of the same numbers do for features of any
  // size.
  [[nodiscard]] double NaturalGamma() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < inner_products.size; ++i) sum += inner_products.Row(i)[i];
    return sum > 0.0 ? static_cast<double>(inner_products.size) / sum : 1.0;
  }
};

// The same numbers for the copies of the views.
void Repeat(int num_copies, std::vector<std::uint32_t>& numbers) {
  const std::vector<std::uint32_t> once = numbers;
  for (int copy = 0; copy < num_copies; ++copy) {
    numbers.insert(numbers.end(), once.begin(), once.end());
  }
}

// Views, then moved copies of them.
datasets::CloudFeatures DescribeAll(const datasets::ViewSet& set,
                                    const features::CloudDescriptor& descriptor,
                                    double outlier_step,
                                    const ObjectClassOptions& options) {
  const datasets::ObjectCloudOptions clouds{.frame = descriptor.frame,
                                            .outlier_step = outlier_step};
  const int num_threads = options.svm.num_threads;
  const Progress& progress = options.svm.progress;
  datasets::CloudFeatures all =
      datasets::DescribeViews(set, descriptor, clouds, num_threads, progress);
  if (options.moved.num_copies == 0) return all;
  const datasets::CloudFeatures copies =
      datasets::DescribeMovedCopies(set, descriptor, clouds, options.moved, num_threads, progress);
  all.values.insert(all.values.end(), copies.values.begin(), copies.values.end());
  all.num_views += copies.num_views;
  return all;
}

Described Describe(const datasets::ViewSet& set, const ObjectClassOptions& options) {
  Described described{
      .features = DescribeAll(set, options.descriptor, options.outlier_step, options),
      .classes = datasets::ClassesOf(set),
      .num_views = set.items.size(),
      .samples = {},
      .inner_products = {}};
  Repeat(options.moved.num_copies, described.classes.values);
  const DesignMatrix<float> X = described.features.Matrix();
  described.samples =
      svm::PrepareSamples(X,
                          described.classes.values,
                          options.svm.standardize ? svm::FitNormaliser(X) : svm::Normaliser{});
  described.inner_products =
      svm::ComputeInnerProducts(described.samples, options.svm.num_threads, options.svm.progress);
  return described;
}

ObjectClassTraining Finish(const Described& described,
                           const ObjectClassOptions& options,
                           const svm::Options& svm) {
  svm::Result result = svm::TrainSvm(described.features.Matrix(), described.classes.values, svm);
  return {.model = {.descriptor = options.descriptor,
                    .outlier_step = options.outlier_step,
                    .svm = std::move(result.model),
                    .classes = described.classes.names},
          .classes = described.classes.values,
          .svm = svm,
          .summary = std::move(result.summary)};
}

std::vector<std::uint32_t> FoldsOf(const datasets::ViewSet& set,
                                   const ObjectClassOptions& options) {
  std::vector<std::uint32_t> folds = options.num_folds == kLeaveOneOut
                                         ? svm::LeaveOneOutFolds(set.items.size())
                                         : datasets::GroupedFolds(set, options.num_folds);
  Repeat(options.moved.num_copies, folds);
  return folds;
}

// Views, not copies, that were told right.
std::size_t NumCorrect(std::size_t num_views,
                       const std::vector<std::uint32_t>& classes,
                       const svm::CrossValidation& validation) {
  std::size_t num_correct = 0;
  for (std::size_t i = 0; i < num_views; ++i) {
    num_correct += validation.predicted[i] == classes[i] ? 1 : 0;
  }
  return num_correct;
}

// Of the views alone, not of their copies.
void TakeValidation(std::size_t num_views,
                    svm::CrossValidation validation,
                    ObjectClassTraining& training) {
  training.num_validated = num_views;
  training.num_correct = NumCorrect(num_views, training.classes, validation);
  training.predicted = std::move(validation.predicted);
  training.predicted.resize(num_views);
  training.margins = std::move(validation.margins);
  training.margins.resize(num_views);
}

svm::Grid SearchedGrid(double natural_gamma) {
  return {.kernels = {SimilarityType::kLinear, SimilarityType::kPolynomial, SimilarityType::kRbf},
          .degrees = {2, 3, 5},
          .gammas = {natural_gamma / 3.0, natural_gamma, natural_gamma * 3.0},
          .coef0s = {1.0},
          .penalties = {1.0, 10.0, 100.0}};
}

void RequireNew(const model_io::ObjectClassModel& model, std::string_view new_class) {
  const auto known = std::find(model.classes.begin(), model.classes.end(), new_class);
  if (known == model.classes.end()) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = "the model knows the class '" + std::string(new_class) + "' already",
               .remedy = "train it again with all views"});
}

// The views of the new class and of those the model knows.
datasets::ViewSet ViewsOf(const datasets::ViewSet& set,
                          const std::vector<std::string>& classes,
                          std::string_view new_class) {
  datasets::ViewSet views{.root = set.root, .items = {}};
  std::size_t num_new = 0;
  for (const datasets::ObjectView& view : set.items) {
    const bool is_known =
        std::find(classes.begin(), classes.end(), view.object_class) != classes.end();
    const bool is_new = view.object_class == new_class;
    if (is_known || is_new) views.items.push_back(view);
    num_new += is_new ? 1 : 0;
  }
  if (num_new > 0) return views;
  std::string list;
  for (const std::string& name : datasets::ClassesOf(set).names) {
    list += list.empty() ? "" : ", ";
    list += name;
  }
  throw Error(
      {.path = set.root.string(),
       .reason = "no view is of the class '" + std::string(new_class) + "'; there are: " + list});
}

bool HasAll(const std::vector<std::uint32_t>& classes, std::size_t num_classes) {
  return std::set<std::uint32_t>(classes.begin(), classes.end()).size() == num_classes;
}

// Rows of the classes that have no views: the model's support vectors, as raw numbers.
void AddSupportVectors(const model_io::SvmModel& svm,
                       datasets::CloudFeatures& features,
                       std::vector<std::uint32_t>& classes) {
  std::vector<bool> has_views(svm.num_classes + 1, false);
  for (const std::uint32_t c : classes) has_views[c] = true;
  const std::size_t p = svm.NumFeatures();
  for (std::size_t v = 0; v < svm.NumSupportVectors(); ++v) {
    const auto c = static_cast<std::uint32_t>(svm.support_classes[v]);
    if (has_views[c]) continue;
    for (std::size_t j = 0; j < p; ++j) {
      features.values.push_back(static_cast<float>(
          svm.support_vectors[v * p + j] * svm.feature_scale[j] + svm.feature_mean[j]));
    }
    classes.push_back(c);
    ++features.num_views;
  }
}

}  // namespace

ObjectClassOptions::ObjectClassOptions() {
  svm.degree = 2;
  svm.coef0 = 1.0;
  svm.penalty = 100.0;
}

void ObjectClassOptions::Validate() const {
  RequireOption(descriptor.grid_size >= 1 && descriptor.grid_size <= features::kMaxGridSize,
                "ObjectClassOptions.descriptor.grid_size",
                descriptor.grid_size,
                "from 1 to 128");
  if (!descriptor.FrameFits()) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = "the descriptor vfh needs the frame camera: it asks where the camera is"});
  }
  RequireOption(num_folds == kLeaveOneOut || num_folds == 0 || num_folds >= 2,
                "ObjectClassOptions.num_folds",
                num_folds,
                "0 for none, -1 for each view on its own, or at least 2");
  datasets::ObjectCloudOptions{.outlier_step = outlier_step}.Validate();
  moved.Validate();
  svm.Validate();
}

ObjectClassTraining TrainObjectClasses(const datasets::ViewSet& set,
                                       const ObjectClassOptions& options) {
  options.Validate();
  const Described described = Describe(set, options);
  svm::Options svm = options.svm;
  if (svm.gamma == 0.0) svm.gamma = described.NaturalGamma();
  ObjectClassTraining training = Finish(described, options, svm);
  if (options.num_folds == 0) return training;
  const svm::SampleMatrix gram = svm::ComputeGram(described.inner_products,
                                                  svm.SimilarityFor(described.samples.num_features),
                                                  described.samples,
                                                  svm.num_threads);
  TakeValidation(described.num_views,
                 svm::CrossValidate(gram, described.samples, FoldsOf(set, options), svm),
                 training);
  return training;
}

ObjectClassTraining SearchObjectClasses(const datasets::ViewSet& set,
                                        const ObjectClassOptions& options) {
  options.Validate();
  RequireOption(
      options.num_folds >= 2, "the number of folds", options.num_folds, "at least 2 for a search");
  const Described described = Describe(set, options);
  const svm::GridSearch search = svm::SearchGrid(described.inner_products,
                                                 described.samples,
                                                 FoldsOf(set, options),
                                                 SearchedGrid(described.NaturalGamma()),
                                                 options.svm);
  const svm::GridPoint& best = search.points[search.best];
  ObjectClassTraining training = Finish(described, options, best.options);
  TakeValidation(described.num_views, best.validation, training);
  for (const svm::GridPoint& point : search.points) {
    training.tried.push_back(
        {.kernel = std::string(features::NameOf(point.options.kernel)),
         .degree = point.options.degree,
         .gamma = point.options.gamma,
         .coef0 = point.options.coef0,
         .penalty = point.options.penalty,
         .num_correct = NumCorrect(described.num_views, training.classes, point.validation)});
  }
  return training;
}

ObjectClassTraining AddObjectClass(const model_io::ObjectClassModel& model,
                                   const datasets::ViewSet& set,
                                   std::string_view new_class,
                                   const ObjectClassOptions& options) {
  RequireNew(model, new_class);
  const datasets::ViewSet views = ViewsOf(set, model.classes, new_class);
  options.moved.Validate();
  datasets::CloudFeatures features =
      DescribeAll(views, model.descriptor, model.outlier_step, options);
  ObjectClassTraining training{.model = model, .svm = options.svm};
  training.model.classes.emplace_back(new_class);
  for (const datasets::ObjectView& view : views.items) {
    const auto found =
        std::find(training.model.classes.begin(), training.model.classes.end(), view.object_class);
    training.classes.push_back(static_cast<std::uint32_t>(found - training.model.classes.begin()));
  }
  Repeat(options.moved.num_copies, training.classes);
  if (options.num_folds != 0 && HasAll(training.classes, training.model.classes.size())) {
    TakeValidation(
        views.items.size(),
        svm::CrossValidateLike(
            model.svm, features.Matrix(), training.classes, FoldsOf(views, options), options.svm),
        training);
  }
  AddSupportVectors(model.svm, features, training.classes);
  svm::Result result = svm::AddClass(model.svm, features.Matrix(), training.classes, options.svm);
  training.model.svm = std::move(result.model);
  training.summary = std::move(result.summary);
  return training;
}

}  // namespace handcraft::experiments
