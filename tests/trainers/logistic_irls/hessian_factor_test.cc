// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/hessian_factor.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::logistic {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Eigen::MatrixXd DrawMatrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  Rng rng(seed);
  Eigen::MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = rng.Normal();
  return matrix;
}

TEST(HessianFactor, SolvesATwoByTwoByHand) {
  Eigen::Matrix2d hessian;
  hessian << 4, 99, 2, 3;  // the upper triangle is not read
  const auto factor = HessianFactor::Make(hessian, {});
  ASSERT_TRUE(factor);
  const Eigen::VectorXd solution = factor->Solve(Eigen::Vector2d(8, 8));
  EXPECT_NEAR(solution[0], 1.0, 1e-15);
  EXPECT_NEAR(solution[1], 2.0, 1e-15);
  EXPECT_NEAR(factor->InverseForm(Eigen::Vector2d(8, 8)), 24.0, 1e-13);
  EXPECT_NEAR(factor->InverseDiagonal()[0], 3.0 / 8.0, 1e-15);
  EXPECT_NEAR(factor->InverseDiagonal()[1], 4.0 / 8.0, 1e-15);
}

TEST(HessianFactor, AgreesWithTheInverseByElimination) {
  const Eigen::MatrixXd a = DrawMatrix(60, 20, 1);
  const Eigen::MatrixXd hessian = a.transpose() * a;
  const Eigen::MatrixXd inverse = hessian.partialPivLu().inverse();
  const auto factor = HessianFactor::Make(hessian, {});
  ASSERT_TRUE(factor);
  EXPECT_LE((factor->InverseDiagonal() - inverse.diagonal()).norm(), 1e-12);
  const Eigen::VectorXd v = DrawMatrix(20, 1, 2);
  EXPECT_LE((factor->Solve(v) - inverse * v).norm(), 1e-12);
  EXPECT_NEAR(factor->InverseForm(v), v.dot(inverse * v), 1e-12);
  const double condition =
      hessian.cwiseAbs().colwise().sum().maxCoeff() * inverse.cwiseAbs().colwise().sum().maxCoeff();
  EXPECT_NEAR(factor->reciprocal_condition() * condition, 1.0, 0.9);  // an estimate
}

TEST(HessianFactor, LeavesAliasedColumnsOut) {
  const Eigen::MatrixXd a = DrawMatrix(30, 4, 3);
  Eigen::MatrixXd hessian = a.transpose() * a;
  const auto whole = HessianFactor::Make(hessian(std::vector{0, 2, 3}, std::vector{0, 2, 3}), {});
  const auto part = HessianFactor::Make(hessian, {1});
  ASSERT_TRUE(whole && part);
  const Eigen::Vector4d v(1, 2, 3, 4);
  const Eigen::VectorXd solution = part->Solve(v);
  EXPECT_EQ(solution[1], 0.0);
  EXPECT_LE((solution(std::vector{0, 2, 3}) - whole->Solve(Eigen::Vector3d(1, 3, 4))).norm(),
            1e-14);
  EXPECT_TRUE(std::isnan(part->InverseDiagonal()[1]));
  EXPECT_NEAR(part->InverseDiagonal()[2], whole->InverseDiagonal()[1], 1e-14);
}

// M Mᵀ = H⁻¹ on the columns kept, zero elsewhere.
TEST(HessianFactor, InverseRootSquaresToTheInverse) {
  const Eigen::MatrixXd a = DrawMatrix(20, 4, 7);
  const Eigen::MatrixXd hessian = a.transpose() * a;
  const auto factor = HessianFactor::Make(hessian, {2});
  ASSERT_TRUE(factor);
  const Eigen::MatrixXd root = factor->InverseRootTimes(Eigen::MatrixXd::Identity(4, 4));
  for (Eigen::Index j = 0; j < 4; ++j) {
    const Eigen::VectorXd expected = factor->Solve(Eigen::VectorXd::Unit(4, j));
    EXPECT_LE((root * root.transpose() * Eigen::VectorXd::Unit(4, j) - expected).norm(), 1e-14);
  }
}

TEST(HessianFactor, IsNothingWhenNotPositiveDefinite) {
  Eigen::Matrix2d hessian;
  hessian << 1, 2, 2, 1;
  EXPECT_FALSE(HessianFactor::Make(hessian, {}));
  hessian << 1, 1, 1, 1 + 1e-16;
  EXPECT_FALSE(HessianFactor::Make(hessian, {}));
  hessian << 1, 0, 0, std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(HessianFactor::Make(hessian, {}));
}

// Columns: a, b, 2a − b, constant, c; then the intercept.
TEST(FindAliasedColumns, KeepsTheFirstAndListsTheRest) {
  Eigen::MatrixXd a = DrawMatrix(50, 6, 4);
  a.col(2) = 2.0 * a.col(0) - a.col(1);
  a.col(3).setConstant(3.0);
  a.col(5).setOnes();
  EXPECT_THAT(FindAliasedColumns(a.transpose() * a), ElementsAre(2, 3));
  a.col(3).setZero();
  EXPECT_THAT(FindAliasedColumns(a.transpose() * a), ElementsAre(2, 3));
}

TEST(FindAliasedColumns, KeepsNearlyCollinearColumns) {
  Eigen::MatrixXd a = DrawMatrix(50, 4, 5);
  a.col(1) = a.col(0) + 1e-4 * a.col(1);
  EXPECT_THAT(FindAliasedColumns(a.transpose() * a), IsEmpty());
}

TEST(FindAliasedColumns, KeepsAsManyAsThereAreRows) {
  const Eigen::MatrixXd a = DrawMatrix(3, 6, 6);
  EXPECT_THAT(FindAliasedColumns(a.transpose() * a), ElementsAre(2, 3, 4));
}

}  // namespace
}  // namespace handcraft::logistic
