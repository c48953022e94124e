// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/pca/pca.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::pca {
namespace {

using ::testing::HasSubstr;

// Rows of numbers separated by commas; `skip` first lines and `drop` last columns are left out.
struct Rows {
  std::size_t num_columns = 0;
  std::vector<double> values = {};

  [[nodiscard]] DesignMatrix<double> X() const {
    return {.data = values.data(),
            .num_samples = values.size() / num_columns,
            .num_features = num_columns,
            .stride = num_columns};
  }
};

Rows ReadRows(const std::string& name, int skip, std::size_t drop) {
  std::istringstream lines(
      ReadTextFile(std::string(HANDCRAFT_SOURCE_DIR) + "/tests/data/trainers/" + name));
  Rows rows;
  std::string line;
  for (int i = 0; std::getline(lines, line); ++i) {
    if (i < skip) continue;
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string word; std::getline(words, word, ',');) row.push_back(std::stod(word));
    rows.num_columns = row.size() - drop;
    rows.values.insert(rows.values.end(), row.begin(), row.end() - static_cast<int>(drop));
  }
  return rows;
}

Rows Draw(std::size_t num_rows, std::size_t num_columns, std::uint64_t seed) {
  Rng rng(seed);
  Rows rows{.num_columns = num_columns};
  for (std::size_t i = 0; i < num_rows; ++i) {
    const double shared = rng.Normal();
    for (std::size_t j = 0; j < num_columns; ++j) {
      rows.values.push_back(shared * static_cast<double>(j) + rng.Normal());
    }
  }
  return rows;
}

TEST(Pca, OfPointsOnALineByHand) {
  const Rows rows{.num_columns = 2, .values = {0.0, 1.0, 3.0, 5.0, 6.0, 9.0}};
  const Result result = TrainPca(rows.X());
  EXPECT_NEAR(result.eigenvalues[0], 25.0, 1e-13);  // variances 9 and 16, one direction
  EXPECT_NEAR(result.eigenvalues[1], 0.0, 1e-13);
  EXPECT_GE(result.eigenvalues[1], 0.0);
  EXPECT_NEAR(result.Component(0)[0], 0.6, 1e-14);
  EXPECT_NEAR(result.Component(0)[1], 0.8, 1e-14);
  EXPECT_EQ(result.mean, (std::vector<double>{3.0, 5.0}));
  EXPECT_EQ(result.NumComponentsFor(0.9), 1U);
}

struct Reference {
  const char* table;
  Scaling scaling;
};
class Prcomp : public ::testing::TestWithParam<Reference> {};

