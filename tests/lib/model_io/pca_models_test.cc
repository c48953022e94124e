// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/pca_models.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/model_io/column_names.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::model_io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

PcaModel SomePca() {
  return {.components = {0.6, 0.8},
          .eigenvalues = {25.0, 0.0},
          .feature_mean = {3.0, 5.0},
          .feature_scale = {1.0, 2.0}};
}

TEST(MakePcaModel, ComesBackAsItWas) {
  const ModelFile model =
      Parse(Serialise(MakePcaModel({"a", "b"}, SomePca(), {.name = "line"})), "m");
  EXPECT_EQ(model.metadata.at("hc.kind"), "pca");
  EXPECT_EQ(model.metadata.at("hc.kind_version"), "1");
  EXPECT_EQ(model.metadata.at("hc.name"), "line");
  EXPECT_THAT(ColumnNamesOf(model), ElementsAre("a", "b"));
  EXPECT_EQ(model.tensors.at("components").shape, (std::vector<std::int64_t>{1, 2}));
  EXPECT_THAT(std::get<std::vector<double>>(model.tensors.at("components").values),
              ElementsAre(0.6, 0.8));
  EXPECT_THAT(std::get<std::vector<double>>(model.tensors.at("eigenvalues").values),
              ElementsAre(25.0, 0.0));
  EXPECT_THAT(std::get<std::vector<double>>(model.tensors.at("feature_scale").values),
              ElementsAre(1.0, 2.0));
}

// It is no model for a robot: the runtime says that it does not know the kind.
TEST(MakePcaModel, IsRefusedByTheRuntime) {
  const std::vector<std::uint8_t> bytes = Serialise(MakePcaModel({"a", "b"}, SomePca(), {}));
  hc_model* model = nullptr;
  hc_error error{};
  EXPECT_EQ(hc_model_load_memory(bytes.data(), bytes.size(), &model, &error), HC_ERROR_KIND);
  EXPECT_THAT(error.message, HasSubstr("pca"));
}

TEST(MakePcaModel, RefusesSizesThatDoNotFit) {
  for (std::vector<double> PcaModel::*member : {&PcaModel::components,
                                                &PcaModel::eigenvalues,
                                                &PcaModel::feature_mean,
                                                &PcaModel::feature_scale}) {
    PcaModel model = SomePca();
    (model.*member).pop_back();
    EXPECT_THROW(static_cast<void>(MakePcaModel({"a", "b"}, model, {})), std::logic_error);
  }
  EXPECT_THROW(static_cast<void>(MakePcaModel({}, {}, {})), std::logic_error);
}

}  // namespace
}  // namespace handcraft::model_io
