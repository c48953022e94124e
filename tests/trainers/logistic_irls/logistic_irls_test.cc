// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/logistic_irls.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/matrix_matchers.h"
#include "tests/trainers/logistic_irls/problem.h"

namespace handcraft::logistic {
namespace {

using ::testing::AllOf;
using testing::AreClose;
using ::testing::HasSubstr;

template <class T>
Result Train(const Problem<T>& problem, const Options& options = {}) {
  return TrainLogistic(problem.X(), problem.labels, options);
}

template <class T>
double Score(const Result& result, const Problem<T>& problem, std::size_t i) {
  const T* row = problem.X().Row(i);
  return std::inner_product(result.weights.begin(), result.weights.end(), row, result.intercept);
}

// Wald's textbook table: a, b positive and negative at x = 1; c, d at x = 0. The weight is the log
// odds ratio log(ad/bc), its standard error √(1/a + 1/b + 1/c + 1/d).
TEST(TrainLogistic, TwoByTwoTableInClosedForm) {
  std::vector<std::vector<double>> rows;
  const auto add = [&](int count, double x, double label) {
    for (int i = 0; i < count; ++i) rows.push_back({x, label});
  };
  add(30, 1, 1);
  add(10, 1, 0);
  add(15, 0, 1);
  add(45, 0, 0);
  const Result result = Train(ProblemOf(rows));
  EXPECT_EQ(result.summary.termination, Termination::kConverged);
  EXPECT_NEAR(result.weights[0], std::log(30.0 * 45.0 / (10.0 * 15.0)), 2e-11);
  EXPECT_NEAR(result.intercept, std::log(15.0 / 45.0), 2e-11);
  EXPECT_NEAR(
      result.standard_errors[0], std::sqrt(1.0 / 30 + 1.0 / 10 + 1.0 / 15 + 1.0 / 45), 1e-8);
  EXPECT_NEAR(result.intercept_standard_error, std::sqrt(1.0 / 15 + 1.0 / 45), 1e-8);
  const double deviance = -2.0 * (30 * std::log(0.75) + 10 * std::log(0.25) + 15 * std::log(0.25) +
                                  45 * std::log(0.75));
  EXPECT_NEAR(result.summary.deviance, deviance, 1e-11);
  EXPECT_NEAR(
      result.summary.null_deviance, -2.0 * (45 * std::log(0.45) + 55 * std::log(0.55)), 1e-11);
  EXPECT_NEAR(result.summary.aic, deviance + 4.0, 1e-11);
  EXPECT_EQ(result.summary.rank, 2U);
  EXPECT_EQ(result.summary.num_samples, 100U);
  EXPECT_EQ(result.summary.num_positive, 45U);
}

// Wherever it begins it ends at the same optimum, at once when it begins there.
TEST(TrainLogistic, BeginsWhereItIsTold) {
  const auto problem = DrawProblem<float>(2000, 6, 5);
  for (const double ridge : {0.0, 3.0}) {
    const Result cold = Train(problem, {.ridge = ridge, .warm_start_share = 0.0});
    const Result warm = Train(problem,
                              {.ridge = ridge,
                               .warm_start_share = 0.0,
                               .initial_weights = cold.weights,
                               .initial_intercept = cold.intercept});
    EXPECT_EQ(warm.summary.termination, Termination::kConverged);
    EXPECT_LE(warm.summary.iterations, 1);
    EXPECT_TRUE(AreClose(warm.weights, cold.weights, 1e-10));
    EXPECT_NEAR(warm.summary.null_deviance, cold.summary.null_deviance, 1e-9);
    const Result far = Train(problem,
                             {.ridge = ridge,
                              .warm_start_share = 0.0,
                              .initial_weights = std::vector<double>(6, -2.0),
                              .initial_intercept = 3.0});
    EXPECT_TRUE(AreClose(far.weights, cold.weights, 1e-10));
  }
  EXPECT_THROW(Train(problem, {.initial_weights = {1.0}}), std::logic_error);
  EXPECT_THROW(Train(problem, {.initial_weights = std::vector<double>(6, std::nan(""))}),
               std::logic_error);
}

// At the optimum Σ (y − p) x = 0, feature by feature, and for the intercept; sketched stage and
// all.
TEST(TrainLogistic, SatisfiesTheScoreEquations) {
  for (const double tail : {0.0, 1.0}) {
    const auto problem = DrawProblem<float>(5000, 9, 1, tail);
    const Result result = Train(problem);
    ASSERT_EQ(result.summary.termination, Termination::kConverged);
    EXPECT_GT(result.summary.warm_start_iterations, 0);
    EXPECT_LE(result.summary.gradient_norm, 1e-9);
    std::vector<double> sums(10, 0.0);
    for (std::size_t i = 0; i < 5000; ++i) {
      const double residual =
          problem.labels[i] - 1.0 / (1.0 + std::exp(-Score(result, problem, i)));
      for (std::size_t j = 0; j < 9; ++j) {
        sums[j] += residual * static_cast<double>(problem.X().Row(i)[j]) / result.feature_scale[j];
      }
      sums[9] += residual;
    }
    for (const double sum : sums) EXPECT_NEAR(sum / 5000, 0.0, 1e-9);
  }
}

TEST(TrainLogistic, DoesNotDependOnTheOrderOfSamples) {
  const auto problem = DrawProblem<float>(4000, 6, 2);
  Problem<float> reversed{.num_features = 6};
  for (std::size_t i = 4000; i-- > 0;) {
    const float* row = problem.X().Row(i);
    reversed.values.insert(reversed.values.end(), row, row + 6);
    reversed.labels.push_back(problem.labels[i]);
  }
  const Result one = Train(problem);
  const Result other = Train(reversed);
  EXPECT_TRUE(AreClose(other.weights, one.weights, 1e-9));
  EXPECT_TRUE(AreClose(other.standard_errors, one.standard_errors, 1e-6));
}

TEST(TrainLogistic, ScalingAndShiftingAFeatureChangesNoPrediction) {
  const auto problem = DrawProblem<double>(800, 4, 3);
  auto changed = problem;
  for (std::size_t i = 0; i < 800; ++i) {
    changed.At(i, 0) *= 1e-12;
    changed.At(i, 1) *= -1e12;
    changed.At(i, 2) += 1e4;
  }
  const Result one = Train(problem);
  const Result other = Train(changed);
  EXPECT_NEAR(other.weights[0], one.weights[0] * 1e12, 1e3);
  for (std::size_t i = 0; i < 800; i += 50) {
    EXPECT_NEAR(Score(other, changed, i), Score(one, problem, i), 1e-7);
  }
  EXPECT_NEAR(other.summary.deviance, one.summary.deviance, 1e-9);
}

TEST(TrainLogistic, DevianceNeverRisesWithMoreIterations) {
  for (const double share : {0.0, 0.1}) {
    const auto problem = DrawProblem<float>(3000, 8, 4, 1.5);
    double previous = std::numeric_limits<double>::infinity();
    for (int steps = 1; steps <= 14; ++steps) {
      const Result result = Train(problem, {.max_iterations = steps, .warm_start_share = share});
      EXPECT_LE(result.summary.deviance, previous * (1.0 + 1e-14));
      EXPECT_LE(result.summary.iterations, steps);
      previous = result.summary.deviance;
    }
  }
}

TEST(TrainLogistic, FloatAndDoubleAndAnyNumberOfThreadsGiveTheSameBits) {
  const Result expected = Train(DrawProblem<double>(9000, 12, 5, 0.5));
  const auto problem = DrawProblem<float>(9000, 12, 5, 0.5);
  for (const int num_threads : {1, 2, 4}) {
    const Result result = Train(problem, {.num_threads = num_threads});
    EXPECT_EQ(result.weights, expected.weights);
    EXPECT_EQ(result.intercept, expected.intercept);
    EXPECT_EQ(result.standard_errors, expected.standard_errors);
    EXPECT_EQ(result.summary.deviance, expected.summary.deviance);
  }
}

TEST(TrainLogistic, EveryPathReachesTheSameOptimum) {
  const auto problem = DrawProblem<float>(6000, 10, 6, 0.8);
  const Result expected = Train(problem, {.warm_start_share = 0.0});
  EXPECT_EQ(expected.summary.warm_start_iterations, 0);
  for (const Options& options : {Options{.seed = 1},
                                 Options{.seed = 2},
                                 Options{.hessian_precision = HessianPrecision::kSingle},
                                 Options{.hessian_precision = HessianPrecision::kDouble},
                                 Options{.standard_errors = false}}) {
    const Result result = Train(problem, options);
    EXPECT_EQ(result.summary.termination, Termination::kConverged);
    EXPECT_TRUE(AreClose(result.weights, expected.weights, 1e-9));
    EXPECT_EQ(result.standard_errors.empty(), !options.standard_errors);
  }
}

TEST(TrainLogistic, FallsBackToDoubleWhenFeaturesAreNearlyCollinear) {
  auto problem = DrawProblem<double>(2000, 4, 7);
  EXPECT_FALSE(Train(problem).summary.fell_back_to_double);
  for (std::size_t i = 0; i < 2000; ++i) {
    problem.At(i, 1) = problem.At(i, 0) + 3e-5 * problem.At(i, 1);
  }
  const Result result = Train(problem);
  EXPECT_TRUE(result.summary.fell_back_to_double);
  EXPECT_EQ(result.summary.termination, Termination::kConverged);
  EXPECT_LT(result.summary.reciprocal_condition, 1e-8);
  EXPECT_TRUE(AreClose(Train(problem, {.warm_start_share = 0.0}).weights, result.weights, 1e-6));
}

TEST(TrainLogistic, RidgeSatisfiesItsKarushKuhnTuckerConditions) {
  auto problem = DrawProblem<double>(300, 5, 8);
  for (std::size_t i = 0; i < 300; ++i) {
    problem.At(i, 3) = 2.0;               // constant: weight 0, nothing aliased
    problem.At(i, 4) = problem.At(i, 0);  // a copy: the pair shares the weight
  }
  constexpr double kRidge = 7.0;
  const Result result = Train(problem, {.ridge = kRidge});
  EXPECT_EQ(result.summary.termination, Termination::kConverged);
  EXPECT_TRUE(result.summary.aliased_features.empty());
  EXPECT_EQ(result.weights[3], 0.0);
  EXPECT_NEAR(result.weights[4], result.weights[0], 1e-12);
  double intercept_condition = 0.0;
  std::vector<double> condition(5);
  for (std::size_t j = 0; j < 5; ++j) {
    condition[j] = kRidge * result.weights[j] * result.feature_scale[j];
  }
  for (std::size_t i = 0; i < 300; ++i) {
    const double residual = 1.0 / (1.0 + std::exp(-Score(result, problem, i))) - problem.labels[i];
    intercept_condition += residual;
    for (std::size_t j = 0; j < 5; ++j) {
      condition[j] +=
          residual * (problem.At(i, j) - result.feature_mean[j]) / result.feature_scale[j];
    }
  }
  EXPECT_NEAR(intercept_condition, 0.0, 1e-9);
  for (const double value : condition) EXPECT_NEAR(value, 0.0, 1e-9);
}

TEST(TrainLogistic, ReadsRowsThroughTheirStride) {
  const auto problem = DrawProblem<float>(500, 3, 9);
  std::vector<float> wide;
  for (std::size_t i = 0; i < 500; ++i) {
    const float* row = problem.X().Row(i);
    wide.insert(wide.end(), row, row + 3);
    wide.insert(wide.end(), 2, std::numeric_limits<float>::quiet_NaN());  // never read
  }
  const DesignMatrix<float> X{wide.data(), 500, 3, 5};
  EXPECT_EQ(TrainLogistic(X, problem.labels, {}).weights, Train(problem).weights);
}

TEST(TrainLogistic, ReportsProgressFromTheCallersThread) {
  std::size_t calls = 0;
  Options options;
  options.progress = [&](std::string_view stage, std::size_t, std::size_t) {
    EXPECT_EQ(stage, "logistic regression");
    ++calls;
  };
  static_cast<void>(Train(DrawProblem<float>(500, 3, 10), options));
  EXPECT_GT(calls, 0U);
}

TEST(TrainLogistic, RefusesEmptyInput) {
  const Problem<float> nothing{.num_features = 3};
  EXPECT_THROWS_MESSAGE(Train(nothing), Error, HasSubstr("0 samples, 3 features"));
  Problem<float> no_features;
  no_features.labels = {0, 1};
  EXPECT_THROWS_MESSAGE(Train(no_features), Error, HasSubstr("2 samples, 0 features"));
}

TEST(TrainLogistic, RefusesLabelsThatAreNotTwoClasses) {
  auto problem = DrawProblem<float>(10, 2, 11);
  problem.labels.assign(10, 1);
  EXPECT_THROWS_MESSAGE(Train(problem), Error, HasSubstr("all 10 labels are 1"));
  problem.labels.assign(10, 0);
  EXPECT_THROWS_MESSAGE(Train(problem), Error, HasSubstr("all 10 labels are 0"));
  problem.labels[7] = 2;
  EXPECT_THROWS_MESSAGE(Train(problem), Error, HasSubstr("label of row 7 (counted from 0) is 2"));
  const DesignMatrix<float> X = problem.X();
  problem.labels.pop_back();
  EXPECT_THROW(static_cast<void>(TrainLogistic(X, problem.labels, {})), std::logic_error);
}

TEST(TrainLogistic, NamesRowAndColumnOfANumberThatIsNotFinite) {
  auto problem = DrawProblem<double>(40, 3, 12);
  problem.At(31, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROWS_MESSAGE(
      Train(problem), Error, AllOf(HasSubstr("row 31, column 2"), HasSubstr("nan")));
  problem.At(31, 2) = -std::numeric_limits<double>::infinity();
  EXPECT_THROWS_MESSAGE(
      Train(problem), Error, AllOf(HasSubstr("row 31, column 2"), HasSubstr("-inf")));
}

TEST(TrainLogistic, ReportsCompleteSeparation) {
  auto problem = DrawProblem<float>(3000, 4, 13);
  for (std::size_t i = 0; i < 3000; ++i) {
    problem.labels[i] = problem.At(i, 0) - problem.At(i, 1) > 0.1F ? 1 : 0;
  }
  for (const double share : {0.0, 0.1}) {
    const Result result = Train(problem, {.warm_start_share = share});
    EXPECT_EQ(result.summary.termination, Termination::kSeparated);
    EXPECT_THAT(result.summary.message, HasSubstr("complete"));
    EXPECT_THAT(result.summary.advice, HasSubstr("ridge"));
    EXPECT_TRUE(result.standard_errors.empty());
    for (std::size_t i = 0; i < 3000; ++i) {
      EXPECT_EQ(Score(result, problem, i) > 0.0, problem.labels[i] == 1);  // the plane is returned
    }
  }
  EXPECT_EQ(Train(problem, {.ridge = 1e-3}).summary.termination, Termination::kConverged);
}

// A rare feature that is never seen with label 0.
TEST(TrainLogistic, ReportsQuasiCompleteSeparation) {
  auto problem = DrawProblem<float>(3000, 4, 14);
  for (std::size_t i = 0; i < 3000; ++i) {
    problem.At(i, 3) = problem.labels[i] == 1 && i % 10 == 0 ? 1.0F : 0.0F;
  }
  for (const double share : {0.0, 0.1}) {
    const Result result = Train(problem, {.warm_start_share = share});
    EXPECT_EQ(result.summary.termination, Termination::kSeparated);
    EXPECT_THAT(result.summary.message, HasSubstr("quasi-complete"));
    EXPECT_GT(result.weights[3], 10.0);
  }
  EXPECT_EQ(Train(problem, {.ridge = 1e-3}).summary.termination, Termination::kConverged);
}

TEST(TrainLogistic, MoreFeaturesThanSamplesAreSeparatedAndAliased) {
  const Result result = Train(DrawProblem<double>(8, 20, 15));
  EXPECT_EQ(result.summary.termination, Termination::kSeparated);
  EXPECT_EQ(result.summary.aliased_features.size(), 13U);  // 8 samples carry 7 and the intercept
  EXPECT_EQ(result.summary.rank, 8U);
}

TEST(TrainLogistic, AliasedFeaturesLeaveTheRestOptimal) {
  const auto problem = DrawProblem<double>(3000, 4, 16);
  Problem<double> wider{.num_features = 7};
  wider.labels = problem.labels;
  for (std::size_t i = 0; i < 3000; ++i) {
    const double* row = problem.X().Row(i);
    wider.values.insert(wider.values.end(),
                        {row[0], 3.25, row[1], row[0], row[2], row[3], row[1] - 2 * row[2]});
  }
  const Result expected = Train(problem);
  for (const double share : {0.0, 0.1}) {
    const Result result = Train(wider, {.warm_start_share = share});
    EXPECT_EQ(result.summary.termination, Termination::kRankDeficient);
    EXPECT_THAT(result.summary.aliased_features, ::testing::ElementsAre(1, 3, 6));
    EXPECT_THAT(result.summary.message, HasSubstr("3 of 7 features"));
    EXPECT_EQ(result.summary.rank, 5U);
    const std::vector<double>& w = result.weights;
    EXPECT_TRUE(AreClose(std::vector{w[0], w[2], w[4], w[5]}, expected.weights, 1e-9));
    EXPECT_EQ(std::vector({w[1], w[3], w[6]}), std::vector<double>(3, 0.0));
    EXPECT_TRUE(std::isnan(result.standard_errors[3]));
    EXPECT_NEAR(result.standard_errors[4], expected.standard_errors[2], 1e-8);
  }
}

TEST(TrainLogistic, StopsAtTheIterationLimit) {
  const Result result = Train(DrawProblem<double>(300, 4, 17), {.max_iterations = 1});
  EXPECT_EQ(result.summary.termination, Termination::kIterationLimit);
  EXPECT_EQ(result.summary.iterations, 1);
  EXPECT_THAT(result.summary.message, HasSubstr("not converged"));
  EXPECT_THAT(result.summary.advice, HasSubstr("raise max_iterations"));
  EXPECT_TRUE(result.standard_errors.empty());
}

TEST(Summary, IsBornAsNotRun) {
  const Summary summary;
  EXPECT_EQ(NameOf(summary.termination), "not_run");
  EXPECT_THAT(summary.message, HasSubstr("not called"));
}

TEST(Options, ValidateNamesFieldValueAndRule) {
  const auto message = [](const Options& options, const char* text) {
    EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr(text));
  };
  EXPECT_NO_THROW(Options{}.Validate());
  message({.ridge = -1.0}, "Options.ridge is -1; it must be a finite number >= 0");
  message({.ridge = std::numeric_limits<double>::infinity()}, "Options.ridge is inf");
  message({.max_iterations = 0}, "Options.max_iterations is 0; it must be >= 1");
  message({.gradient_tolerance = 0.0}, "Options.gradient_tolerance is 0; it must be > 0");
  message({.relative_deviance_tolerance = std::nan("")}, "relative_deviance_tolerance is nan");
  message({.warm_start_share = 1.0}, "Options.warm_start_share is 1; it must be in [0, 1)");
  message({.num_threads = 0}, "Options.num_threads is 0; it must be >= 1");
}

TEST(Options, ListTheFieldsThatShapeTheResult) {
  const FieldTexts texts = FieldsToText(Options{}, "training.");
  EXPECT_EQ(texts.at("training.ridge"), "0");
  EXPECT_EQ(texts.at("training.seed"), "1");
  EXPECT_EQ(texts.at("training.hessian_precision"), "auto");
  EXPECT_FALSE(texts.contains("training.num_threads"));
}

}  // namespace
}  // namespace handcraft::logistic