// The smallest eigenvalue of "decades" is 1e-38 of the largest without scaling: components whose
// variance lies below rounding, 1e-13 of the largest, are not compared.
TEST_P(Prcomp, AgreesToNineDigits) {
  const auto [table, scaling] = GetParam();
  const Rows rows = ReadRows("logistic_" + std::string(table) + ".csv", 1, 1);
  const Rows prcomp =
      ReadRows("pca_" + std::string(table) + "_" + std::string(NameOf(scaling)) + ".csv", 0, 0);
  const Result result = TrainPca(rows.X(), {.scaling = scaling});
  ASSERT_EQ(prcomp.num_columns, result.num_features + 1);
  for (std::size_t k = 0; k < result.num_features; ++k) {
    const double* expected = prcomp.X().Row(k);
    if (result.eigenvalues[k] < 1e-13 * result.eigenvalues[0]) continue;
    EXPECT_NEAR(std::sqrt(result.eigenvalues[k]), expected[0], 1e-9 * expected[0]) << k;
    for (std::size_t j = 0; j < result.num_features; ++j) {
      EXPECT_NEAR(result.Component(k)[j], expected[1 + j], 1e-9) << k << ", " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tables,
                         Prcomp,
                         ::testing::Values(Reference{"iris", Scaling::kNone},
                                           Reference{"iris", Scaling::kStandard},
                                           Reference{"heart", Scaling::kNone},
                                           Reference{"heart", Scaling::kStandard},
                                           Reference{"decades", Scaling::kNone},
                                           Reference{"decades", Scaling::kStandard}),
                         [](const auto& parameter) {
                           return std::string(parameter.param.table) + "_" +
                                  std::string(NameOf(parameter.param.scaling));
                         });

// Variances add up; those of the scaled columns to their number; a component's scores have its
// eigenvalue as variance and no covariance with another's.
TEST(Pca, KeepsItsLaws) {
  const Rows rows = Draw(400, 6, 3);
  const Result result = TrainPca(rows.X());
  double trace = 0.0;
  for (std::size_t j = 0; j < 6; ++j) {
    for (std::size_t i = 0; i < 400; ++i) {
      trace += std::pow(rows.X().Row(i)[j] - result.mean[j], 2) / 399.0;
    }
  }
  EXPECT_NEAR(result.TotalVariance(), trace, 1e-12 * trace);
  EXPECT_NEAR(TrainPca(rows.X(), {.scaling = Scaling::kStandard}).TotalVariance(), 6.0, 1e-12);
  for (std::size_t k = 0; k < 6; ++k) {
    double covariance = 0.0;  // of components k and 0
    for (std::size_t i = 0; i < 400; ++i) {
      double score = 0.0;
      double first = 0.0;
      for (std::size_t j = 0; j < 6; ++j) {
        score += result.Component(k)[j] * (rows.X().Row(i)[j] - result.mean[j]);
        first += result.Component(0)[j] * (rows.X().Row(i)[j] - result.mean[j]);
      }
      covariance += score * first / 399.0;
    }
    EXPECT_NEAR(covariance, k == 0 ? result.eigenvalues[0] : 0.0, 1e-11 * result.eigenvalues[0]);
  }
}

TEST(Pca, CountsComponentsByEnergy) {
  Result result;
  result.eigenvalues = {90.0, 8.0, 2.0, 0.0};
  EXPECT_EQ(result.NumComponentsFor(0.5), 1U);
  EXPECT_EQ(result.NumComponentsFor(0.9), 1U);
  EXPECT_EQ(result.NumComponentsFor(0.95), 2U);
  EXPECT_EQ(result.NumComponentsFor(0.99), 3U);
  EXPECT_EQ(result.NumComponentsFor(1.0), 3U);
  EXPECT_THROW(static_cast<void>(result.NumComponentsFor(0.0)), std::logic_error);
}

TEST(Pca, IsTheSameForAnyNumberOfThreads) {
  const Rows rows = Draw(3000, 8, 5);
  const Result one = TrainPca(rows.X(), {.num_threads = 1});
  const Result three = TrainPca(rows.X(), {.num_threads = 3});
  EXPECT_EQ(one.eigenvalues, three.eigenvalues);
  EXPECT_EQ(one.components, three.components);
}

TEST(Pca, InSinglePrecisionAgreesToSixDigitsOfTheLargestEigenvalue) {
  const Rows rows = Draw(3000, 8, 7);
  const Result exact = TrainPca(rows.X());
  const Result single = TrainPca(rows.X(), {.precision = ScatterPrecision::kSingle});
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(single.eigenvalues[k], exact.eigenvalues[k], 1e-6 * exact.eigenvalues[0]);
  }
}

TEST(Pca, OfMoreColumnsThanRowsHasZeroEigenvalues) {
  const Rows rows = Draw(4, 9, 9);
  const Result result = TrainPca(rows.X());
  EXPECT_GT(result.eigenvalues[2], 1e-3);
  for (std::size_t k = 3; k < 9; ++k)
    EXPECT_LT(result.eigenvalues[k], 1e-12 * result.eigenvalues[0]);
}

TEST(Pca, OfConstantColumnsHasNoEnergy) {
  const Rows rows{.num_columns = 2, .values = {7.0, 1.0, 7.0, 1.0, 7.0, 1.0}};
  for (const Scaling scaling : {Scaling::kNone, Scaling::kStandard}) {
    const Result result = TrainPca(rows.X(), {.scaling = scaling});
    EXPECT_EQ(result.TotalVariance(), 0.0);
    EXPECT_EQ(result.NumComponentsFor(0.99), 0U);
    EXPECT_EQ(result.scale, (std::vector<double>{1.0, 1.0}));
  }
}

TEST(Pca, RefusesWhatHasNoVariance) {
  const Rows rows{.num_columns = 2, .values = {7.0, 1.0}};
  EXPECT_THROWS_MESSAGE(TrainPca(rows.X()), Error, HasSubstr("one sample has no variance"));
  EXPECT_THROWS_MESSAGE(TrainPca(DesignMatrix<float>{}), Error, HasSubstr("is empty"));
  EXPECT_THROWS_MESSAGE(
      TrainPca(rows.X(), {.num_threads = 0}), Error, HasSubstr("pca::Options.num_threads is 0"));
}

TEST(Pca, NamesTheNumberThatIsNotFinite) {
  Rows rows = Draw(20, 3, 11);
  rows.values[3 * 5 + 1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROWS_MESSAGE(TrainPca(rows.X()), Error, HasSubstr("row 5, column 1"));
}

}  // namespace
}  // namespace handcraft::pca
