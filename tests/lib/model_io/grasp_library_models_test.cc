// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/grasp_library_models.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using features::GraspLibrary;
using features::testing::SomeGraspLibrary;

const GraspLibraryNames kNames = {.classes = {"mug", "drill"}};

TEST(GraspLibraryModels, TellFramesUnitsAndJoints) {
  const ModelFile file = testing::SomeGraspLibraryModel();
  EXPECT_EQ(file.metadata.at("hc.kind"), "grasp_library");
  EXPECT_EQ(file.metadata.at("hc.frames"),
            "base (x forward, y left, z up) grasp_centre (z approach axis, x closing axis)");
  EXPECT_EQ(file.metadata.at("hc.units"), "m rad");
  EXPECT_EQ(file.metadata.at("hc.quaternion_order"), "xyzw");
  EXPECT_EQ(file.metadata.at("hc.robot"), "some_robot");
  EXPECT_EQ(file.metadata.at("hc.joint_names"), "j1 j2");
  const ModelFile silent = MakeGraspLibraryModel(SomeGraspLibrary(), kNames, {});
  EXPECT_FALSE(silent.metadata.contains("hc.robot"));
  EXPECT_FALSE(silent.metadata.contains("hc.joint_names"));
}

TEST(GraspLibraryModels, TheSameModelIsTheSameBytes) {
  EXPECT_EQ(Serialise(testing::SomeGraspLibraryModel()),
            Serialise(testing::SomeGraspLibraryModel()));
}

TEST(GraspLibraryModels, HaveNoRejectionUnlessItIsWanted) {
  GraspLibrary library = SomeGraspLibrary();
  EXPECT_TRUE(MakeGraspLibraryModel(library, kNames, {}).tensors.contains("rejection_distance"));
  library.rejection_distance_m.reset();
  EXPECT_FALSE(MakeGraspLibraryModel(library, kNames, {}).tensors.contains("rejection_distance"));
}

TEST(GraspLibraryModels, RefuseWhatDoesNotFit) {
  const auto make = [](const GraspLibrary& library) {
    static_cast<void>(MakeGraspLibraryModel(library, kNames, {}));
  };
  GraspLibrary library = SomeGraspLibrary();
  library.rotations.pop_back();
  EXPECT_THROW(make(library), std::logic_error);
  library = SomeGraspLibrary();
  library.view_normals.pop_back();
  EXPECT_THROW(make(library), std::logic_error);
  EXPECT_THROW(make(GraspLibrary{}), std::logic_error);
  EXPECT_THROW(
      static_cast<void>(MakeGraspLibraryModel(SomeGraspLibrary(), {.classes = {"mug", ""}}, {})),
      Error);
}

}  // namespace
}  // namespace handcraft::model_io
