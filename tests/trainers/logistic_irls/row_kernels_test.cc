// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/row_kernels.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::logistic {
namespace {

template <class T>
class RowKernels : public ::testing::Test {
 protected:
  // Eight rows of p numbers, with centres and factors.
  void Draw(std::size_t p, std::uint64_t seed) {
    Rng rng(seed);
    const auto draw = [&](auto& drawn, std::size_t count) {
      drawn.resize(count);
      for (auto& value : drawn) {
        value = static_cast<typename std::decay_t<decltype(drawn)>::value_type>(rng.Normal());
      }
    };
    draw(values_, kTileRows * p);
    draw(mean_, p);
    draw(factor_, p);
    draw(row_factors_, kTileRows);
    for (std::size_t i = 0; i < kTileRows; ++i) rows_[i] = values_.data() + i * p;
    scaling_ = {p, mean_.data(), factor_.data()};
  }
  double Centred(std::size_t i, std::size_t j) const {
    return static_cast<double>(rows_[i][j]) - mean_[j];
  }

  std::vector<T> values_;
  std::vector<double> mean_;
  std::vector<double> factor_;
  std::vector<double> row_factors_;
  RowTile<T> rows_{};
  ColumnScaling scaling_;
};

using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RowKernels, Numbers);

TYPED_TEST(RowKernels, ScoreATileByHand) {
  const std::vector<TypeParam> values = {1, 2, 3, 4, 5, 6};
  const std::vector<double> mean = {1, 1, 1, 1, 1, 2};
  const std::vector<double> factor = {1, 1, 1, 1, 1, 10};
  RowTile<TypeParam> rows;
  rows.fill(values.data());
  double scores[kTileRows];
  ComputeScores(rows, {6, mean.data(), factor.data()}, scores);
  for (const double score : scores) EXPECT_EQ(score, 0 + 1 + 2 + 3 + 4 + 40);
}

// Widths around the four lanes; plain loops as the oracle.
TYPED_TEST(RowKernels, AgreeWithPlainLoops) {
  for (const std::size_t p : {1U, 3U, 4U, 5U, 8U, 31U, 500U}) {
    this->Draw(p, p);
    double scores[kTileRows];
    ComputeScores(this->rows_, this->scaling_, scores);
    std::vector<double> sum(p, 1.0);
    AddWeightedRows(this->rows_, this->scaling_, this->row_factors_.data(), sum.data());
    for (std::size_t i = 0; i < kTileRows; ++i) {
      double score = 0.0;
      std::vector<double> row(p);
      std::vector<float> row_single(p);
      StandardiseRow(this->rows_[i], this->scaling_, 0.5, row.data());
      StandardiseRow(this->rows_[i], this->scaling_, 0.5, row_single.data());
      for (std::size_t j = 0; j < p; ++j) {
        const double value = this->Centred(i, j) * this->factor_[j];
        score += value;
        EXPECT_EQ(row[j], value * 0.5);
        EXPECT_EQ(row_single[j], static_cast<float>(value * 0.5));
      }
      EXPECT_NEAR(scores[i], score, 1e-13 * static_cast<double>(p));
    }
    for (std::size_t j = 0; j < p; ++j) {
      double expected = 1.0;
      for (std::size_t i = 0; i < kTileRows; ++i) {
        expected += this->Centred(i, j) * this->row_factors_[i];
      }
      EXPECT_NEAR(sum[j], expected, 1e-13);
    }
  }
}

TYPED_TEST(RowKernels, AddMomentsAboutTheCentres) {
  for (const std::size_t p : {1U, 4U, 7U}) {
    this->Draw(p, p);
    std::vector<double> sum(p, 0.0);
    std::vector<double> squares(p, 0.0);
    for (const TypeParam* row : this->rows_) {
      AddMoments(row, this->scaling_, sum.data(), squares.data());
    }
    for (std::size_t j = 0; j < p; ++j) {
      double expected = 0.0;
      double expected_squares = 0.0;
      for (std::size_t i = 0; i < kTileRows; ++i) {
        expected += this->Centred(i, j);
        expected_squares += this->Centred(i, j) * this->Centred(i, j);
      }
      EXPECT_EQ(sum[j], expected);
      EXPECT_EQ(squares[j], expected_squares);
    }
  }
}

}  // namespace
}  // namespace handcraft::logistic
