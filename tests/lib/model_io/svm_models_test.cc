// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/svm_models.h"

#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/lib/model_io/same_svm.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using ::testing::HasSubstr;
using testing::SomeSvm;
using testing::SomeSvmModel;
using testing::SomeSvmNames;

TEST(SvmModels, ComeBackFromTheFile) {
  for (const bool single_precision : {false, true}) {
    SvmModel model = SomeSvm();
    model.single_precision = single_precision;
    if (single_precision) model.rejection_threshold = 0.25;
    const ModelFile file = Parse(Serialise(SomeSvmModel(model)), "memory");
    testing::ExpectSame(ReadSvmModel(file), model);
    const SvmNames names = ReadSvmNames(file);
    EXPECT_EQ(names.columns, SomeSvmNames().columns);
    EXPECT_EQ(names.classes, SomeSvmNames().classes);
    EXPECT_EQ(names.label_column, "object");
  }
}

TEST(SvmModels, TheSameModelIsTheSameBytes) {
  EXPECT_EQ(Serialise(SomeSvmModel()), Serialise(SomeSvmModel()));
}

TEST(SvmModels, SelfTestByHand) {
  const ModelFile file = SomeSvmModel();
  // The mean row is 0, the others the support vectors (1, 0) and (−1, −1).
  EXPECT_EQ(std::get<std::vector<double>>(file.tensors.at("selftest.input").values),
            (std::vector<double>{0.5, -0.5, 1.5, -0.5, -0.5, -2.5}));
  EXPECT_EQ(std::get<std::vector<double>>(file.tensors.at("selftest.output").values),
            (std::vector<double>{0.0, 0.0, -0.25, 1.0, 2.0, 0.75, 0.0, -3.0, -3.25}));
}

TEST(SvmModels, RefuseOtherKindsAndNames) {
  EXPECT_THROWS_MESSAGE((ReadSvmModel(testing::SomeLogisticModel())),
                        Error,
                        HasSubstr("a model of kind 'logistic', not of kind svm"));
  ModelFile file = SomeSvmModel();
  file.tensors.erase("intercepts");
  EXPECT_THROWS_MESSAGE((ReadSvmModel(file)),
                        Error,
                        HasSubstr("the tensor 'intercepts' is missing or of another type"));
  SvmNames names = SomeSvmNames();
  names.classes[1] = "";
  EXPECT_THROWS_MESSAGE((MakeSvmModel(SomeSvm(), names, {})),
                        Error,
                        HasSubstr("the name of class 2 is empty or has a line break"));
  names = SomeSvmNames();
  names.columns.pop_back();
  EXPECT_THROW(static_cast<void>(MakeSvmModel(SomeSvm(), names, {})), std::logic_error);
}

}  // namespace
}  // namespace handcraft::model_io
