// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/newton_descent.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/trainers/logistic_irls/problem.h"

namespace handcraft::logistic {
namespace {

constexpr Goal kGoal{.gradient_norm = 1e-9,
                     .relative_deviance = 1e-12,
                     .mean_square_change = 1e-25,
                     .max_iterations = 50};

struct Descent {
  Descent(const Problem<double>& problem, HessianPrecision precision, const Goal& goal)
      : moments(ComputeColumnMoments(problem.X(), 1)),
        objective(problem.X(), problem.labels, moments, 0.0, 1),
        policy(objective, precision),
        newton(objective, policy) {
    const auto size = static_cast<Eigen::Index>(problem.num_features) + 1;
    objective.Evaluate(Eigen::VectorXd::Zero(size), point);
    report = newton.Run(goal, point);
  }
  ColumnMoments moments;
  Objective objective;
  HessianPolicy policy;
  NewtonDescent newton;
  Point point;
  DescentReport report;
};

// A table of counts: the optimum reproduces the shares, log(1/3) and log 3.
TEST(NewtonDescent, FindsTheLogOddsOfATable) {
  const auto problem = ProblemOf({{0, 1}, {0, 0}, {0, 0}, {0, 0}, {1, 1}, {1, 1}, {1, 1}, {1, 0}});
  const Descent run(problem, HessianPrecision::kDouble, kGoal);
  EXPECT_EQ(run.report.end, DescentEnd::kReached);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(run.point.scores[i], (i < 4 ? -1 : 1) * std::log(3.0), 1e-12);
  }
}

TEST(NewtonDescent, ReachesTheSameOptimumInEveryPrecision) {
  const auto problem = DrawProblem<double>(2000, 8, 1);
  const Descent exact(problem, HessianPrecision::kDouble, kGoal);
  for (const auto precision : {HessianPrecision::kAuto, HessianPrecision::kSingle}) {
    const Descent run(problem, precision, kGoal);
    EXPECT_EQ(run.report.end, DescentEnd::kReached);
    EXPECT_LE((run.point.theta - exact.point.theta).norm(), 1e-10);
  }
}

TEST(NewtonDescent, NeverRises) {
  const auto problem = DrawProblem<double>(500, 6, 2, 1.5);
  double previous = 1e300;
  for (int steps = 1; steps <= 12; ++steps) {
    Goal goal = kGoal;
    goal.max_iterations = steps;
    const Descent run(problem, HessianPrecision::kDouble, goal);
    EXPECT_LE(run.point.value, previous * (1.0 + 1e-14)) << steps;
    previous = run.point.value;
  }
}

TEST(NewtonDescent, StopsAtTheIterationLimit) {
  Goal goal = kGoal;
  goal.max_iterations = 2;
  const Descent run(DrawProblem<double>(500, 6, 3), HessianPrecision::kDouble, goal);
  EXPECT_EQ(run.report.end, DescentEnd::kIterationLimit);
  EXPECT_EQ(run.report.iterations, 2);
}

TEST(NewtonDescent, KeepsAnExactFactorNearTheEndAndTakesANewOneOtherwise) {
  const auto problem = DrawProblem<double>(2000, 4, 4);
  Descent run(problem, HessianPrecision::kDouble, kGoal);
  const auto kept = run.newton.ExactFactor(run.point, 1.0);
  const auto fresh = run.newton.ExactFactor(run.point, 0.0);
  ASSERT_TRUE(kept && fresh);
  EXPECT_LE((kept->InverseDiagonal() - fresh->InverseDiagonal()).norm(),
            1e-2 * fresh->InverseDiagonal().norm());
  EXPECT_EQ(fresh->InverseDiagonal(), run.policy.Exact(run.point)->InverseDiagonal());
  EXPECT_GT(run.newton.reciprocal_condition(), 0.1);
}

TEST(NewtonDescent, ReportsSeparation) {
  EXPECT_EQ(Descent(ProblemOf({{-2, 0}, {-1, 0}, {1, 1}, {2, 1}}), HessianPrecision::kDouble, kGoal)
                .report.end,
            DescentEnd::kCompletelySeparated);
  EXPECT_EQ(Descent(ProblemOf({{0, 0}, {0, 1}, {1, 1}, {1, 1}}), HessianPrecision::kDouble, kGoal)
                .report.end,
            DescentEnd::kQuasiSeparated);
}

}  // namespace
}  // namespace handcraft::logistic
