// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/svm_model.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lib/runtime/model_parser.h"
#include "lib/runtime/svm_loader.h"
#include "tests/lib/runtime/some_models.h"

namespace handcraft::runtime {
namespace {

using features::SimilarityType;

SvmModel Load(const model_io::SvmModel& model) {
  const std::vector<std::uint8_t> bytes = model_io::Serialise(testing::SomeSvmModel(model));
  Result<SvmModel> loaded = LoadSvmModel(*ParseModel(bytes));
  EXPECT_TRUE(loaded) << loaded.error().message;
  return std::move(loaded).value();
}

std::vector<double> Decide(const SvmModel& model, const std::vector<double>& row) {
  const AlignedBuffer workspace(model.WorkspaceBytes());
  static_cast<void>(model.Predict(row, workspace.Bytes()));
  const std::span<const double> values = model.Decisions(workspace.Bytes());
  return {values.begin(), values.end()};
}

SvmModel::Prediction Predict(const SvmModel& model, const std::vector<double>& row) {
  const AlignedBuffer workspace(model.WorkspaceBytes());
  return model.Predict(row, workspace.Bytes());
}

TEST(SvmModel, DecidesByHand) {
  const SvmModel model = Load(testing::SomeSvm());
  // (x0', x1') = (2, 1)
  EXPECT_EQ(Decide(model, {2.5, 1.5}), (std::vector<double>{1.0, 5.0, 3.75}));
  const SvmModel::Prediction prediction = Predict(model, {2.5, 1.5});
  EXPECT_EQ(prediction.vote.winner, 0U);
  EXPECT_EQ(prediction.vote.margin, 1.0);
  EXPECT_FALSE(prediction.is_rejected);
  EXPECT_EQ(Predict(model, {-1.5, 5.5}).vote.winner, 1U);
  EXPECT_EQ(Predict(model, {-1.5, -5.5}).vote.winner, 2U);
}

TEST(SvmModel, EveryKernelByItsDefinition) {
  const std::vector<double> row = {1.25, 0.5};
  const double x0 = 0.75;
  const double x1 = 0.5;
  for (const bool single_precision : {false, true}) {
    for (const SimilarityType type :
         {SimilarityType::kLinear, SimilarityType::kPolynomial, SimilarityType::kRbf}) {
      model_io::SvmModel made = testing::SomeSvm();
      made.single_precision = single_precision;
      made.similarity = {.type = type, .degree = 3, .gamma = 0.5, .coef0 = 1.0};
      const auto kernel = [type, x0, x1](double s0, double s1) {
        const double inner = s0 * x0 + s1 * x1;
        if (type == SimilarityType::kLinear) return inner;
        if (type == SimilarityType::kPolynomial) return std::pow(0.5 * inner + 1.0, 3);
        return std::exp(-0.5 * (std::pow(s0 - x0, 2) + std::pow(s1 - x1, 2)));
      };
      const std::vector<double> values = Decide(Load(made), row);
      EXPECT_NEAR(values[0], kernel(1, 0) - kernel(0, 1), 1e-15);
      EXPECT_NEAR(values[1], kernel(1, 0) - kernel(-1, -1), 1e-15);
      EXPECT_NEAR(values[2], kernel(0, 1) - kernel(-1, -1) - 0.25, 1e-15);
    }
  }
}

TEST(SvmModel, RejectsBelowTheThreshold) {
  model_io::SvmModel made = testing::SomeSvm();
  made.rejection_threshold = 1.0;
  const SvmModel model = Load(made);
  EXPECT_FALSE(Predict(model, {2.5, 1.5}).is_rejected);  // at it
  EXPECT_TRUE(Predict(model, {2.25, 1.5}).is_rejected);
  EXPECT_EQ(Predict(model, {2.25, 1.5}).vote.winner, 0U);
}

TEST(SvmModel, OneAgainstAllTakesTheLargestValue) {
  model_io::SvmModel made = testing::SomeSvm();
  made.scheme = features::ClassScheme::kOneAgainstAll;
  const SvmModel model = Load(made);
  EXPECT_EQ(Predict(model, {2.5, 1.5}).vote.winner, 1U);  // of 1, 5 and 3.75
}

}  // namespace
}  // namespace handcraft::runtime
