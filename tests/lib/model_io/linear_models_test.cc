// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/linear_models.h"

#include <cmath>
#include <stdexcept>

#include "lib/core/error.h"
#include "lib/model_io/column_names.h"
#include "lib/runtime/handcraft_runtime.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class T>
const std::vector<T>& ValuesOf(const ModelFile& model, const std::string& name) {
  return std::get<std::vector<T>>(model.tensors.at(name).values);
}

TEST(MakeLogisticModel, HoldsTheNumbersItWasGiven) {
  const ModelFile model = testing::SomeLogisticModel();
  EXPECT_EQ(ValuesOf<double>(model, "weights"), (std::vector<double>{2.0, -3.0}));
  EXPECT_EQ(ValuesOf<double>(model, "feature_mean"), (std::vector<double>{0.5, -0.5}));
  EXPECT_THAT(ColumnNamesOf(model), ElementsAre("length_m", "width_m"));
  EXPECT_EQ(model.metadata.at("hc.kind"), "logistic");
  EXPECT_EQ(model.metadata.at("hc.labels.0"), "no");
  EXPECT_EQ(model.metadata.at("hc.labels.1"), "yes");
  EXPECT_EQ(model.metadata.at("hc.label_column"), "fits");
}

// The mean row, and one scale up and down in turns; z = 1 + 2 x0 - 3 x1.
TEST(MakeLogisticModel, TakesSelfTestRowsFromMeanAndScale) {
  const ModelFile model = testing::SomeLogisticModel();
  EXPECT_EQ(ValuesOf<double>(model, "selftest.input"),
            (std::vector<double>{0.5, -0.5, 1.5, -2.5, -0.5, 1.5}));
  const std::vector<double>& expected = ValuesOf<double>(model, "selftest.output");
  ASSERT_EQ(expected.size(), 3U);
  EXPECT_NEAR(expected[0], 1.0 / (1.0 + std::exp(-3.5)), 1e-15);
  EXPECT_NEAR(expected[1], 1.0 / (1.0 + std::exp(-11.5)), 1e-15);
  EXPECT_NEAR(expected[2], 1.0 / (1.0 + std::exp(4.5)), 1e-15);
}

TEST(MakeLogisticModel, WritesMoreColumnsThanTextWouldHold) {
  LinearModel linear;
  linear.weights.assign(7500, 1e-3);
  std::vector<std::string> names;
  names.reserve(7500);
  for (int i = 0; i < 7500; ++i) names.push_back("a long column name " + std::to_string(i));
  const ModelFile model =
      Parse(Serialise(MakeLogisticModel(names, "label", "0", "1", linear, Provenance{})), "m");
  EXPECT_EQ(ColumnNamesOf(model), names);
  EXPECT_EQ(ValuesOf<double>(model, "feature_scale"), std::vector<double>(7500, 1.0));
}

TEST(MakeLogisticModel, RefusesNamesThatCannotBeToldApartLater) {
  const LinearModel linear{.weights = {1.0, 2.0}, .feature_mean = {}, .feature_scale = {}};
  for (const std::string bad : {"", "two\nlines"}) {
    EXPECT_THROWS_MESSAGE(MakeLogisticModel({"a", bad}, "l", "0", "1", linear, Provenance{}),
                          Error,
                          HasSubstr("the name of column 2 is empty or has a line break"));
  }
  EXPECT_THROWS_MESSAGE(MakeLogisticModel({"a", "\xE9"}, "l", "0", "1", linear, Provenance{}),
                        Error,
                        HasSubstr("the name of column 2 is not UTF-8"));
}

TEST(MakeLogisticModel, RefusesSizesThatDoNotFit) {
  const LinearModel linear{.weights = {1.0, 2.0}, .feature_mean = {}, .feature_scale = {}};
  EXPECT_THROW(static_cast<void>(MakeLogisticModel({"a"}, "l", "0", "1", linear, Provenance{})),
               std::logic_error);
  const LinearModel half{.weights = {1.0}, .feature_mean = {0.0}, .feature_scale = {}};
  EXPECT_THROW(static_cast<void>(MakeLogisticModel({"a"}, "l", "0", "1", half, Provenance{})),
               std::logic_error);
}

