// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/svm_loader.h"

#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/runtime/model_parser.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/lib/runtime/stored_model.h"

namespace handcraft::runtime {
namespace {

using model_io::ModelFile;
using testing::In;
using Integers = std::vector<std::int32_t>;
using Numbers = std::vector<double>;

Result<SvmModel> Load(const ModelFile& model) { return testing::LoadStored<&LoadSvmModel>(model); }

void ExpectRefused(const std::function<void(ModelFile&)>& change,
                   const std::string& message,
                   hc_status status = HC_ERROR_CONTENT) {
  testing::ExpectRefusal<&LoadSvmModel>(testing::SomeSvmModel(), change, message, status);
}

TEST(LoadSvmModel, KeepsNamesAndSizes) {
  const auto model = Load(testing::SomeSvmModel());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->NumFeatures(), 2U);
  EXPECT_EQ(model->NumMachines(), 3U);
  EXPECT_EQ(model->ClassNames(), (std::vector<std::string>{"bottle", "mug", "drill"}));
}

TEST(LoadSvmModel, ReadsSupportVectorsOfEitherPrecision) {
  model_io::SvmModel model = testing::SomeSvm();
  model.single_precision = false;
  EXPECT_TRUE(Load(testing::SomeSvmModel(model)));
}

TEST(LoadSvmModel, RefusesEachMissingTensor) {
  const ModelFile whole = testing::SomeSvmModel();
  EXPECT_EQ(whole.tensors.size(), 19U);
  for (const auto& entry : whole.tensors) {
    const std::string& name = entry.first;
    ExpectRefused([&](ModelFile& model) { model.tensors.erase(name); },
                  "the tensor '" + name + "' ");
  }
}

TEST(LoadSvmModel, RefusesNumbersOutOfRange) {
  const auto set = [](const std::string& name, std::size_t entry, std::int32_t value) {
    return [=](ModelFile& model) { In<std::int32_t>(model, name)[entry] = value; };
  };
  ExpectRefused(set("kernel", 0, 3), "entry 0 of the tensor 'kernel' is 3; a number from 0 to 2");
  ExpectRefused(set("kernel_degree", 0, 0), "'kernel_degree' is 0; a number from 1 to 1000");
  ExpectRefused(set("scheme", 0, 2), "'scheme' is 2; a number from 0 to 1");
  ExpectRefused(set("num_classes", 0, 1), "'num_classes' is 1; a number from 2 to 4096");
  ExpectRefused(set("support_classes", 1, 3),
                "entry 1 of the tensor 'support_classes' is 3; a number from 0 to 2");
  ExpectRefused(set("machine_supports", 5, 3),
                "entry 5 of the tensor 'machine_supports' is 3; a number from 0 to 2");
  ExpectRefused(set("machine_supports", 5, -1), "'machine_supports' is -1; a number from 0");
  ExpectRefused(set("machine_begins", 0, 1), "entry 0 of the tensor 'machine_begins' is 1");
  ExpectRefused(set("machine_begins", 2, 1),
                "entry 2 of the tensor 'machine_begins' is 1; a number from 2 to 6");
  ExpectRefused(set("machine_begins", 1, 7), "entry 1 of the tensor 'machine_begins' is 7");
  ExpectRefused(set("machine_begins", 3, 5),
                "entry 3 of the tensor 'machine_begins' is 5; a number from 6 to 6");
  ExpectRefused([](ModelFile& model) { In<double>(model, "kernel_gamma")[0] = 0.0; },
                "'kernel_gamma' holds 0; a number above 0");
  ExpectRefused([](ModelFile& model) { In<double>(model, "feature_scale")[1] = 0.0; },
                "entry 1 of the tensor 'feature_scale' is 0");
  ExpectRefused([](ModelFile& model) { In<double>(model, "selftest.tolerance")[0] = 0.01; },
                "'selftest.tolerance' holds 0.01; above 0 and at most 0.001");
}

TEST(LoadSvmModel, RefusesContradictions) {
  ExpectRefused([](ModelFile& model) { In<std::int32_t>(model, "num_classes")[0] = 4; },
                "the tensor 'class_names' holds 3 names for 4 classes");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["intercepts"] = {Numbers{0.0, 0.0}, {2}};
      },
      "the tensor 'intercepts' is F64[2] where F64[3] was expected");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["support_vectors"] = {Numbers(9, 0.0), {3, 3}};
      },
      "the tensor 'support_vectors' is F64[3,3] where F64[?,2] was expected");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["support_vectors"] = {Integers(6, 0), {3, 2}};
      },
      "the tensor 'support_vectors' is I32[3,2] where F64[?,2] was expected");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["probability_a"] = {Numbers{1.0}, {1}};
      },
      "the tensor 'probability_a' is unknown");
}

TEST(LoadSvmModel, RunsTheSelfTest) {
  ExpectRefused([](ModelFile& model) { In<double>(model, "dual_coefficients")[0] = 1.000001; },
                "the self-test gives ",
                HC_ERROR_SELF_TEST);
}

}  // namespace
}  // namespace handcraft::runtime
