// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/object_classes/object_class_training.h"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/datasets/some_object_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::TemporaryDirectory;
using handcraft::testing::WriteObjectViews;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ObjectClassOptions SmallOptions() {
  ObjectClassOptions options;
  options.descriptor.grid_size = 6;
  options.num_folds = 3;
  return options;
}

template <class T>
bool BeginsWith(const std::vector<T>& whole, const std::vector<T>& begin) {
  return whole.size() >= begin.size() && std::equal(begin.begin(), begin.end(), whole.begin());
}

// docs/model_format.md § 9: adding a class leaves every array the beginning of the new one.
void ExpectGrown(const model_io::SvmModel& grown, const model_io::SvmModel& old) {
  EXPECT_TRUE(BeginsWith(grown.support_vectors, old.support_vectors));
  EXPECT_TRUE(BeginsWith(grown.support_classes, old.support_classes));
  EXPECT_TRUE(BeginsWith(grown.machine_begins, old.machine_begins));
  EXPECT_TRUE(BeginsWith(grown.machine_supports, old.machine_supports));
  EXPECT_TRUE(BeginsWith(grown.dual_coefficients, old.dual_coefficients));
  EXPECT_TRUE(BeginsWith(grown.intercepts, old.intercepts));
}

TEST(ObjectClassTraining, TellsShapesApartThatItHasNotSeen) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = WriteObjectViews(folder / "set", {"ball", "ramp", "post"});
  const ObjectClassTraining training = TrainObjectClasses(set, SmallOptions());
  EXPECT_EQ(training.num_validated, 12U);
  EXPECT_GE(training.num_correct, 11U);
  EXPECT_THAT(training.model.classes, ElementsAre("ball", "ramp", "post"));
  EXPECT_EQ(training.model.svm.NumFeatures(), 108U);
  EXPECT_TRUE(training.model.svm.single_precision);
  EXPECT_EQ(training.summary.termination, svm::Termination::kConverged);
  EXPECT_GT(training.svm.gamma, 0.0);
}

TEST(ObjectClassTraining, IsTheSameOnTwoThreads) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = WriteObjectViews(folder / "set", {"ball", "ramp", "post"}, 4);
  ObjectClassOptions options = SmallOptions();
  const model_io::SvmModel one = TrainObjectClasses(set, options).model.svm;
  options.svm.num_threads = 2;
  const model_io::SvmModel two = TrainObjectClasses(set, options).model.svm;
  EXPECT_EQ(one.dual_coefficients, two.dual_coefficients);
  EXPECT_EQ(one.intercepts, two.intercepts);
  EXPECT_EQ(one.similarity.gamma, two.similarity.gamma);
}

TEST(ObjectClassTraining, SearchTakesTheMostCorrect) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = WriteObjectViews(folder / "set", {"ball", "ramp"}, 4);
  const ObjectClassTraining training = SearchObjectClasses(set, SmallOptions());
  EXPECT_EQ(training.tried.size(), 3U + 3 * 3 * 3 + 3 * 3);
  for (const TriedCombination& tried : training.tried) {
    EXPECT_LE(tried.num_correct, training.num_correct);
  }
  ObjectClassOptions options = SmallOptions();
  options.num_folds = 0;
  EXPECT_THROWS_MESSAGE(static_cast<void>(SearchObjectClasses(set, options)),
                        Error,
                        HasSubstr("at least 2 for a search"));
}

TEST(ObjectClassTraining, AClassIsAddedWithoutTouchingTheOthers) {
  const TemporaryDirectory folder;
  const datasets::ViewSet two = WriteObjectViews(folder / "two", {"ball", "ramp"});
  const datasets::ViewSet three = WriteObjectViews(folder / "three", {"ball", "ramp", "post"});
  const ObjectClassTraining old = TrainObjectClasses(two, SmallOptions());
  const ObjectClassTraining grown = AddObjectClass(old.model, three, "post");
  EXPECT_THAT(grown.model.classes, ElementsAre("ball", "ramp", "post"));
  EXPECT_EQ(grown.summary.num_machines, 2U);
  ExpectGrown(grown.model.svm, old.model.svm);
  // The pairs with the new class are those of training all three at once with the old kernel.
  ObjectClassOptions options = SmallOptions();
  options.svm.gamma = old.svm.gamma;
  const ObjectClassTraining all = TrainObjectClasses(three, options);
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_NEAR(grown.model.svm.intercepts[m], all.model.svm.intercepts[m], 1e-12);
  }
}

TEST(ObjectClassTraining, SupportVectorsStandForClassesWithoutViews) {
  const TemporaryDirectory folder;
  const datasets::ViewSet two = WriteObjectViews(folder / "two", {"ball", "ramp"});
  const datasets::ViewSet post = WriteObjectViews(folder / "post", {"post"});
  const ObjectClassTraining old = TrainObjectClasses(two, SmallOptions());
  const ObjectClassTraining grown = AddObjectClass(old.model, post, "post");
  ExpectGrown(grown.model.svm, old.model.svm);
  EXPECT_EQ(grown.model.svm.NumMachines(), 3U);
}

TEST(ObjectClassTraining, RefusesClassesThatAreKnownOrNotThere) {
  const TemporaryDirectory folder;
  const datasets::ViewSet two = WriteObjectViews(folder / "two", {"ball", "ramp"}, 3);
  const ObjectClassTraining old = TrainObjectClasses(two, SmallOptions());
  EXPECT_THROWS_MESSAGE(static_cast<void>(AddObjectClass(old.model, two, "ball")),
                        Error,
                        HasSubstr("the model knows the class 'ball' already"));
  EXPECT_THROWS_MESSAGE(static_cast<void>(AddObjectClass(old.model, two, "cup")),
                        Error,
                        HasSubstr("no view is of the class 'cup'; there are: ball, ramp"));
}

TEST(ObjectClassTraining, OptionsAreChecked) {
  const auto refused = [](auto change, const std::string& message) {
    ObjectClassOptions options;
    change(options);
    EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(ObjectClassOptions().Validate());
  refused([](auto& options) { options.descriptor.grid_size = 129; }, "grid_size is 129");
  refused(
      [](auto& options) {
        options.descriptor.type = features::CloudDescriptorType::kViewpointHistogram;
      },
      "the descriptor vfh needs the frame camera");
  refused([](auto& options) { options.num_folds = 1; }, "num_folds is 1");
  refused([](auto& options) { options.outlier_step = -1.0; }, "outlier_step");
  refused([](auto& options) { options.svm.penalty = 0.0; }, "svm::Options.penalty");
}

}  // namespace
}  // namespace handcraft::experiments