TEST(MakeGraspPointModel, HoldsTheNumbersItWasGiven) {
  const features::FeatureSpec spec = features::ParseFeatureSpec("filters=edge_30+cb_LL,window=1");
  LinearModel linear{.weights = {0.1, -0.2},
                     .intercept = 0.3,
                     .feature_mean = {4.0, 5.0},
                     .feature_scale = {6.0, 7.0}};
  const ModelFile model = MakeGraspPointModel(spec, linear, Provenance{});
  EXPECT_THAT(ValuesOf<float>(model, "weights"), ElementsAre(0.1F, -0.2F));
  EXPECT_THAT(ValuesOf<double>(model, "intercept"), ElementsAre(0.3));
  EXPECT_THAT(ValuesOf<double>(model, "feature_mean"), ElementsAre(4.0, 5.0));
  EXPECT_THAT(ValuesOf<double>(model, "feature_scale"), ElementsAre(6.0, 7.0));
  EXPECT_THAT(ValuesOf<std::int32_t>(model, "filter_ids"), ElementsAre(10, 20));
  EXPECT_THAT(ValuesOf<std::int32_t>(model, "window"), ElementsAre(1));
  EXPECT_EQ(model.tensors.count("scales"), 0U);
  EXPECT_EQ(model.tensors.at("filters").shape, (std::vector<std::int64_t>{2, 2, 7, 7}));
  // Edge masks are divided by 2000 and sit in the middle of 7 x 7: row 1, column 1.
  EXPECT_EQ(ValuesOf<float>(model, "filters")[8],
            features::KernelsOf(features::Filter::kEdge30).components[0][1][1]);
  EXPECT_EQ(model.metadata.at("hc.features"), features::ToString(spec));
  EXPECT_EQ(model.metadata.at("hc.labels.1"), "grasp_point");
}

TEST(MakeGraspPointModel, WritesItsOrigin) {
  Provenance provenance;
  provenance.name = "mugs";
  provenance.licence = "CC0-1.0";
  provenance.algorithm = "logistic_irls";
  provenance.data_fingerprint = "abc";
  provenance.class_counts = "0: 3, 1: 4";
  provenance.hyper_parameters = {{"ridge", "0.5"}, {"seed", "7"}};
  provenance.metrics = {{"auc", "0.9"}};
  const LinearModel linear{.weights = {1.0}, .feature_mean = {}, .feature_scale = {}};
  const ModelFile model = MakeGraspPointModel(
      features::ParseFeatureSpec("filters=laplacian,window=1"), linear, provenance);
  EXPECT_EQ(model.metadata.at("hc.name"), "mugs");
  EXPECT_EQ(model.metadata.at("hc.version"), "1");
  EXPECT_EQ(model.metadata.at("hc.licence"), "CC0-1.0");
  EXPECT_EQ(model.metadata.at("hc.training.algorithm"), "logistic_irls");
  EXPECT_EQ(model.metadata.at("hc.training.data_fingerprint"), "abc");
  EXPECT_EQ(model.metadata.at("hc.training.class_counts"), "0: 3, 1: 4");
  EXPECT_EQ(model.metadata.at("hc.training.ridge"), "0.5");
  EXPECT_EQ(model.metadata.at("hc.metrics.auc"), "0.9");
  EXPECT_EQ(model.metadata.at("hc.tool"), std::string("handcraft ") + hc_version());
  EXPECT_FALSE(model.metadata.at("hc.tool.compiler").empty());
  EXPECT_EQ(model.metadata.count("hc.task"), 0U) << "empty texts are left out";
  EXPECT_EQ(model.metadata.count("hc.created"), 0U);
}

TEST(MakeGraspPointModel, RefusesSizesThatDoNotFit) {
  const LinearModel linear{.weights = {1.0, 2.0}, .feature_mean = {}, .feature_scale = {}};
  EXPECT_THROW(static_cast<void>(MakeGraspPointModel(
                   features::ParseFeatureSpec("edges54"), linear, Provenance{})),
               std::logic_error);
}

TEST(MakeGraspPointModel, WritesWhatTheRuntimeLoads) {
  for (const std::string_view spec : {"all500",
                                      "all500,energy=log",
                                      "edges150",
                                      "window180,energy=abs",
                                      "edges54",
                                      "saxena459"}) {
    const std::vector<std::uint8_t> bytes = Serialise(testing::SomeGraspPointModel(spec));
    hc_model* model = nullptr;
    hc_error error{};
    EXPECT_EQ(hc_model_load_memory(bytes.data(), bytes.size(), &model, &error), HC_OK)
        << error.message;
    hc_model_free(model);
  }
}

// Numbers that no photograph is worth are still refused with a reason, not written.
TEST(MakeGraspPointModel, LeavesNumbersThatAreNotFiniteToTheWriter) {
  const LinearModel linear{.weights = {1e300}, .feature_mean = {}, .feature_scale = {}};
  const ModelFile model = MakeGraspPointModel(
      features::ParseFeatureSpec("filters=laplacian,window=1"), linear, Provenance{});
  EXPECT_THROWS_MESSAGE(Serialise(model), Error, HasSubstr("is not a finite number"));
}

}  // namespace
}  // namespace handcraft::model_io
