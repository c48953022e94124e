// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/scatter.h"

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class T>
struct Data {
  std::size_t num_features = 0;
  std::vector<T> values = {};
  std::vector<std::uint8_t> groups = {};

  [[nodiscard]] DesignMatrix<T> X() const {
    return {.data = values.data(),
            .num_samples = values.size() / num_features,
            .num_features = num_features,
            .stride = num_features};
  }
};

// Columns that depend on each other, offset from zero by `offset`, three groups with means apart.
template <class T>
Data<T> Draw(std::size_t num_rows, std::size_t num_features, double offset, std::uint64_t seed) {
  Rng rng(seed);
  Data<T> data{.num_features = num_features};
  for (std::size_t i = 0; i < num_rows; ++i) {
    const auto group = static_cast<std::uint8_t>(rng.Next() % 3);
    const double shared = rng.Normal();
    for (std::size_t j = 0; j < num_features; ++j) {
      const double spread = 1.0 + static_cast<double>(j);
      data.values.push_back(
          static_cast<T>(offset + group + spread * (shared + 0.3 * rng.Normal())));
    }
    data.groups.push_back(group);
  }
  return data;
}

// The definition, two passes in long double.
template <class T>
std::vector<long double> ProductsByDefinition(const Data<T>& data, std::size_t num_groups) {
  const std::size_t p = data.num_features;
  const std::size_t n = data.X().num_samples;
  std::vector<long double> means(num_groups * p, 0.0L);
  std::vector<long double> counts(num_groups, 0.0L);
  const auto group_of = [&](std::size_t i) { return data.groups.empty() ? 0U : data.groups[i]; };
  for (std::size_t i = 0; i < n; ++i) counts[group_of(i)] += 1.0L;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      means[group_of(i) * p + j] += data.X().Row(i)[j] / counts[group_of(i)];
    }
  }
  std::vector<long double> products(p * p, 0.0L);
  for (std::size_t i = 0; i < n; ++i) {
    const long double* mean = means.data() + group_of(i) * p;
    for (std::size_t j = 0; j < p; ++j) {
      for (std::size_t k = 0; k < p; ++k) {
        products[j * p + k] += (data.X().Row(i)[j] - mean[j]) * (data.X().Row(i)[k] - mean[k]);
      }
    }
  }
  return products;
}

// The largest error, as a share of √(diagonal · diagonal).
double LargestError(const Scatter& scatter, const std::vector<long double>& expected) {
  const std::size_t p = scatter.num_features;
  double largest = 0.0;
  for (std::size_t j = 0; j < p; ++j) {
    for (std::size_t k = 0; k < p; ++k) {
      const long double size = std::sqrt(expected[j * p + j] * expected[k * p + k]);
      const long double error = std::abs(scatter.products[j * p + k] - expected[j * p + k]) / size;
      largest = std::max(largest, static_cast<double>(error));
    }
  }
  return largest;
}

TEST(Scatter, OfThreePointsByHand) {
  const Data<double> data{.num_features = 2, .values = {1.0, 2.0, 3.0, 2.0, 5.0, 8.0}};
  const Scatter scatter = ComputeScatter(data.X(), {}, 1);
  EXPECT_THAT(scatter.means, ElementsAre(3.0, 4.0));
  EXPECT_THAT(scatter.products, ElementsAre(8.0, 12.0, 12.0, 24.0));
  EXPECT_EQ(scatter.NumRows(), 3U);
}

TEST(Scatter, OfTwoGroupsIsAboutTheirOwnMeans) {
  const Data<double> data{
      .num_features = 1, .values = {1.0, 10.0, 3.0, 14.0}, .groups = {0, 1, 0, 1}};
  const Scatter scatter = ComputeScatter(data.X(), data.groups, 2);
  EXPECT_THAT(scatter.num_rows, ElementsAre(2, 2));
  EXPECT_THAT(scatter.means, ElementsAre(2.0, 12.0));
  EXPECT_THAT(scatter.products, ElementsAre(10.0));
}

TEST(Scatter, FollowsItsDefinitionInDouble) {
  for (const double offset : {0.0, 1e6}) {
    const auto data = Draw<double>(1500, 7, offset, 3);
    // What the offset costs is the rounding of the numbers themselves: 1e6 · 2⁻⁵³.
    EXPECT_LT(LargestError(ComputeScatter(data.X(), data.groups, 3), ProductsByDefinition(data, 3)),
              1e-13);
    Data<double> one = data;
    one.groups.clear();
    EXPECT_LT(LargestError(ComputeScatter(one.X(), {}, 1), ProductsByDefinition(one, 1)), 1e-13);
  }
}

