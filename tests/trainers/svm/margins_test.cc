// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/margins.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/some_models.h"
#include "trainers/svm/svm.h"

namespace handcraft::svm {
namespace {

template <class T>
struct Rows {
  std::vector<T> values;
  std::vector<std::uint32_t> classes;

  [[nodiscard]] DesignMatrix<T> Matrix() const { return {values.data(), values.size() / 2, 2, 2}; }
};

// Rows of three classes around three places.
template <class T>
Rows<T> DrawRows(std::uint64_t seed) {
  Rng rng(seed);
  Rows<T> rows;
  for (std::uint32_t i = 0; i < 45; ++i) {
    const std::uint32_t c = i % 3;
    rows.values.push_back(static_cast<T>(2.0 * c + rng.Normal()));
    rows.values.push_back(static_cast<T>(c == 1 ? 3.0 + rng.Normal() : rng.Normal()));
    rows.classes.push_back(c);
  }
  return rows;
}

// The runtime, which reads the model from its file, is the oracle.
template <class T>
void ExpectTheRuntimes(const Options& options) {
  const Rows<T> known = DrawRows<T>(1);
  const model_io::SvmModel model = TrainSvm(known.Matrix(), known.classes, options).model;
  const testing::Model loaded = testing::Load(testing::SomeSvmModel(model));
  hc_workspace* scratch = nullptr;
  ASSERT_EQ(hc_row_workspace_create(loaded.get(), &scratch), HC_OK);
  const testing::Workspace workspace(scratch);
  const Rows<T> asked = DrawRows<T>(2);
  const std::vector<double> margins = MarginsOf(model, asked.Matrix());
  ASSERT_EQ(margins.size(), 45U);
  for (std::size_t i = 0; i < margins.size(); ++i) {
    const double row[] = {static_cast<double>(asked.values[2 * i]),
                          static_cast<double>(asked.values[2 * i + 1])};
    hc_class_prediction prediction{};
    ASSERT_EQ(hc_classify_row(loaded.get(), workspace.get(), row, 2, &prediction), HC_OK);
    EXPECT_NEAR(margins[i], prediction.margin, 1e-9);
  }
  EXPECT_EQ(margins, MarginsOf(model, asked.Matrix(), 3));
}

TEST(MarginsOf, AreTheRuntimes) {
  for (const bool standardize : {false, true}) {
    for (const auto kernel : {features::SimilarityType::kLinear,
                              features::SimilarityType::kPolynomial,
                              features::SimilarityType::kRbf}) {
      const Options options{.kernel = kernel, .coef0 = 1.0, .standardize = standardize};
      ExpectTheRuntimes<double>(options);
      ExpectTheRuntimes<float>(options);
    }
  }
  ExpectTheRuntimes<double>({.scheme = features::ClassScheme::kOneAgainstAll});
}

TEST(MarginsOf, OfNumbersThatAreNotFiniteAreNotFinite) {
  const std::vector<double> rows = {
      1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0.0};
  for (const double margin :
       MarginsOf(testing::SomeSvm(), DesignMatrix<double>{rows.data(), 2, 2, 2})) {
    EXPECT_FALSE(std::isfinite(margin));
  }
  EXPECT_TRUE(MarginsOf(testing::SomeSvm(), DesignMatrix<double>{nullptr, 0, 2, 2}).empty());
}

// Held-out margins are those of models that were trained without the fold.
TEST(CrossValidateLike, AreTheMarginsOfModelsWithoutTheFold) {
  const Rows<double> rows = DrawRows<double>(3);
  const Options options{.kernel = features::SimilarityType::kRbf, .gamma = 0.2, .penalty = 2.0};
  model_io::SvmModel model = TrainSvm(rows.Matrix(), rows.classes, options).model;
  model.feature_mean = {1.0, -1.0};
  model.feature_scale = {2.0, 0.5};
  std::vector<std::uint32_t> folds(45);
  for (std::uint32_t i = 0; i < 45; ++i) folds[i] = i / 15;
  // Kernel and normaliser are the model's, whatever the options say.
  const CrossValidation validation = CrossValidateLike(
      model,
      rows.Matrix(),
      rows.classes,
      folds,
      {.kernel = features::SimilarityType::kLinear, .penalty = 2.0, .standardize = true});
  Rows<double> scaled = rows;
  for (std::size_t i = 0; i < 45; ++i) {
    scaled.values[2 * i] = (rows.values[2 * i] - 1.0) / 2.0;
    scaled.values[2 * i + 1] = (rows.values[2 * i + 1] + 1.0) / 0.5;
  }
  Rows<double> kept;  // all but the middle fold
  for (std::size_t i = 0; i < 45; ++i) {
    if (folds[i] == 1) continue;
    kept.values.insert(kept.values.end(), {scaled.values[2 * i], scaled.values[2 * i + 1]});
    kept.classes.push_back(rows.classes[i]);
  }
  const model_io::SvmModel without = TrainSvm(kept.Matrix(), kept.classes, options).model;
  const std::vector<double> margins = MarginsOf(without, scaled.Matrix());
  for (std::size_t i = 15; i < 30; ++i) EXPECT_NEAR(validation.margins[i], margins[i], 1e-9);
}

}  // namespace
}  // namespace handcraft::svm
