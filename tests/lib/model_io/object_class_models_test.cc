// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/object_class_models.h"

#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using ::testing::HasSubstr;
using testing::SomeObjectClasses;
using testing::SomeObjectClassModel;

TEST(ObjectClassModels, ThereAndBack) {
  ObjectClassModel model = SomeObjectClasses();
  model.descriptor.scaling = features::CloudScaling::kUnit;
  model.descriptor.frame = features::CloudFrame::kCamera;
  model.descriptor.box = features::GridBox::kSquare;
  model.outlier_step = 2.5;
  const ModelFile file = SomeObjectClassModel(model);
  const ObjectClassModel back = ReadObjectClassModel(Parse(Serialise(file), "test"));
  EXPECT_EQ(back.descriptor.type, features::CloudDescriptorType::kDepthGrid);
  EXPECT_EQ(back.descriptor.grid_size, 2);
  EXPECT_EQ(back.descriptor.scaling, features::CloudScaling::kUnit);
  EXPECT_EQ(back.descriptor.frame, features::CloudFrame::kCamera);
  EXPECT_EQ(back.descriptor.box, features::GridBox::kSquare);
  EXPECT_EQ(back.outlier_step, 2.5);
  EXPECT_EQ(back.classes, model.classes);
  EXPECT_EQ(back.svm.support_vectors, model.svm.support_vectors);
  EXPECT_THAT(file.metadata.at("hc.frames"), HasSubstr("camera"));
  EXPECT_THAT(SomeObjectClassModel().metadata.at("hc.frames"), HasSubstr("base"));
}

TEST(ObjectClassModels, TheSelfTestIsAThinnedCloudOfTheObjectAlone) {
  const testing::SomeObject object(200, 100);
  const ModelFile file = MakeObjectClassModel(SomeObjectClasses(), object.View(), {});
  const Tensor& points = file.tensors.at("selftest.input");
  EXPECT_THAT(points.shape, ::testing::ElementsAre(::testing::Le(48), ::testing::Le(48), 3));
  EXPECT_GT(points.shape[1], 24);
  for (const float value : std::get<std::vector<float>>(points.values)) {
    EXPECT_FALSE(std::isnan(value));
  }
}

TEST(ObjectClassModels, RefuseOtherKindsSizesAndEmptyClouds) {
  EXPECT_THROWS_MESSAGE(static_cast<void>(ReadObjectClassModel(testing::SomeSvmModel())),
                        Error,
                        HasSubstr("of kind 'svm', not of kind object_class (give a model made by "
                                  "'handcraft train object-class')"));
  ObjectClassModel model = SomeObjectClasses();
  model.descriptor.grid_size = 3;
  EXPECT_THROW(static_cast<void>(SomeObjectClassModel(model)), std::logic_error);
  testing::SomeObject object(12, 10);
  object.mask.assign(object.mask.size(), 0);
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(MakeObjectClassModel(SomeObjectClasses(), object.View(), {})),
      Error,
      HasSubstr("too few measured points"));
}

}  // namespace
}  // namespace handcraft::model_io
