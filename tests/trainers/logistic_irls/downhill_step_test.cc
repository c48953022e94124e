// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/downhill_step.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/trainers/logistic_irls/problem.h"

namespace handcraft::logistic {
namespace {

const ColumnMoments kNoScaling{.mean = {0.0}, .scale = {1.0}};

TEST(StepDownhill, HalvesUntilTheObjectiveFalls) {
  const auto problem = ProblemOf({{-1, 0}, {-1, 1}, {1, 0}, {1, 1}, {1, 1}});
  const Objective objective(problem.X(), problem.labels, kNoScaling, 0.0, 1);
  Point point;
  Point trial;
  objective.Evaluate(Eigen::Vector2d::Zero(), point);
  const double before = point.value;
  int halvings = 0;
  ASSERT_TRUE(StepDownhill(objective, 64.0 * point.gradient, point, trial, halvings));
  EXPECT_LT(point.value, before);
  EXPECT_GE(halvings, 4);
  EXPECT_EQ(trial.value, before);
  EXPECT_EQ(trial.theta, Eigen::Vector2d::Zero());
}

TEST(StepDownhill, LeavesThePointWhenThereIsNoWayDown) {
  const auto problem = ProblemOf({{-1, 0}, {-1, 1}, {1, 0}, {1, 1}, {1, 1}});
  const Objective objective(problem.X(), problem.labels, kNoScaling, 0.0, 1);
  Point point;
  Point trial;
  objective.Evaluate(Eigen::Vector2d::Zero(), point);
  const Point before = point;
  int halvings = 0;
  EXPECT_FALSE(StepDownhill(objective, -point.gradient, point, trial, halvings));  // uphill
  EXPECT_EQ(point.theta, before.theta);
  EXPECT_EQ(point.value, before.value);
  EXPECT_EQ(halvings, 0);
}

// At ten times the Newton step the objective is hardly lower, which is no gain for its slope.
TEST(StepDownhill, WantsAGainInProportionToTheSlope) {
  const auto problem = ProblemOf({{-1, 0}, {-1, 1}, {1, 0}, {1, 1}, {1, 1}});
  const Objective objective(problem.X(), problem.labels, kNoScaling, 0.0, 1);
  Point from;
  objective.Evaluate(Eigen::Vector2d::Zero(), from);
  double share = 1.0;  // of the gradient, with just no gain: found by bisection
  for (double low = 0.5, high = 64.0; high - low > 1e-12;) {
    share = 0.5 * (low + high);
    Point to;
    objective.Evaluate(-share * from.gradient, to);
    (to.value < from.value ? low : high) = share;
  }
  Point point = from;
  Point trial;
  int halvings = 0;
  ASSERT_TRUE(
      StepDownhill(objective, share * (1.0 - 1e-6) * from.gradient, point, trial, halvings));
  EXPECT_EQ(halvings, 1);
}

// So near the optimum that the objective is the same to its last digits, the slope must shrink.
TEST(StepDownhill, LetsTheGradientDecideWithinRounding) {
  const auto problem = ProblemOf({{-1, 0}, {-1, 1}, {1, 0}, {1, 1}, {1, 1}});
  const Objective objective(problem.X(), problem.labels, kNoScaling, 0.0, 1);
  const double half = 0.5 * std::log(2.0);  // log odds 0 at −1 and ln 2 at 1
  Point point;
  Point trial;
  objective.Evaluate(Eigen::Vector2d(half + 1e-9, half), point);
  const Eigen::Vector2d step(1e-9, 0.0);
  int halvings = 0;
  ASSERT_TRUE(StepDownhill(objective, step, point, trial, halvings));
  EXPECT_EQ(halvings, 0);
  EXPECT_NEAR(point.theta[0], half, 1e-12);
  EXPECT_FALSE(StepDownhill(objective, -step, point, trial, halvings));  // now uphill
}

TEST(IsCompletelySeparated, IsAProofAndNeedsNoRidge) {
  const auto problem = ProblemOf({{-2, 0}, {-1, 0}, {1, 1}, {2, 1}});
  for (const double ridge : {0.0, 1.0}) {
    const Objective objective(problem.X(), problem.labels, kNoScaling, ridge, 1);
    Point point;
    objective.Evaluate(Eigen::Vector2d(1.0, 0.0), point);
    EXPECT_EQ(IsCompletelySeparated(objective, point), ridge == 0.0);
    objective.Evaluate(Eigen::Vector2d(1.0, 1.5), point);  // one sample on the wrong side
    EXPECT_FALSE(IsCompletelySeparated(objective, point));
    objective.Evaluate(Eigen::Vector2d::Zero(), point);
    EXPECT_FALSE(IsCompletelySeparated(objective, point));
  }
}

// Samples at 1 are all positive, those at 0 mixed: along (1, 0) nobody loses.
TEST(IsQuasiSeparated, SeesADirectionWithoutLosers) {
  const auto problem = ProblemOf({{0, 0}, {0, 1}, {1, 1}, {1, 1}});
  const Objective objective(problem.X(), problem.labels, kNoScaling, 0.0, 1);
  Point from;
  Point to;
  objective.Evaluate(Eigen::Vector2d(21.0, 0.0), from);
  objective.Evaluate(Eigen::Vector2d(22.0, 0.0), to);
  EXPECT_TRUE(IsQuasiSeparated(objective, from, to));
  EXPECT_FALSE(IsQuasiSeparated(objective, to, from));  // the other way all lose
  objective.Evaluate(Eigen::Vector2d(2.0, 0.0), from);
  objective.Evaluate(Eigen::Vector2d(3.0, 0.0), to);
  EXPECT_FALSE(IsQuasiSeparated(objective, from, to));  // the gradient has not vanished
}

}  // namespace
}  // namespace handcraft::logistic
