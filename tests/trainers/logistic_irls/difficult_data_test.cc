// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Data on which a careless solver stops early, says the wrong thing or takes for ever.

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/trainers/logistic_irls/problem.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::logistic {
namespace {

// With and without a sketched first stage.
std::vector<Summary> BothWays(const Problem<double>& problem) {
  std::vector<Summary> summaries;
  for (const double share : {0.0, 0.1}) {
    summaries.push_back(
        TrainLogistic(problem.X(), problem.labels, {.warm_start_share = share}).summary);
  }
  return summaries;
}

// Two pairs of columns that agree but for `apart` of their spread: weights of 1/apart cancel, and
// the objective is known to fewer digits than it has.
TEST(DifficultData, NearlyCollinearColumnsConverge) {
  for (const std::size_t num_samples : {500U, 12000U}) {
    for (const double apart : {1e-3, 1e-5, 3e-6}) {
      for (const std::uint64_t seed : {1U, 2U, 3U}) {
        auto problem = DrawProblem<double>(num_samples, 10, seed);
        Rng rng(seed + 100);
        for (std::size_t i = 0; i < num_samples; ++i) {
          problem.At(i, 7) = problem.At(i, 2) + apart * rng.Normal();
          problem.At(i, 8) = problem.At(i, 3) - problem.At(i, 2) + apart * rng.Normal();
        }
        for (const Summary& summary : BothWays(problem)) {
          EXPECT_EQ(summary.termination, Termination::kConverged) << summary.message;
          EXPECT_LE(summary.gradient_norm, 1e-9);
          EXPECT_LT(summary.iterations, 15);
        }
      }
    }
  }
}

// A column taken for dependent is held at zero, and what is left of its gradient stops nothing.
TEST(DifficultData, ColumnsHeldAtZeroDoNotKeepTheOthersFromConverging) {
  auto problem = DrawProblem<double>(500, 4, 2);
  Rng rng(7);
  for (std::size_t i = 0; i < 500; ++i) {
    problem.At(i, 3) = problem.At(i, 2) + 5e-7 * rng.Normal();
  }
  for (const Summary& summary : BothWays(problem)) {
    EXPECT_EQ(summary.termination, Termination::kRankDeficient) << summary.message;
    EXPECT_EQ(summary.aliased_features, std::vector<std::size_t>{3});
    EXPECT_LE(summary.gradient_norm, 1e-9);
  }
}

// Whoever has a positive third feature is positive; the others are mixed.
TEST(DifficultData, QuasiSeparationByAContinuousFeatureIsSaid) {
  for (const std::size_t num_samples : {500U, 12000U}) {
    auto problem = DrawProblem<double>(num_samples, 6, 1);
    for (std::size_t i = 0; i < num_samples; ++i) {
      double& feature = problem.At(i, 3);
      feature = feature > 1.0 ? feature - 1.0 : 0.0;
      if (feature > 0.0) problem.labels[i] = 1;
    }
    for (const Summary& summary : BothWays(problem)) {
      EXPECT_EQ(summary.termination, Termination::kSeparated) << summary.message;
      EXPECT_TRUE(summary.message.starts_with("quasi-complete")) << summary.message;
    }
  }
}

TEST(DifficultData, HeavyTailsAndTwoPositivesConverge) {
  auto heavy = DrawProblem<double>(12000, 10, 1, 2.0);
  for (std::size_t i = 0; i < 12000; ++i) heavy.At(i, 0) *= 1e6;
  auto rare = DrawProblem<double>(12000, 10, 1);
  for (std::size_t i = 0; i < 12000; ++i) rare.labels[i] = i < 2 ? 1 : 0;
  for (const Problem<double>& problem : {heavy, rare}) {
    for (const Summary& summary : BothWays(problem)) {
      EXPECT_EQ(summary.termination, Termination::kConverged) << summary.message;
      EXPECT_LE(summary.gradient_norm, 1e-12);
    }
  }
}

}  // namespace
}  // namespace handcraft::logistic
