// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/logistic_model.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/runtime/model_parser.h"
#include "tests/lib/runtime/some_models.h"

namespace handcraft::runtime {
namespace {

using model_io::ModelFile;
using ::testing::HasSubstr;

Result<LogisticModel> Load(const ModelFile& model) {
  const std::vector<std::uint8_t> bytes = model_io::Serialise(model);
  return LoadLogisticModel(*ParseModel(bytes));
}

void ExpectRefused(const std::function<void(ModelFile&)>& change,
                   const std::string& message,
                   hc_status status = HC_ERROR_CONTENT) {
  ModelFile model = testing::SomeLogisticModel();
  change(model);
  const auto loaded = Load(model);
  ASSERT_FALSE(loaded) << message;
  EXPECT_EQ(loaded.error().status, status) << loaded.error().message;
  EXPECT_THAT(loaded.error().message, HasSubstr(message));
}

double Probability(const LogisticModel& model, std::initializer_list<double> row) {
  return model.Probability(std::span(row.begin(), row.size()));
}

TEST(LogisticModel, PredictsByHand) {
  const LogisticModel model{{2.0, -3.0}, 1.0};
  EXPECT_EQ(Probability(model, {1.0, 1.0}), 0.5);
  // z = 1 + 2 ln 2 - 1 = ln 4.
  EXPECT_NEAR(Probability(model, {std::log(2.0), 1.0 / 3.0}), 0.8, 1e-15);
  EXPECT_NEAR(Probability(model, {-std::log(2.0), 1.0 / 3.0}), 0.2, 1e-15);
}

TEST(LogisticModel, StaysBetweenZeroAndOneAndIsSymmetric) {
  const LogisticModel model{{1.0}, 0.0};
  for (const double z : {1e-300, 1e-3, 1.0, 36.0, 700.0, 745.0, 1e4, 1e308}) {
    const double above = Probability(model, {z});
    const double below = Probability(model, {-z});
    EXPECT_TRUE(above >= 0.5 && above <= 1.0) << z;
    EXPECT_TRUE(below >= 0.0 && below <= 0.5) << z;
    EXPECT_NEAR(above + below, 1.0, 1e-15) << z;
  }
}

TEST(LoadLogisticModel, KeepsTheNumbers) {
  const auto model = Load(testing::SomeLogisticModel());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->weights, (std::vector<double>{2.0, -3.0}));
  EXPECT_EQ(model->intercept, 1.0);
}

TEST(LoadLogisticModel, RefusesEachMissingTensor) {
  const ModelFile whole = testing::SomeLogisticModel();
  EXPECT_EQ(whole.tensors.size(), 8U);
  for (const auto& entry : whole.tensors) {
    const std::string& name = entry.first;
    ExpectRefused([&](ModelFile& model) { model.tensors.erase(name); },
                  "the tensor '" + name + "' ");
  }
}

TEST(LoadLogisticModel, RefusesContradictions) {
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["column_names"] = {std::vector<std::uint8_t>{'a', '\n', 'b', '\n', 'c'}, {5}};
      },
      "the tensor 'column_names' holds 3 names for 2 weights");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["column_names"] = {std::vector<std::uint8_t>{'a', '\n', 0xE9}, {3}};
      },
      "the tensor 'column_names' is not UTF-8 here");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["weights"] = {std::vector<double>{1, 2, 3}, {3}};
      },
      "the tensor 'feature_mean' is F64[2] where F64[3] was expected");
  ExpectRefused([](ModelFile& model) { model.tensors["bias"] = model.tensors["intercept"]; },
                "the tensor 'bias' is unknown");
}

TEST(LoadLogisticModel, RunsTheSelfTest) {
  ExpectRefused(
      [](ModelFile& model) { model.tensors["intercept"].values = std::vector<double>{1.001}; },
      "the self-test gives",
      HC_ERROR_SELF_TEST);
  // Finite weights whose products are not: the sum is NaN.
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["weights"].values = std::vector<double>{1e308, -1e308};
        model.tensors["selftest.input"].values = std::vector<double>(6, 1e308);
      },
      "the self-test gives",
      HC_ERROR_SELF_TEST);
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["selftest.tolerance"].values = std::vector<double>{0.5};
      },
      "the tensor 'selftest.tolerance' holds 0.5");
}

}  // namespace
}  // namespace handcraft::runtime
