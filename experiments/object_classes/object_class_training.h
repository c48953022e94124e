// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/view_set.h"
#include "datasets/moved_objects.h"
#include "lib/core/progress.h"
#include "lib/features/cloud_descriptor.h"
#include "lib/model_io/object_class_models.h"
#include "trainers/svm/grid_search.h"
#include "trainers/svm/svm.h"

namespace handcraft::experiments {

inline constexpr int kLeaveOneOut = -1;

struct ObjectClassOptions {
  features::CloudDescriptor descriptor = {};
  double outlier_step = 1.5;  ///< datasets::ObjectCloudOptions
  svm::Options svm = {};      ///< a gamma of 0 is 1 / the mean squared length of the features
  datasets::MovedCopyOptions moved = {};  ///< copies of the views that are trained on besides
  /// Of cross-validation (datasets::GroupedFolds); 0: none; kLeaveOneOut: each view on its own.
  int num_folds = 12;

  /// Degree 2 with the constant 1, C = 100.
  ObjectClassOptions();

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("descriptor", features::NameOf(descriptor.type));
    visit("grid_size", descriptor.grid_size);
    visit("scaling", features::NameOf(descriptor.scaling));
    visit("frame", features::NameOf(descriptor.frame));
    visit("box", features::NameOf(descriptor.box));
    visit("outlier_step", outlier_step);
    visit("moved_copies", moved.num_copies);
    visit("seed", moved.seed);
    visit("num_folds", num_folds);
    svm.VisitFields(visit);
  }
};

/// A combination of a search, and how many views it told right that it had not seen.
struct TriedCombination {
  std::string kernel;
  int degree = 0;
  double gamma = 0.0;
  double coef0 = 0.0;
  double penalty = 0.0;
  std::size_t num_correct = 0;
};

struct ObjectClassTraining {
  model_io::ObjectClassModel model;
  std::vector<std::uint32_t> classes = {};  ///< of each row trained on, a number of model.classes
  svm::Options svm = {};                    ///< as it was trained, gamma filled in
  svm::Summary summary = {};
  std::size_t num_validated = 0;  ///< views; 0 without cross-validation
  std::size_t num_correct = 0;    ///< of those
  /// What machines that were trained without a view's fold say of it; none without folds.
  std::vector<std::uint32_t> predicted = {};
  std::vector<double> margins = {};          ///< of those predictions (features::ClassVote)
  std::vector<TriedCombination> tried = {};  ///< of a search
};

/// Describes the views of a set and trains machines of all its classes; the number of threads
/// changes no bit. Copies of a view are left out with it, and are not counted as validated. Throws
/// Error as datasets::DescribeViews, GroupedFolds and svm::TrainSvm do.
[[nodiscard]] ObjectClassTraining TrainObjectClasses(const datasets::ViewSet& set,
                                                     const ObjectClassOptions& options = {});

/// The same with kernel, degree, gamma and C found by cross-validation: linear; polynomials of
/// degree 2, 3 and 5; rbf; γ of ⅓, 1 and 3 over the mean squared length, C of 1, 10 and 100.
[[nodiscard]] ObjectClassTraining SearchObjectClasses(const datasets::ViewSet& set,
                                                      const ObjectClassOptions& options = {});

/// Adds one class to a model by training its pairs alone (svm::AddClass). The set holds views of
/// the new class; of an old class its views are used where it has some, else the model's support
/// vectors. With folds and views of every class all machines are cross-validated as the model's
/// were trained, its own arrays untouched. A rejection threshold is dropped. Of `options` the
/// solver's, the copies and the folds are read. Throws Error(kUsage) when the model knows the
/// class, Error(kBadInput) when the set has no view of it.
[[nodiscard]] ObjectClassTraining AddObjectClass(const model_io::ObjectClassModel& model,
                                                 const datasets::ViewSet& set,
                                                 std::string_view new_class,
                                                 const ObjectClassOptions& options = {});

}  // namespace handcraft::experiments
