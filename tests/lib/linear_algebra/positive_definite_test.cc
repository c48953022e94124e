// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/positive_definite.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft {
namespace {

TEST(PositiveDefinite, SolvesTwoByTwoByHand) {
  const auto solution = SolvePositiveDefinite({4.0, 77.0, 2.0, 3.0}, {8.0, 8.0});  // lower triangle
  ASSERT_TRUE(solution.has_value());
  EXPECT_NEAR(solution->x[0], 1.0, 1e-15);
  EXPECT_NEAR(solution->x[1], 2.0, 1e-15);
  EXPECT_NEAR(solution->reciprocal_condition, 8.0 / 36.0, 1e-14);  // ‖A‖₁ = 6, ‖A⁻¹‖₁ = 6/8
}

TEST(PositiveDefinite, SolvesDrawnSystems) {
  constexpr std::size_t kSize = 25;
  Rng rng(3);
  std::vector<double> matrix(kSize * kSize, 0.0);
  for (int r = 0; r < 60; ++r) {
    std::vector<double> v(kSize);
    for (double& x : v) x = rng.Normal();
    for (std::size_t i = 0; i < kSize; ++i) {
      for (std::size_t j = 0; j < kSize; ++j) matrix[i * kSize + j] += v[i] * v[j];
    }
  }
  std::vector<double> expected(kSize);
  std::vector<double> right_side(kSize, 0.0);
  for (double& x : expected) x = rng.Normal();
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) right_side[i] += matrix[i * kSize + j] * expected[j];
  }
  const auto solution = SolvePositiveDefinite(matrix, right_side);
  ASSERT_TRUE(solution.has_value());
  for (std::size_t i = 0; i < kSize; ++i) EXPECT_NEAR(solution->x[i], expected[i], 1e-11);
}

TEST(PositiveDefinite, RefusesSingularAndIndefiniteMatrices) {
  EXPECT_FALSE(SolvePositiveDefinite({1.0, 1.0, 1.0, 1.0}, {1.0, 1.0}).has_value());
  EXPECT_FALSE(SolvePositiveDefinite({1.0, 1.0, 1.0, 1.0 + 1e-16}, {1.0, 1.0}).has_value());
  EXPECT_FALSE(SolvePositiveDefinite({1.0, 2.0, 2.0, 1.0}, {1.0, 1.0}).has_value());
  EXPECT_FALSE(SolvePositiveDefinite({0.0}, {1.0}).has_value());
  EXPECT_TRUE(SolvePositiveDefinite({1.0, 1.0 - 1e-10, 1.0 - 1e-10, 1.0}, {1.0, 1.0}).has_value());
}

TEST(PositiveDefinite, RefusesWhatIsNotFiniteOrDoesNotFit) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(SolvePositiveDefinite({}, {})), std::logic_error);
  EXPECT_THROW(static_cast<void>(SolvePositiveDefinite({1.0}, {1.0, 2.0})), std::logic_error);
  EXPECT_THROW(static_cast<void>(SolvePositiveDefinite({kNan}, {1.0})), std::logic_error);
  EXPECT_THROW(static_cast<void>(SolvePositiveDefinite({1.0}, {kNan})), std::logic_error);
}

}  // namespace
}  // namespace handcraft
