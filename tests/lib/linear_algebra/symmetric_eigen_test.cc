// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/symmetric_eigen.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft {
namespace {

using ::testing::ElementsAre;

TEST(SymmetricEigen, OfTwoByTwoByHand) {
  const SymmetricEigen eigen = EigenDecompose({2.0, 1.0, 1.0, 2.0}, 2);
  EXPECT_NEAR(eigen.values[0], 3.0, 1e-15);
  EXPECT_NEAR(eigen.values[1], 1.0, 1e-15);
  EXPECT_NEAR(eigen.Vector(0)[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(eigen.Vector(0)[1], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(eigen.Vector(1)[0], std::sqrt(0.5), 1e-15);  // the first of equals is positive
  EXPECT_NEAR(eigen.Vector(1)[1], -std::sqrt(0.5), 1e-15);
}

TEST(SymmetricEigen, OfOneNumber) {
  const SymmetricEigen eigen = EigenDecompose({-4.0}, 1);
  EXPECT_THAT(eigen.values, ElementsAre(-4.0));
  EXPECT_THAT(eigen.vectors, ElementsAre(1.0));
}

TEST(SymmetricEigen, ReadsTheLowerTriangle) {
  const SymmetricEigen eigen = EigenDecompose({2.0, 77.0, 1.0, 2.0}, 2);
  EXPECT_NEAR(eigen.values[0], 3.0, 1e-15);
}

// A v = λ v, vectors at right angles and of length 1, descending, for a matrix of rank 20 of 30.
TEST(SymmetricEigen, KeepsItsLaws) {
  constexpr std::size_t kSize = 30;
  constexpr std::size_t kRank = 20;
  Rng rng(5);
  std::vector<double> matrix(kSize * kSize, 0.0);
  for (std::size_t r = 0; r < kRank; ++r) {
    std::vector<double> v(kSize);
    for (double& x : v) x = rng.Normal();
    for (std::size_t i = 0; i < kSize; ++i) {
      for (std::size_t j = 0; j < kSize; ++j) matrix[i * kSize + j] += v[i] * v[j];
    }
  }
  const SymmetricEigen eigen = EigenDecompose(matrix, kSize);
  const double largest = eigen.values[0];
  for (std::size_t k = 0; k < kSize; ++k) {
    if (k > 0) {
      EXPECT_LE(eigen.values[k], eigen.values[k - 1]);
    }
    if (k >= kRank) {
      EXPECT_NEAR(eigen.values[k], 0.0, 1e-13 * largest);
    }
    for (std::size_t i = 0; i < kSize; ++i) {
      double product = 0.0;
      double dot = 0.0;
      for (std::size_t j = 0; j < kSize; ++j) {
        product += matrix[i * kSize + j] * eigen.Vector(k)[j];
        dot += eigen.Vector(i)[j] * eigen.Vector(k)[j];
      }
      EXPECT_NEAR(product, eigen.values[k] * eigen.Vector(k)[i], 1e-13 * largest);
      EXPECT_NEAR(dot, i == k ? 1.0 : 0.0, 1e-13);
    }
  }
}

TEST(SymmetricEigen, RefusesWhatIsNotFiniteOrDoesNotFit) {
  EXPECT_THROW(static_cast<void>(EigenDecompose({}, 0)), std::logic_error);
  EXPECT_THROW(static_cast<void>(EigenDecompose({1.0, 2.0}, 2)), std::logic_error);
  EXPECT_THROW(static_cast<void>(EigenDecompose({std::numeric_limits<double>::quiet_NaN()}, 1)),
               std::logic_error);
}

}  // namespace
}  // namespace handcraft
