// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/hessian_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trainers/logistic_irls/problem.h"

namespace handcraft::logistic {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A problem with its objective, at the null model. `closeness` < 1 makes feature 1 a copy of
// feature 0 up to that.
struct Setting {
  explicit Setting(double closeness, double ridge = 0.0) : problem(DrawProblem<double>(600, 3, 1)) {
    for (std::size_t i = 0; i < 600; ++i) {
      if (closeness < 1.0) problem.At(i, 1) = problem.At(i, 0) + closeness * problem.At(i, 1);
    }
    moments = ComputeColumnMoments(problem.X(), 1);
    objective.emplace(problem.X(), problem.labels, moments, ridge, 1);
    objective->Evaluate(Eigen::VectorXd::Zero(4), point);
  }
  Problem<double> problem;
  ColumnMoments moments;
  std::optional<Objective> objective;
  Point point;
};

TEST(HessianPolicy, AutoStaysInSinglePrecisionWhenWellConditioned) {
  const Setting setting(1.0);
  HessianPolicy policy(*setting.objective, HessianPrecision::kAuto);
  ASSERT_TRUE(policy.Start(setting.point));
  const auto factor = policy.ForStep(setting.point);
  ASSERT_TRUE(factor);
  EXPECT_FALSE(policy.UsesDouble());
  EXPECT_FALSE(policy.fell_back_to_double());
  // Single precision shows: not the bits of the exact factor.
  EXPECT_NE(factor->Solve(setting.point.gradient),
            policy.Exact(setting.point)->Solve(setting.point.gradient));
}

TEST(HessianPolicy, AutoFallsBackAtTheStartWhenIllConditioned) {
  const Setting setting(1e-4);
  HessianPolicy policy(*setting.objective, HessianPrecision::kAuto);
  ASSERT_TRUE(policy.Start(setting.point));
  EXPECT_TRUE(policy.fell_back_to_double());
  EXPECT_THAT(policy.aliased(), IsEmpty());
  EXPECT_EQ(policy.ForStep(setting.point)->Solve(setting.point.gradient),
            policy.Exact(setting.point)->Solve(setting.point.gradient));
}

TEST(HessianPolicy, AutoFallsBackAtAStepToo) {
  const Setting setting(1e-4);
  HessianPolicy policy(*setting.objective, HessianPrecision::kAuto);
  ASSERT_TRUE(policy.ForStep(setting.point));
  EXPECT_TRUE(policy.fell_back_to_double());
}

TEST(HessianPolicy, SingleIsDampedUntilPositiveDefinite) {
  const Setting setting(1e-5);
  HessianPolicy policy(*setting.objective, HessianPrecision::kSingle);
  const auto factor = policy.ForStep(setting.point);
  ASSERT_TRUE(factor);
  EXPECT_FALSE(policy.UsesDouble());
  EXPECT_GT(setting.point.gradient.dot(factor->Solve(setting.point.gradient)), 0.0);  // downhill
}

TEST(HessianPolicy, FindsAliasedColumnsUnlessThereIsARidge) {
  const Setting copy(0.0);
  HessianPolicy policy(*copy.objective, HessianPrecision::kAuto);
  EXPECT_TRUE(policy.Start(copy.point));
  EXPECT_THAT(policy.aliased(), ElementsAre(1));
  EXPECT_EQ(policy.ForStep(copy.point)->Solve(copy.point.gradient)[1], 0.0);

  const Setting ridged(0.0, 1.0);
  HessianPolicy with_ridge(*ridged.objective, HessianPrecision::kAuto);
  EXPECT_TRUE(with_ridge.Start(ridged.point));
  EXPECT_THAT(with_ridge.aliased(), IsEmpty());
}

TEST(HessianPolicy, DoubleOnDemand) {
  const Setting setting(1.0);
  HessianPolicy policy(*setting.objective, HessianPrecision::kAuto);
  policy.InsistOnDouble();
  EXPECT_TRUE(policy.UsesDouble());
  EXPECT_EQ(policy.ForStep(setting.point)->Solve(setting.point.gradient),
            policy.Exact(setting.point)->Solve(setting.point.gradient));
  EXPECT_FALSE(policy.fell_back_to_double());
}

}  // namespace
}  // namespace handcraft::logistic
