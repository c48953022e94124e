// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/column_moments.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/logistic_irls/problem.h"
#include "trainers/logistic_irls/row_kernels.h"

namespace handcraft::logistic {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ColumnMoments, OfAFewRowsByHand) {
  const auto problem = ProblemOf({{1, 7, 0}, {3, 7, 0}, {5, 7, 1}});
  const ColumnMoments moments = ComputeColumnMoments(problem.X(), 1);
  EXPECT_DOUBLE_EQ(moments.mean[0], 3.0);
  EXPECT_DOUBLE_EQ(moments.scale[0], std::sqrt(8.0 / 3.0));
  EXPECT_EQ(moments.mean[1], 7.0);
  EXPECT_EQ(moments.scale[1], 1.0);  // constant
}

TEST(ColumnMoments, AgreeWithTwoPassesInLongDouble) {
  auto problem = DrawProblem<double>(3000, 3, 1);
  for (std::size_t i = 0; i < 3000; ++i) problem.At(i, 1) += 1e7;  // one ulp of the mean: 1.9e-9
  const ColumnMoments moments = ComputeColumnMoments(problem.X(), 1);
  for (std::size_t j = 0; j < 3; ++j) {
    long double mean = 0;
    for (std::size_t i = 0; i < 3000; ++i) mean += problem.At(i, j);
    mean /= 3000;
    long double squares = 0;
    for (std::size_t i = 0; i < 3000; ++i) {
      const long double difference = problem.At(i, j) - mean;
      squares += difference * difference;
    }
    EXPECT_NEAR(moments.mean[j], static_cast<double>(mean), 4e-9);
    EXPECT_NEAR(moments.scale[j], static_cast<double>(std::sqrt(squares / 3000)), 1e-9);
  }
}

TEST(ColumnMoments, DoNotDependOnTheNumberOfThreads) {
  const auto problem = DrawProblem<float>(5000, 6, 2);
  const ColumnMoments one = ComputeColumnMoments(problem.X(), 1);
  for (const int num_threads : {2, 4}) {
    const ColumnMoments many = ComputeColumnMoments(problem.X(), num_threads);
    EXPECT_EQ(many.mean, one.mean);
    EXPECT_EQ(many.scale, one.scale);
  }
}

TEST(ColumnMoments, ChunksAreWholeTilesAndFew) {
  for (const std::size_t n : {1U, 1000U, 154188U, 100000000U}) {
    EXPECT_EQ(RowsPerChunk(n) % kTileRows, 0U);
    EXPECT_LE((n + RowsPerChunk(n) - 1) / RowsPerChunk(n), 256U);
  }
}

TEST(ColumnMoments, NameTheNumberThatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    auto problem = DrawProblem<float>(2000, 4, 3);
    problem.At(1234, 2) = bad;
    EXPECT_THROWS_MESSAGE(ComputeColumnMoments(problem.X(), 2),
                          Error,
                          AllOf(HasSubstr("row 1234, column 2"), HasSubstr("finite")));
  }
}

TEST(ColumnMoments, RefuseASpreadThatCannotBeSquared) {
  for (const double size : {1e200, 1e-200}) {
    auto problem = DrawProblem<double>(50, 2, 4);
    for (std::size_t i = 0; i < 50; ++i) problem.At(i, 1) *= size;
    EXPECT_THROWS_MESSAGE(ComputeColumnMoments(problem.X(), 1),
                          Error,
                          AllOf(HasSubstr("column 1"), HasSubstr("spread"), HasSubstr("multiply")));
  }
}

}  // namespace
}  // namespace handcraft::logistic
