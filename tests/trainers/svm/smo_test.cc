// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/smo.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/svm/drawn_classes.h"
#include "trainers/svm/gram_matrix.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;

struct Problem {
  SampleMatrix gram;
  std::vector<double> y;
};

Problem DrawProblem(std::size_t samples_per_class,
                    const features::Similarity& similarity,
                    std::uint64_t seed) {
  const auto drawn =
      DrawClasses<double>({.num_classes = 2, .samples_per_class = samples_per_class}, seed);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  Problem problem{.gram = ComputeGram(ComputeInnerProducts(samples, 1), similarity, samples, 1),
                  .y = {}};
  for (std::size_t i = 0; i < samples.NumSamples(); ++i) {
    problem.y.push_back(samples.ClassOf(i) == 0 ? 1.0 : -1.0);
  }
  return problem;
}

SmoResult Solve(const Problem& problem,
                const std::vector<double>& limits,
                const SmoOptions& options = {}) {
  return SolveDual(problem.gram.View(0, problem.y.size()), problem.y, limits, options);
}

// f(x_i) of every sample.
std::vector<double> DecisionValues(const Problem& problem, const SmoResult& result) {
  std::vector<double> values(problem.y.size(), result.intercept);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[i] += problem.gram.Row(i)[k] * result.coefficients[k];
    }
  }
  return values;
}

TEST(SolveDual, TwoPointsByHand) {
  const std::vector<double> kernel = {1.0, -1.0, -1.0, 1.0};  // x = 1 and −1
  const std::vector<double> y = {1.0, -1.0};
  const std::vector<double> limits = {10.0, 10.0};
  const SmoResult result = SolveDual({kernel.data(), 2, 2}, y, limits);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 1U);
  EXPECT_EQ(result.coefficients, (std::vector<double>{0.5, -0.5}));  // f(x) = x
  EXPECT_EQ(result.intercept, 0.0);
  EXPECT_EQ(result.objective, 0.5);
}

TEST(SolveDual, TwoPointsAtTheirLimits) {
  const std::vector<double> kernel = {1.0, -1.0, -1.0, 1.0};
  const std::vector<double> y = {1.0, -1.0};
  const std::vector<double> limits = {0.25, 0.25};
  const SmoResult result = SolveDual({kernel.data(), 2, 2}, y, limits);
  EXPECT_EQ(result.coefficients, (std::vector<double>{0.25, -0.25}));
  EXPECT_EQ(result.intercept, 0.0);  // the middle of −0.5 and 0.5
}

TEST(SolveDual, ThreePointsOnALineByHand) {
  // x = 0, 2 (positive) and 3 (negative): the margin lies between 2 and 3, f(x) = 5 − 2x.
  const std::vector<double> kernel = {0, 0, 0, 0, 4, 6, 0, 6, 9};
  const std::vector<double> y = {1.0, 1.0, -1.0};
  const std::vector<double> limits(3, 100.0);
  const SmoResult result = SolveDual({kernel.data(), 3, 3}, y, limits, {.tolerance = 1e-12});
  EXPECT_EQ(result.coefficients[0], 0.0);
  EXPECT_NEAR(result.coefficients[1], 2.0, 1e-12);
  EXPECT_NEAR(result.coefficients[2], -2.0, 1e-12);
  EXPECT_NEAR(result.intercept, 5.0, 1e-11);
}

TEST(SolveDual, KeepsTheConditionsOfKarushKuhnAndTuckerAndClosesTheGap) {
  const features::Similarity kernels[] = {
      {.type = features::SimilarityType::kLinear},
      {.type = features::SimilarityType::kPolynomial, .degree = 3, .gamma = 0.2, .coef0 = 1.0},
      {.type = features::SimilarityType::kRbf, .gamma = 0.5}};
  std::uint64_t seed = 1;
  for (const features::Similarity& kernel : kernels) {
    for (const double penalty : {0.1, 1.0, 100.0}) {
      const Problem problem = DrawProblem(20, kernel, seed++);
      const std::vector<double> limits(problem.y.size(), penalty);
      const double tolerance = 1e-6;
      const SmoResult result = Solve(problem, limits, {.tolerance = tolerance});
      ASSERT_TRUE(result.converged);
      const std::vector<double> values = DecisionValues(problem, result);
      double sum = 0.0;
      double primal = 0.0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double alpha = problem.y[i] * result.coefficients[i];
        const double margin = problem.y[i] * values[i];
        EXPECT_GE(alpha, 0.0);
        EXPECT_LE(alpha, penalty);
        EXPECT_TRUE(alpha == penalty || margin >= 1.0 - 2.0 * tolerance) << alpha << ' ' << margin;
        EXPECT_TRUE(alpha == 0.0 || margin <= 1.0 + 2.0 * tolerance) << alpha << ' ' << margin;
        sum += result.coefficients[i];
        primal += penalty * std::max(0.0, 1.0 - margin) +
                  0.5 * result.coefficients[i] * (values[i] - result.intercept);
      }
      EXPECT_NEAR(sum, 0.0, 1e-11 * penalty);
      // Every sample adds at most its limit times its violation to the duality gap.
      EXPECT_NEAR(primal, result.objective, 2.0 * tolerance * penalty * 40.0);
      EXPECT_GE(primal, result.objective - 1e-9 * penalty);
    }
  }
}

