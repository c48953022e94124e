// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/similarity.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handcraft::features {
namespace {

TEST(Similarity, ByHand) {
  const Similarity linear{.type = SimilarityType::kLinear};
  EXPECT_EQ(linear(2.5, 100.0, 100.0), 2.5);
  const Similarity cubic{
      .type = SimilarityType::kPolynomial, .degree = 3, .gamma = 0.5, .coef0 = 1.0};
  EXPECT_EQ(cubic(4.0, 100.0, 100.0), 27.0);
  const Similarity rbf{.type = SimilarityType::kRbf, .gamma = 0.25};
  EXPECT_DOUBLE_EQ(rbf(1.0, 2.0, 4.0), std::exp(-1.0));  // the squared distance is 4
}

TEST(Similarity, PowersOfEveryDegree) {
  for (int degree = 1; degree <= 12; ++degree) {
    const Similarity kernel{
        .type = SimilarityType::kPolynomial, .degree = degree, .gamma = 1.0, .coef0 = 0.25};
    // Squaring rounds some log₂(degree) times, each time doubling the relative error before.
    EXPECT_NEAR(kernel(1.5, 0, 0) / std::pow(1.75, degree), 1.0, degree * 2.3e-16);
  }
}

TEST(Similarity, RbfOfASampleWithItselfIsOneWhateverRounds) {
  const Similarity rbf{.type = SimilarityType::kRbf, .gamma = 1e6};
  EXPECT_EQ(rbf(std::nextafter(1e8, 1e9), 1e8, 1e8), 1.0);
}

TEST(Similarity, NamesAreLibsvms) {
  EXPECT_EQ(NameOf(SimilarityType::kLinear), "linear");
  EXPECT_EQ(NameOf(SimilarityType::kPolynomial), "poly");
  EXPECT_EQ(NameOf(SimilarityType::kRbf), "rbf");
}

}  // namespace
}  // namespace handcraft::features
