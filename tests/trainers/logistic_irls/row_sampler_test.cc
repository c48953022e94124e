// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/row_sampler.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/trainers/logistic_irls/problem.h"
#include "trainers/logistic_irls/hessian_factor.h"

namespace handcraft::logistic {
namespace {

TEST(DrawRows, TakesHeavyRowsForCertain) {
  std::vector<double> norms(1000, 1.0);
  norms[17] = 1e6;
  const std::vector<double> scores(1000, 0.0);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    const RowSample sample = DrawRows(norms, scores, 100, rng);
    const auto found = std::find(sample.rows.begin(), sample.rows.end(), 17U);
    ASSERT_NE(found, sample.rows.end());
    EXPECT_EQ(sample.weights[static_cast<std::size_t>(found - sample.rows.begin())], 1.0);
    EXPECT_TRUE(std::is_sorted(sample.rows.begin(), sample.rows.end()));
  }
}

// Σ weights estimates the number of rows without bias, and the number drawn is what was wanted.
TEST(DrawRows, IsUnbiased) {
  Rng rng(1);
  std::vector<double> norms(2000);
  std::vector<double> scores(2000);
  for (std::size_t i = 0; i < norms.size(); ++i) {
    norms[i] = rng.Uniform();
    scores[i] = 3.0 * rng.Normal();
  }
  double weight = 0.0;
  double count = 0.0;
  for (int repeat = 0; repeat < 200; ++repeat) {
    const RowSample sample = DrawRows(norms, scores, 200, rng);
    weight += std::accumulate(sample.weights.begin(), sample.weights.end(), 0.0) / 200;
    count += static_cast<double>(sample.rows.size()) / 200;
  }
  EXPECT_NEAR(weight, 2000.0, 60.0);  // standard error below 15
  EXPECT_NEAR(count, 200.0, 5.0);     // standard error 1
}

TEST(DrawRows, ZeroNormsDrawUniformly) {
  Rng rng(2);
  const std::vector<double> zeros(1000, 0.0);
  const RowSample sample = DrawRows(zeros, zeros, 200, rng);
  EXPECT_NEAR(static_cast<double>(sample.rows.size()), 100.0, 50.0);
}

// The law that the descent lives on: the sketched Hessian is close to the whole one in every
// direction, small ones too. Here the second feature differs from the first in a few rows alone,
// which draws by norm or at random can miss.
TEST(DrawRows, ByLeverageKeepsTheHessianCloseInEveryDirection) {
  auto problem = DrawProblem<double>(8000, 6, 1, 1.0);
  Rng rng(11);
  for (std::size_t i = 0; i < 8000; ++i) {
    const double apart = rng.Uniform() < 0.002 ? 1e-2 : 1e-5;
    problem.At(i, 1) = problem.At(i, 0) + apart * rng.Normal();
  }
  const ColumnMoments moments = ComputeColumnMoments(problem.X(), 1);
  const Objective objective(problem.X(), problem.labels, moments, 0.0, 1);
  Point point;
  objective.Evaluate(Eigen::VectorXd::Zero(7), point);
  const Eigen::MatrixXd whole = objective.Hessian<double>(point).selfadjointView<Eigen::Lower>();
  const auto condition = [&](const RowSample& sample) {
    const Eigen::MatrixXd sketch =
        objective.Hessian<double>(point, &sample).selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd values =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(whole, sketch).eigenvalues();
    return values.maxCoeff() / values.minCoeff();
  };
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(7, 7);
  const std::vector<double> norms = objective.SquaredNorms(identity);
  const std::vector<double> leverages =
      objective.SquaredNorms(HessianFactor::Make(whole, {})->InverseRootTimes(identity));
  double by_leverage = 0.0;
  double by_norm = 0.0;
  double uniform = 0.0;
  for (int draw = 0; draw < 20; ++draw) {
    by_leverage = std::max(by_leverage, condition(DrawRows(leverages, point.scores, 800, rng)));
    by_norm = std::max(by_norm, condition(DrawRows(norms, point.scores, 800, rng)));
    const RowSample rows{.rows = rng.SampleSorted(8000, 800), .weights = std::vector(800, 10.0)};
    uniform = std::max(uniform, condition(rows));
  }
  EXPECT_LT(by_leverage, 1.6);
  EXPECT_GT(by_norm, 100.0);
  EXPECT_GT(uniform, 100.0);
}

}  // namespace
}  // namespace handcraft::logistic
