// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/svm_tensors.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lib/model_io/same_svm.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using ::testing::HasSubstr;
using Names = std::vector<std::string>;

TEST(SvmTensors, ThereAndBack) {
  SvmModel model = testing::SomeSvm();
  model.rejection_threshold = 0.25;
  ModelFile file;
  AddSvmTensors(model, {"a", "b", "c"}, file);
  EXPECT_EQ(file.tensors.size(), 16U);
  testing::ExpectSame(ReadSvmTensors(file), model);
}

TEST(SvmTensors, DecideByHand) {
  EXPECT_EQ(DecisionValues(testing::SomeSvm(), std::vector<double>{2.5, 1.5}),
            (std::vector<double>{1.0, 5.0, 3.75}));
}

TEST(SvmTensors, RefuseWhatDoesNotFit) {
  ModelFile file;
  SvmModel model = testing::SomeSvm();
  EXPECT_THROW(AddSvmTensors(model, Names{"a", "b"}, file), std::logic_error);
  model.support_vectors.pop_back();
  EXPECT_THROW(AddSvmTensors(model, Names{"a", "b", "c"}, file), std::logic_error);
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(ReadSvmTensors({})), Error, HasSubstr("the tensor 'kernel' is missing"));
}

TEST(SvmTensors, NamesTheKindItWanted) {
  const ModelFile file = testing::SomeLogisticModel();
  EXPECT_NO_THROW(RequireKind(file, "logistic", "handcraft train logistic"));
  EXPECT_THROWS_MESSAGE(RequireKind(file, "svm", "handcraft train svm"),
                        Error,
                        HasSubstr("of kind 'logistic', not of kind svm (give a model made by "
                                  "'handcraft train svm')"));
}

TEST(SvmTensors, TieRules) {
  EXPECT_THAT(TieRuleOf(features::ClassScheme::kOneAgainstOne), HasSubstr("votes"));
  EXPECT_THAT(TieRuleOf(features::ClassScheme::kOneAgainstAll), HasSubstr("largest"));
}

}  // namespace
}  // namespace handcraft::model_io
