// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/objective.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trainers/logistic_irls/problem.h"

namespace handcraft::logistic {
namespace {

// Features as they are: centre 0, scale 1.
ColumnMoments NoScaling(std::size_t num_features) {
  return {std::vector<double>(num_features, 0.0), std::vector<double>(num_features, 1.0)};
}

Eigen::VectorXd DrawTheta(Eigen::Index size, std::uint64_t seed) {
  Rng rng(seed);
  Eigen::VectorXd theta(size);
  for (double& value : theta) value = 0.5 * rng.Normal();
  return theta;
}

TEST(Objective, OfTwoSamplesByHand) {
  const auto problem = ProblemOf({{1, 1}, {2, 0}});
  const ColumnMoments moments = NoScaling(1);
  const Objective objective(problem.X(), problem.labels, moments, 4.0, 1);
  Point point;
  objective.Evaluate(Eigen::Vector2d(std::log(3.0), -std::log(3.0)), point);
  // z = 0 and log 3; P(1) = 1/2 and 3/4.
  EXPECT_NEAR(point.deviance, 2.0 * (std::log(2.0) + std::log(4.0)), 1e-14);
  EXPECT_NEAR(point.value, std::log(8.0) + 2.0 * std::log(3.0) * std::log(3.0), 1e-14);
  EXPECT_NEAR(point.gradient[0], -0.5 * 1 + 0.75 * 2 + 4.0 * std::log(3.0), 1e-14);
  EXPECT_NEAR(point.gradient[1], -0.5 + 0.75, 1e-15);
  EXPECT_NEAR(point.smallest_margin, -std::log(3.0), 1e-15);
  const Eigen::MatrixXd hessian = objective.Hessian<double>(point);
  EXPECT_NEAR(hessian(0, 0), 0.25 * 1 + 0.1875 * 4 + 4.0, 1e-14);
  EXPECT_NEAR(hessian(1, 0), 0.25 * 1 + 0.1875 * 2, 1e-15);
  EXPECT_NEAR(hessian(1, 1), 0.25 + 0.1875, 1e-15);
}

TEST(Objective, GradientAgreesWithCentralDifferences) {
  const auto problem = DrawProblem<float>(1500, 7, 1);
  const ColumnMoments moments = ComputeColumnMoments(problem.X(), 1);
  const Objective objective(problem.X(), problem.labels, moments, 3.0, 2);
  const Eigen::VectorXd theta = DrawTheta(8, 2);
  Point point;
  Point above;
  Point below;
  objective.Evaluate(theta, point);
  for (Eigen::Index k = 0; k < 8; ++k) {
    const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(8, k);
    objective.Evaluate(theta + step, above);
    objective.Evaluate(theta - step, below);
    // Error of the difference: rounding of f (1e3 · 1e-16 / 1e-5) and h² f'''/6 (1e-10 · 1e3).
    EXPECT_NEAR(point.gradient[k], (above.value - below.value) / 2e-5, 2e-7 * 1500) << k;
    EXPECT_NEAR(
        point.gradient[k], (above.value - below.value) / 2e-5, 1e-6 * point.gradient.norm());
  }
}

TEST(Objective, HessianAgreesWithCentralDifferencesOfTheGradient) {
  const auto problem = DrawProblem<double>(5000, 5, 3);
  const ColumnMoments moments = ComputeColumnMoments(problem.X(), 1);
  const Objective objective(problem.X(), problem.labels, moments, 2.0, 2);
  const Eigen::VectorXd theta = DrawTheta(6, 4);
  Point point;
  Point above;
  Point below;
  objective.Evaluate(theta, point);
  const Eigen::MatrixXd exact = objective.Hessian<double>(point);
  const Eigen::MatrixXd single = objective.Hessian<float>(point);
  const double largest = exact.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < 6; ++k) {
    const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(6, k);
    objective.Evaluate(theta + step, above);
    objective.Evaluate(theta - step, below);
    const Eigen::VectorXd column = (above.gradient - below.gradient) / 2e-5;
    for (Eigen::Index row = k; row < 6; ++row) {
      EXPECT_NEAR(exact(row, k), column[row], 1e-8 * largest);
      EXPECT_NEAR(single(row, k), exact(row, k), 1e-5 * largest);
    }
  }
}

TEST(Objective, IsExactWhereProbabilitiesSaturate) {
  const auto problem = ProblemOf({{1, 1}, {1, 0}});
  const ColumnMoments moments = NoScaling(1);
  const Objective objective(problem.X(), problem.labels, moments, 0.0, 1);
  Point point;
  objective.Evaluate(Eigen::Vector2d(800.0, 0.0), point);
  EXPECT_EQ(point.deviance, 1600.0);
  EXPECT_EQ(point.gradient[0], 1.0);
  objective.Evaluate(Eigen::Vector2d(50.0, 0.0), point);
  EXPECT_DOUBLE_EQ(objective.Hessian<double>(point)(0, 0), 2.0 * std::exp(-50.0));
}

TEST(Objective, FloatAndDoubleAndAnyNumberOfThreadsGiveTheSameBits) {
  const auto single = DrawProblem<float>(9001, 11, 5);
  const auto wide = DrawProblem<double>(9001, 11, 5);
  const ColumnMoments moments = ComputeColumnMoments(single.X(), 1);
  const Eigen::VectorXd theta = DrawTheta(12, 6);
  const Eigen::MatrixXd map = theta * Eigen::RowVector3d(1.0, -2.0, 0.5);
  const Objective reference(wide.X(), wide.labels, moments, 1.0, 1);
  Point expected;
  reference.Evaluate(theta, expected);
  const Eigen::MatrixXd expected_hessian = reference.Hessian<double>(expected);
  for (const int num_threads : {1, 2, 4}) {
    const Objective objective(single.X(), single.labels, moments, 1.0, num_threads);
    Point point;
    objective.Evaluate(theta, point);
    EXPECT_EQ(point.value, expected.value);
    EXPECT_EQ(point.gradient, expected.gradient);
    EXPECT_EQ(point.scores, expected.scores);
    EXPECT_EQ(objective.Hessian<double>(point), expected_hessian);
    EXPECT_EQ(objective.SquaredNorms(map), reference.SquaredNorms(map));
  }
}

// Rows by hand: standardised with mean 2 and deviation 1, then the column of ones.
TEST(Objective, SquaredNormsAreThoseOfMappedRows) {
  const auto problem = ProblemOf({{1, 0}, {2, 1}, {3, 1}});
  const ColumnMoments moments{.mean = {2.0}, .scale = {1.0}};
  const Objective objective(problem.X(), problem.labels, moments, 0.0, 1);
  const Eigen::Matrix2d map{{3.0, 0.0}, {1.0, 2.0}};  // x̃ ↦ (3 x̃ + 1, 2)
  EXPECT_THAT(objective.SquaredNorms(map), ::testing::ElementsAre(8.0, 5.0, 20.0));
}

// A column held at zero has no say, and others have.
TEST(Point, GradientNormLeavesOutWhatIsHeld) {
  Point point;
  point.scores.resize(2);
  point.gradient = Eigen::Vector3d(1.0, -8.0, 2.0);
  EXPECT_EQ(point.GradientNorm(), 4.0);
  EXPECT_EQ(point.GradientNorm({1}), 1.0);
}

TEST(Objective, ASampleOfAllRowsIsAllRows) {
  const auto problem = DrawProblem<float>(700, 4, 7);
  const ColumnMoments moments = ComputeColumnMoments(problem.X(), 1);
  const Objective objective(problem.X(), problem.labels, moments, 1.0, 1);
  Point point;
  objective.Evaluate(DrawTheta(5, 8), point);
  RowSample sample;
  for (std::size_t i = 0; i < 700; i += 2) {
    sample.rows.push_back(i);
    sample.weights.push_back(4.0);
  }
  const Eigen::MatrixXd all = objective.Hessian<double>(point);
  Eigen::MatrixXd even = objective.Hessian<double>(point, &sample);
  for (std::size_t& row : sample.rows) ++row;
  even += objective.Hessian<double>(point, &sample);
  even.diagonal().head(4).array() -= 2.0;  // the ridge came in twice
  Eigen::MatrixXd expected = 4.0 * all;
  expected.diagonal().head(4).array() -= 4.0;
  EXPECT_LE((even - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.maxCoeff());
}

TEST(Objective, TellsHowScoresMove) {
  const auto problem = ProblemOf({{1, 1}, {2, 0}});
  const ColumnMoments moments = NoScaling(1);
  const Objective objective(problem.X(), problem.labels, moments, 0.0, 1);
  Point from;
  Point to;
  objective.Evaluate(Eigen::Vector2d(0.0, 0.0), from);
  objective.Evaluate(Eigen::Vector2d(1.0, 0.5), to);
  const Movement movement = objective.MovementBetween(from, to);
  EXPECT_EQ(movement.largest, 2.5);
  EXPECT_EQ(movement.smallest, -2.5);  // the second sample, label 0, rises
}

}  // namespace
}  // namespace handcraft::logistic