TEST(SolveDual, ASampleWithoutALimitChangesNoBitOfTheOthers) {
  const features::Similarity rbf{.type = features::SimilarityType::kRbf, .gamma = 0.5};
  const Problem problem = DrawProblem(15, rbf, 21);
  const std::size_t n = problem.y.size();
  for (std::size_t out = 0; out < n; out += 7) {
    std::vector<double> limits(n, 1.0);
    limits[out] = 0.0;
    const SmoResult with = Solve(problem, limits);
    Problem smaller;
    smaller.gram.size = n - 1;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == out) continue;
      smaller.y.push_back(problem.y[i]);
      for (std::size_t k = 0; k < n; ++k) {
        if (k != out) smaller.gram.values.push_back(problem.gram.Row(i)[k]);
      }
    }
    const SmoResult without = Solve(smaller, std::vector<double>(n - 1, 1.0));
    std::vector<double> coefficients = with.coefficients;
    EXPECT_EQ(coefficients[out], 0.0);
    coefficients.erase(coefficients.begin() + static_cast<std::ptrdiff_t>(out));
    EXPECT_EQ(coefficients, without.coefficients);
    EXPECT_EQ(with.intercept, without.intercept);
    EXPECT_EQ(with.iterations, without.iterations);
  }
}

TEST(SolveDual, OppositeLabelsOnOneSample) {
  const std::vector<double> kernel(4, 1.0);
  const std::vector<double> y = {1.0, -1.0};
  const std::vector<double> limits = {3.0, 3.0};
  const SmoResult result = SolveDual({kernel.data(), 2, 2}, y, limits);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.coefficients, (std::vector<double>{3.0, -3.0}));
}

TEST(SolveDual, OneClassAloneStaysAtZero) {
  const std::vector<double> kernel = {1.0, 0.5, 0.5, 1.0};
  const std::vector<double> y = {1.0, 1.0};
  const std::vector<double> limits = {1.0, 1.0};
  const SmoResult result = SolveDual({kernel.data(), 2, 2}, y, limits);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.coefficients, (std::vector<double>{0.0, 0.0}));
}

TEST(SolveDual, SaysThatTheIterationsWereNotEnough) {
  const features::Similarity linear{.type = features::SimilarityType::kLinear};
  const Problem problem = DrawProblem(20, linear, 5);
  const SmoResult result =
      Solve(problem, std::vector<double>(40, 10.0), {.tolerance = 1e-3, .max_iterations = 3});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 3U);
  EXPECT_GT(result.violation, 1e-3);
}

TEST(SolveDual, RefusesOptionsAndSizes) {
  const std::vector<double> kernel = {1.0};
  const std::vector<double> one = {1.0};
  const std::vector<double> two = {1.0, 1.0};
  EXPECT_THROWS_MESSAGE((SolveDual({kernel.data(), 1, 1}, one, one, {.tolerance = 0.0})),
                        Error,
                        HasSubstr("svm::SmoOptions.tolerance is 0; it must be in (0, 1]"));
  EXPECT_THROWS_MESSAGE((SolveDual({kernel.data(), 1, 1}, one, one, {.max_iterations = 0})),
                        Error,
                        HasSubstr("svm::SmoOptions.max_iterations is 0; it must be at least 1"));
  EXPECT_THROW(static_cast<void>(SolveDual({kernel.data(), 1, 1}, two, two)), std::logic_error);
}

}  // namespace
}  // namespace handcraft::svm
