// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/small_eigen.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::features {
namespace {

template <std::size_t N>
using Matrix = std::array<double, N * N>;

template <std::size_t N>
Matrix<N> SomeSymmetric(Rng& rng) {
  Matrix<N> a{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j <= i; ++j) a[N * i + j] = a[N * j + i] = rng.Normal();
  }
  return a;
}

// |A v − λ v| of every pair, and how far the vectors are from orthonormal.
template <std::size_t N>
double WorstResidual(const Matrix<N>& a, const SmallEigen<N>& eigen) {
  double worst = 0.0;
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t i = 0; i < N; ++i) {
      double image = 0.0;
      for (std::size_t j = 0; j < N; ++j) image += a[N * i + j] * eigen.vectors[k][j];
      worst = std::fmax(worst, std::fabs(image - eigen.values[k] * eigen.vectors[k][i]));
      double product = 0.0;
      for (std::size_t j = 0; j < N; ++j) product += eigen.vectors[k][j] * eigen.vectors[i][j];
      worst = std::fmax(worst, std::fabs(product - (i == k ? 1.0 : 0.0)));
    }
  }
  return worst;
}

TEST(EigenOfSymmetric, OfADiagonalIsSorted) {
  const SmallEigen<3> eigen = EigenOfSymmetric<3>({5, 0, 0, 0, -2, 0, 0, 0, 3});
  EXPECT_EQ(eigen.values, (std::array<double, 3>{-2, 3, 5}));
  EXPECT_EQ(eigen.vectors[0], (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(eigen.vectors[2], (std::array<double, 3>{1, 0, 0}));
}

// [[2, 1], [1, 2]] has 1 and 3 with (1, −1) and (1, 1) over √2.
TEST(EigenOfSymmetric, OfAHandCase) {
  const SmallEigen<3> eigen = EigenOfSymmetric<3>({2, 1, 0, 1, 2, 0, 0, 0, 7});
  const double r = std::sqrt(0.5);
  EXPECT_NEAR(eigen.values[0], 1.0, 1e-15);
  EXPECT_NEAR(eigen.values[1], 3.0, 1e-15);
  EXPECT_NEAR(std::fabs(eigen.vectors[0][0]), r, 1e-15);
  EXPECT_NEAR(eigen.vectors[0][0], -eigen.vectors[0][1], 1e-15);
  EXPECT_NEAR(eigen.vectors[1][0], r, 1e-15);
  EXPECT_NEAR(eigen.vectors[1][1], r, 1e-15);
}

TEST(EigenOfSymmetric, DiagonalisesAnyMatrix) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const Matrix<3> three = SomeSymmetric<3>(rng);
    EXPECT_LT(WorstResidual<3>(three, EigenOfSymmetric<3>(three)), 1e-14);
    const Matrix<4> four = SomeSymmetric<4>(rng);
    EXPECT_LT(WorstResidual<4>(four, EigenOfSymmetric<4>(four)), 1e-14);
  }
}

TEST(EigenOfSymmetric, KeepsSmallEigenvaluesOfThinMatrices) {
  // v vᵀ + 1e-12 I: a plane seen with hardly any noise.
  Matrix<3> a{};
  const std::array<double, 3> v = {0.6, 0.0, 0.8};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) a[3 * i + j] = v[i] * v[j] + (i == j ? 1e-12 : 0.0);
  }
  const SmallEigen<3> eigen = EigenOfSymmetric<3>(a);
  EXPECT_NEAR(eigen.values[0], 1e-12, 1e-16);
  EXPECT_NEAR(eigen.values[2], 1.0, 1e-11);
}

TEST(EigenOfSymmetric, TheLargestEntryIsPositive) {
  Rng rng(2);
  for (int i = 0; i < 50; ++i) {
    for (const auto& vector : EigenOfSymmetric<3>(SomeSymmetric<3>(rng)).vectors) {
      double largest = 0.0;
      for (const double entry : vector) {
        if (std::fabs(entry) > std::fabs(largest)) largest = entry;
      }
      EXPECT_GT(largest, 0.0);
    }
  }
}

TEST(EigenOfSymmetric, OfZeroAndOfEqualsIsOrthonormal) {
  EXPECT_LT(WorstResidual<3>(Matrix<3>{}, EigenOfSymmetric<3>(Matrix<3>{})), 1e-15);
  const Matrix<3> same = {4, 0, 0, 0, 4, 0, 0, 0, 4};
  EXPECT_LT(WorstResidual<3>(same, EigenOfSymmetric<3>(same)), 1e-15);
}

TEST(EigenOfSymmetric, ReturnsFromNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(EigenOfSymmetric<3>({1, nan, 0, nan, 1, 0, 0, 0, 1}).values[0]));
}

}  // namespace
}  // namespace handcraft::features
