// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/sketched_descent.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trainers/logistic_irls/problem.h"
#include "trainers/logistic_irls/newton_descent.h"

namespace handcraft::logistic {
namespace {

constexpr Goal kGoal{.gradient_norm = 1e-9,
                     .relative_deviance = 1e-12,
                     .mean_square_change = 1e-15,
                     .max_iterations = 60};

struct Setting {
  explicit Setting(const Problem<float>& problem)
      : moments(ComputeColumnMoments(problem.X(), 1)),
        objective(problem.X(), problem.labels, moments, 0.0, 1),
        policy(objective, HessianPrecision::kAuto),
        sketched(objective, policy, problem.labels.size() / 10, 1) {
    const auto size = static_cast<Eigen::Index>(problem.num_features) + 1;
    objective.Evaluate(Eigen::VectorXd::Zero(size), point);
  }
  ColumnMoments moments;
  Objective objective;
  HessianPolicy policy;
  SketchedDescent sketched;
  Point point;
};

// Newton's method with whole Hessians is the oracle.
TEST(SketchedDescent, ReachesTheOptimumThatNewtonFinds) {
  for (const double tail : {0.0, 1.0}) {
    const auto problem = DrawProblem<float>(6000, 12, 1, tail);
    Setting setting(problem);
    Point expected = setting.point;
    HessianPolicy exact(setting.objective, HessianPrecision::kDouble);
    ASSERT_EQ(NewtonDescent(setting.objective, exact).Run(kGoal, expected).end,
              DescentEnd::kReached);
    setting.sketched.Start(setting.point);
    const DescentReport report = setting.sketched.Run(kGoal, setting.point);
    EXPECT_EQ(report.end, DescentEnd::kReached);
    EXPECT_LT(report.iterations, 30);
    EXPECT_LE(setting.objective.MovementBetween(expected, setting.point).largest, 1e-5);
  }
}

TEST(SketchedDescent, NeverRises) {
  const auto problem = DrawProblem<float>(3000, 8, 2, 1.5);
  double previous = 1e300;
  for (int steps = 1; steps <= 15; ++steps) {
    Setting setting(problem);
    setting.sketched.Start(setting.point);
    Goal goal = kGoal;
    goal.max_iterations = steps;
    static_cast<void>(setting.sketched.Run(goal, setting.point));
    EXPECT_LE(setting.point.value, previous * (1.0 + 1e-14)) << steps;
    previous = setting.point.value;
  }
}

TEST(SketchedDescent, FindsAliasedColumns) {
  auto problem = DrawProblem<float>(3000, 5, 3);
  for (std::size_t i = 0; i < 3000; ++i) problem.At(i, 3) = problem.At(i, 1);
  Setting setting(problem);
  setting.sketched.Start(setting.point);
  EXPECT_THAT(setting.policy.aliased(), ::testing::ElementsAre(3));
}

TEST(SketchedDescent, SuspectsQuasiCompleteSeparation) {
  auto problem = DrawProblem<float>(3000, 5, 5);
  for (std::size_t i = 0; i < 3000; ++i) {
    problem.At(i, 3) = problem.labels[i] == 1 && i % 10 == 0 ? 1.0F : 0.0F;
  }
  Setting setting(problem);
  setting.sketched.Start(setting.point);
  const Goal never{.mean_square_change = 1e-30, .max_iterations = 60};
  EXPECT_EQ(setting.sketched.Run(never, setting.point).end, DescentEnd::kQuasiSeparated);
}

TEST(SketchedDescent, ReportsCompleteSeparation) {
  auto problem = DrawProblem<float>(3000, 5, 4);
  for (std::size_t i = 0; i < 3000; ++i) problem.labels[i] = problem.At(i, 0) > 0.3F ? 1 : 0;
  Setting setting(problem);
  setting.sketched.Start(setting.point);
  EXPECT_EQ(setting.sketched.Run(kGoal, setting.point).end, DescentEnd::kCompletelySeparated);
}

}  // namespace
}  // namespace handcraft::logistic