TEST(Scatter, FollowsItsDefinitionInSingleToSevenDigits) {
  const auto data = Draw<float>(3000, 6, 100.0, 5);
  const Scatter scatter =
      ComputeScatter(data.X(), data.groups, 3, {.precision = ScatterPrecision::kSingle});
  EXPECT_FALSE(scatter.fell_back_to_double);
  const double error = LargestError(scatter, ProductsByDefinition(data, 3));
  EXPECT_LT(error, 1e-6);  // 512 products a block, each rounded to 2⁻²⁴
  EXPECT_GT(error, 1e-14);
}

TEST(Scatter, TakesADistantSmallGroupInItsStride) {
  Data<double> data = Draw<double>(2100, 3, 0.0, 7);
  data.groups.assign(2100, 0);
  data.groups[1] = 1;  // not among the rows that the origins are taken from
  for (std::size_t j = 0; j < 3; ++j) data.values[3 + j] = 1e3;
  const Scatter scatter = ComputeScatter(data.X(), data.groups, 2);
  EXPECT_THAT(scatter.num_rows, ElementsAre(2099, 1));
  EXPECT_DOUBLE_EQ(scatter.Mean(1)[0], 1e3);
  EXPECT_LT(LargestError(scatter, ProductsByDefinition(data, 2)), 1e-12);
}

TEST(Scatter, IsTheSameForAnyNumberOfThreads) {
  for (const ScatterPrecision precision : {ScatterPrecision::kDouble, ScatterPrecision::kSingle}) {
    const auto data = Draw<float>(6000, 9, 2.0, 11);
    const Scatter one =
        ComputeScatter(data.X(), data.groups, 3, {.precision = precision, .num_threads = 1});
    const Scatter four =
        ComputeScatter(data.X(), data.groups, 3, {.precision = precision, .num_threads = 4});
    EXPECT_EQ(one.products, four.products);
    EXPECT_EQ(one.means, four.means);
  }
}

TEST(Scatter, ReadsRowsThatAreApart) {
  const std::vector<float> values = {1, 2, 99, 3, 2, 99, 5, 8, 99};
  const DesignMatrix<float> X{
      .data = values.data(), .num_samples = 3, .num_features = 2, .stride = 3};
  EXPECT_THAT(ComputeScatter(X, {}, 1).products, ElementsAre(8.0, 12.0, 12.0, 24.0));
}

TEST(Scatter, OfAConstantColumnIsExactlyZero) {
  Data<float> data = Draw<float>(1300, 2, 0.0, 13);
  for (std::size_t i = 0; i < 1300; ++i) data.values[2 * i] = 0.1F;
  const Scatter scatter = ComputeScatter(data.X(), {}, 1);
  EXPECT_EQ(scatter.products[0], 0.0);
  EXPECT_EQ(scatter.means[0], static_cast<double>(0.1F));
}

TEST(Scatter, FallsBackToDoubleWhereSingleOverflows) {
  Data<double> data = Draw<double>(2000, 2, 0.0, 17);
  data.values[2] = 1e30;  // of row 1: not among the rows that tell the spread
  const Scatter scatter = ComputeScatter(data.X(), {}, 1, {.precision = ScatterPrecision::kSingle});
  EXPECT_TRUE(scatter.fell_back_to_double);
  EXPECT_TRUE(std::isfinite(scatter.products[0]));
  data.values[2] = 1e200;
  EXPECT_THROWS_MESSAGE(ComputeScatter(data.X(), {}, 1), Error, HasSubstr("square double cannot"));
}

TEST(Scatter, NamesTheNumberThatIsNotFinite) {
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (const std::size_t row : {0U, 1401U}) {
      Data<float> data = Draw<float>(1500, 4, 0.0, 19);
      data.values[row * 4 + 2] = wrong;
      EXPECT_THROWS_MESSAGE(ComputeScatter(data.X(), data.groups, 3),
                            Error,
                            AllOf(HasSubstr("row " + std::to_string(row) + ", column 2"),
                                  HasSubstr("must be a finite number")));
    }
  }
}

TEST(Scatter, RefusesWhatIsEmptyAndWhatDoesNotFit) {
  const DesignMatrix<double> nothing{};
  EXPECT_THROWS_MESSAGE(ComputeScatter(nothing, {}, 1), Error, HasSubstr("0 samples, 0 features"));
  const auto data = Draw<double>(10, 2, 0.0, 23);
  EXPECT_THROW(static_cast<void>(ComputeScatter(data.X(), data.groups, 2)), std::logic_error);
  EXPECT_THROW(static_cast<void>(ComputeScatter(data.X(), {}, 2)), std::logic_error);
  EXPECT_THROWS_MESSAGE(ComputeScatter(data.X(), {}, 1, {.num_threads = 0}),
                        Error,
                        HasSubstr("ScatterOptions.num_threads is 0; it must be >= 1"));
}

}  // namespace
}  // namespace handcraft
