// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/svm.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/svm/drawn_classes.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;

using features::ClassScheme;
using model_io::SvmModel;

template <class T>
bool Begins(const std::vector<T>& whole, const std::vector<T>& beginning) {
  return whole.size() >= beginning.size() &&
         std::equal(beginning.begin(), beginning.end(), whole.begin());
}

// The rows of the first `num_classes` classes.
template <class T>
DrawnClasses<T> FirstClasses(const DrawnClasses<T>& drawn, std::uint32_t num_classes) {
  DrawnClasses<T> some{.values = {}, .classes = {}, .num_features = drawn.num_features};
  for (std::size_t i = 0; i < drawn.classes.size(); ++i) {
    if (drawn.classes[i] >= num_classes) continue;
    some.classes.push_back(drawn.classes[i]);
    const T* row = drawn.Matrix().Row(i);
    some.values.insert(some.values.end(), row, row + drawn.num_features);
  }
  return some;
}

TEST(TrainSvm, TwoPointsByHand) {
  const std::vector<double> values = {-1.0, 1.0};
  const std::vector<std::uint32_t> classes = {1, 0};
  const Result result = TrainSvm(DesignMatrix<double>{values.data(), 2, 1, 1},
                                 classes,
                                 {.kernel = features::SimilarityType::kLinear});
  const SvmModel& model = result.model;
  EXPECT_EQ(model.support_vectors, (std::vector<double>{1.0, -1.0}));  // by class
  EXPECT_EQ(model.support_classes, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(model.machine_begins, (std::vector<std::int32_t>{0, 2}));
  EXPECT_EQ(model.machine_supports, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(model.dual_coefficients, (std::vector<double>{0.5, -0.5}));
  EXPECT_EQ(model.intercepts, (std::vector<double>{0.0}));
  EXPECT_EQ(model.num_classes, 2U);
  EXPECT_FALSE(model.single_precision);
  EXPECT_EQ(result.summary.termination, Termination::kConverged);
  EXPECT_EQ(result.summary.message, "converged in 1 iterations");
}

TEST(TrainSvm, StandardisesAndKeepsTheNormaliser) {
  const auto drawn = DrawClasses<float>({}, 41);
  const SvmModel model = TrainSvm(drawn.Matrix(), drawn.classes, {.standardize = true}).model;
  EXPECT_TRUE(model.single_precision);
  ASSERT_EQ(model.NumFeatures(), 5U);
  for (const double value : model.support_vectors) {
    EXPECT_EQ(value, static_cast<double>(static_cast<float>(value)));
  }
  EXPECT_NE(model.feature_mean[0], 0.0);
  const SvmModel plain = TrainSvm(drawn.Matrix(), drawn.classes, {}).model;
  EXPECT_EQ(plain.feature_mean, std::vector<double>(5, 0.0));
  EXPECT_EQ(plain.feature_scale, std::vector<double>(5, 1.0));
}

TEST(TrainSvm, GammaIsOneOverTheNumberOfFeatures) {
  const auto drawn = DrawClasses<double>({}, 42);
  EXPECT_EQ(TrainSvm(drawn.Matrix(), drawn.classes).model.similarity.gamma, 0.2);
}

TEST(TrainSvm, ThreadsChangeNoBit) {
  const auto drawn = DrawClasses<double>({.num_classes = 5, .samples_per_class = 9}, 43);
  for (const ClassScheme scheme : {ClassScheme::kOneAgainstOne, ClassScheme::kOneAgainstAll}) {
    const Result one = TrainSvm(drawn.Matrix(), drawn.classes, {.scheme = scheme});
    const Result three =
        TrainSvm(drawn.Matrix(), drawn.classes, {.scheme = scheme, .num_threads = 3});
    EXPECT_EQ(one.model.dual_coefficients, three.model.dual_coefficients);
    EXPECT_EQ(one.model.support_vectors, three.model.support_vectors);
    EXPECT_EQ(one.model.intercepts, three.model.intercepts);
    EXPECT_EQ(one.model.NumMachines(), scheme == ClassScheme::kOneAgainstOne ? 10U : 5U);
  }
}

TEST(AddClass, LeavesTheOldModelBitIdenticalAndTrainsTheNewPairsAlone) {
  const auto all = DrawClasses<float>({.num_classes = 5, .samples_per_class = 9}, 44);
  const auto four = FirstClasses(all, 4);
  const Options options{.coef0 = 1.0};
  const SvmModel old = TrainSvm(four.Matrix(), four.classes, options).model;
  const Result grown = AddClass(old, all.Matrix(), all.classes, options);
  const SvmModel& model = grown.model;
  EXPECT_EQ(grown.summary.num_machines, 4U);
  EXPECT_EQ(model.num_classes, 5U);
  EXPECT_EQ(model.NumMachines(), 10U);
  EXPECT_TRUE(Begins(model.support_vectors, old.support_vectors));
  EXPECT_TRUE(Begins(model.support_classes, old.support_classes));
  EXPECT_TRUE(Begins(model.machine_begins, old.machine_begins));
  EXPECT_TRUE(Begins(model.machine_supports, old.machine_supports));
  EXPECT_TRUE(Begins(model.dual_coefficients, old.dual_coefficients));
  EXPECT_TRUE(Begins(model.intercepts, old.intercepts));

  // The pairs are those of training from scratch, and no support vector is stored twice.
  const SvmModel scratch = TrainSvm(all.Matrix(), all.classes, options).model;
  EXPECT_EQ(model.intercepts, scratch.intercepts);
  EXPECT_EQ(model.NumSupportVectors(), scratch.NumSupportVectors());
  std::vector<double> coefficients = model.dual_coefficients;
  std::vector<double> expected = scratch.dual_coefficients;
  std::sort(coefficients.begin(), coefficients.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(coefficients, expected);
}

TEST(AddClass, RefusesWhatDoesNotFit) {
  const auto all = DrawClasses<double>({.num_classes = 4, .samples_per_class = 4}, 45);
  const auto three = FirstClasses(all, 3);
  const auto two = FirstClasses(all, 2);
  const SvmModel old = TrainSvm(two.Matrix(), two.classes).model;
  EXPECT_THROWS_MESSAGE(
      (AddClass(old, all.Matrix(), all.classes)),
      Error,
      HasSubstr("4 classes were given; the model's 2 and the new one were expected"));
  DesignMatrix<double> narrow = three.Matrix();
  narrow.num_features = 4;
  EXPECT_THROWS_MESSAGE((AddClass(old, narrow, three.classes)),
                        Error,
                        HasSubstr("the model has 5 features and the new samples 4"));
  const SvmModel against_all =
      TrainSvm(three.Matrix(), three.classes, {.scheme = ClassScheme::kOneAgainstAll}).model;
  EXPECT_THROWS_MESSAGE((AddClass(against_all, all.Matrix(), all.classes)),
                        Error,
                        HasSubstr("a class is added to a one-against-one model"));
}

TEST(TrainSvm, SaysThatTheIterationsWereNotEnough) {
  const auto drawn = DrawClasses<double>({.samples_per_class = 20, .spread = 2.0}, 46);
  const Summary summary =
      TrainSvm(drawn.Matrix(), drawn.classes, {.penalty = 100.0, .smo = {.max_iterations = 2}})
          .summary;
  EXPECT_EQ(summary.termination, Termination::kIterationLimit);
  EXPECT_EQ(summary.message.substr(0, 50), "3 of 3 machines did not converge in 2 iterations; ");
}

TEST(Options, NameWhatIsWrong) {
  EXPECT_THROWS_MESSAGE((Options{.degree = 0}.Validate()),
                        Error,
                        HasSubstr("svm::Options.degree is 0; it must be at least 1"));
  EXPECT_THROWS_MESSAGE((Options{.gamma = -1.0}.Validate()),
                        Error,
                        HasSubstr("svm::Options.gamma is -1; it must be above 0, or 0 for"));
  EXPECT_THROWS_MESSAGE((Options{.coef0 = -0.5}.Validate()),
                        Error,
                        HasSubstr("svm::Options.coef0 is -0.5; it must be at least 0"));
  EXPECT_THROWS_MESSAGE((Options{.penalty = 0.0}.Validate()),
                        Error,
                        HasSubstr("svm::Options.penalty is 0; it must be above 0"));
  EXPECT_THROWS_MESSAGE((Options{.num_threads = 0}.Validate()),
                        Error,
                        HasSubstr("svm::Options.num_threads is 0; it must be >= 1"));
}

TEST(Options, ListTheirFields) {
  const FieldTexts texts = FieldsToText(Options{}, "svm.");
  EXPECT_EQ(texts.at("svm.kernel"), "poly");
  EXPECT_EQ(texts.at("svm.scheme"), "one_against_one");
  EXPECT_EQ(texts.at("svm.tolerance"), "0.001");
}

TEST(Termination, HasNames) {
  EXPECT_EQ(NameOf(Termination::kNotRun), "not_run");
  EXPECT_EQ(NameOf(Termination::kConverged), "converged");
  EXPECT_EQ(NameOf(Termination::kIterationLimit), "iteration_limit");
}

}  // namespace
}  // namespace handcraft::svm
