// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/cross_validation.h"

#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/svm/drawn_classes.h"
#include "trainers/svm/machine.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;

using features::ClassScheme;

SampleMatrix GramOf(const Samples& samples, const Options& options) {
  return ComputeGram(
      ComputeInnerProducts(samples, 1), options.SimilarityFor(samples.num_features), samples, 1);
}

// Trains on all rows but those of the fold, afresh from X, and says what a model's machines do on
// the others.
void ExpectTrainedAfresh(const DrawnClasses<double>& drawn,
                         const std::vector<std::uint32_t>& folds,
                         const Options& options) {
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const CrossValidation validation =
      CrossValidate(GramOf(samples, options), samples, folds, options);
  for (std::size_t row = 0; row < folds.size(); row += 5) {
    DrawnClasses<double> kept{.values = {}, .classes = {}, .num_features = drawn.num_features};
    for (std::size_t i = 0; i < folds.size(); ++i) {
      if (folds[i] == folds[row]) continue;
      kept.classes.push_back(drawn.classes[i]);
      const double* values = drawn.Matrix().Row(i);
      kept.values.insert(kept.values.end(), values, values + drawn.num_features);
    }
    const model_io::SvmModel model = TrainSvm(kept.Matrix(), kept.classes, options).model;
    // The sample itself by definition, not by library code.
    std::vector<double> decisions(model.intercepts);
    const double* x = drawn.Matrix().Row(row);
    for (std::size_t m = 0; m < decisions.size(); ++m) {
      for (std::int32_t k = model.machine_begins[m]; k < model.machine_begins[m + 1]; ++k) {
        const auto v =
            static_cast<std::size_t>(model.machine_supports[static_cast<std::size_t>(k)]);
        double inner = 0.0;
        double norm = 0.0;
        double support_norm = 0.0;
        for (std::size_t j = 0; j < drawn.num_features; ++j) {
          const double s = model.support_vectors[v * drawn.num_features + j];
          inner += x[j] * s;
          norm += x[j] * x[j];
          support_norm += s * s;
        }
        decisions[m] += model.dual_coefficients[static_cast<std::size_t>(k)] *
                        model.similarity(inner, norm, support_norm);
      }
    }
    std::vector<std::int32_t> votes(model.num_classes);
    const features::ClassVote vote = VoteForClass(options.scheme, decisions, votes);
    EXPECT_EQ(validation.predicted[row], vote.winner) << row;
    EXPECT_NEAR(validation.margins[row], vote.margin, 1e-10) << row;
  }
}

TEST(CrossValidate, LeaveOneOutIsTrainingEveryFoldAfresh) {
  const auto drawn = DrawClasses<double>({.num_classes = 4, .samples_per_class = 8}, 11);
  for (const features::SimilarityType kernel : {features::SimilarityType::kLinear,
                                                features::SimilarityType::kPolynomial,
                                                features::SimilarityType::kRbf}) {
    for (const ClassScheme scheme : {ClassScheme::kOneAgainstOne, ClassScheme::kOneAgainstAll}) {
      ExpectTrainedAfresh(
          drawn,
          LeaveOneOutFolds(drawn.classes.size()),
          {.kernel = kernel, .gamma = 0.5, .coef0 = 1.0, .penalty = 2.0, .scheme = scheme});
    }
  }
}

TEST(CrossValidate, GroupedFoldsAreTrainedAfresh) {
  const auto drawn = DrawClasses<double>({.num_classes = 3, .samples_per_class = 10}, 12);
  std::vector<std::uint32_t> folds;
  for (std::size_t i = 0; i < drawn.classes.size(); ++i) {
    folds.push_back(i < 12 ? 700U : static_cast<std::uint32_t>(i / 7));
  }
  ExpectTrainedAfresh(drawn, folds, {.gamma = 0.5, .coef0 = 1.0});
}

TEST(CrossValidate, TrainsOnlyWhatAFoldTouches) {
  const auto drawn = DrawClasses<double>({.num_classes = 4, .samples_per_class = 5}, 13);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const Options options{.kernel = features::SimilarityType::kLinear};
  const CrossValidation validation =
      CrossValidate(GramOf(samples, options), samples, LeaveOneOutFolds(20), options);
  EXPECT_EQ(validation.num_machines, 6U + 20U * 3U);
  EXPECT_TRUE(validation.converged);
  std::size_t num_correct = 0;
  for (std::size_t i = 0; i < 20; ++i) num_correct += validation.predicted[i] == drawn.classes[i];
  EXPECT_EQ(validation.num_correct, num_correct);
  EXPECT_EQ(validation.accuracy, static_cast<double>(num_correct) / 20.0);
}

TEST(CrossValidate, ThreadsChangeNoBit) {
  const auto drawn = DrawClasses<double>({.num_classes = 5, .samples_per_class = 6}, 14);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  Options options{.gamma = 0.4, .coef0 = 1.0};
  const SampleMatrix gram = GramOf(samples, options);
  const CrossValidation one = CrossValidate(gram, samples, LeaveOneOutFolds(30), options);
  options.num_threads = 3;
  const CrossValidation three = CrossValidate(gram, samples, LeaveOneOutFolds(30), options);
  EXPECT_EQ(one.predicted, three.predicted);
  EXPECT_EQ(one.margins, three.margins);
  EXPECT_EQ(one.iterations, three.iterations);
}

TEST(StratifiedFolds, HoldTheSameShareOfEveryClass) {
  const std::vector<std::uint32_t> classes = {0, 1, 0, 0, 1, 0, 0};
  EXPECT_EQ(StratifiedFolds(classes, 2), (std::vector<std::uint32_t>{0, 0, 1, 0, 1, 1, 0}));
  EXPECT_THROWS_MESSAGE(StratifiedFolds(classes, 3),
                        Error,
                        HasSubstr("the number of folds is 3; it must be from 2 to 2"));
  EXPECT_THROWS_MESSAGE(StratifiedFolds(classes, 1),
                        Error,
                        HasSubstr("the number of folds is 1; it must be from 2 to 2"));
}

TEST(CrossValidate, RefusesAFoldThatHoldsAWholeClass) {
  const auto drawn = DrawClasses<double>({.num_classes = 2, .samples_per_class = 2}, 15);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const std::vector<std::uint32_t> folds = {3, 4, 3, 5};
  const SampleMatrix gram = GramOf(samples, {});
  EXPECT_THROWS_MESSAGE((CrossValidate(gram, samples, folds, {})),
                        Error,
                        HasSubstr("fold 3 holds all 2 samples of class 0 (counted from 0)"));
}

}  // namespace
}  // namespace handcraft::svm
