// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

ViewSettings Applied(std::initializer_list<Setting> list) {
  ViewSettings settings;
  for (const Setting& setting : list) ApplyViewSetting(setting, settings);
  return settings;
}

TEST(ViewSettings, EveryKeyIsTaken) {
  const ViewSettings settings = Applied({{"descriptor", "polar"},
                                         {"grid_size", "20"},
                                         {"scaling", "unit"},
                                         {"frame", "camera"},
                                         {"outlier_step", "3"},
                                         {"box", "square"},
                                         {"moved_copies", "4"},
                                         {"kernel", "rbf"},
                                         {"degree", "2"},
                                         {"gamma", "0.5"},
                                         {"coef0", "0"},
                                         {"C", "10"},
                                         {"scheme", "one-against-all"},
                                         {"standardize", "yes"},
                                         {"rejection", "calibrated"},
                                         {"moments", "printed"},
                                         {"candidates", "6"},
                                         {"angle_weight", "0"},
                                         {"neighbours", "5"},
                                         {"max_distance_m", "0.02"},
                                         {"held_out", "view"},
                                         {"attempts", "3"},
                                         {"robot", "arm.toml"},
                                         {"grasp_points", "p.safetensors"},
                                         {"click", "object"},
                                         {"told_class", "yes"},
                                         {"position", "demonstration"},
                                         {"num_classes", "4"}});
  EXPECT_EQ(settings.classes.descriptor.type, features::CloudDescriptorType::kPolar);
  EXPECT_EQ(settings.classes.descriptor.grid_size, 20);
  EXPECT_EQ(settings.classes.descriptor.scaling, features::CloudScaling::kUnit);
  EXPECT_EQ(settings.classes.descriptor.frame, features::CloudFrame::kCamera);
  EXPECT_EQ(settings.classes.outlier_step, 3.0);
  EXPECT_EQ(settings.classes.svm.kernel, features::SimilarityType::kRbf);
  EXPECT_EQ(settings.classes.svm.degree, 2);
  EXPECT_EQ(settings.classes.svm.gamma, 0.5);
  EXPECT_EQ(settings.classes.svm.coef0, 0.0);
  EXPECT_EQ(settings.classes.svm.penalty, 10.0);
  EXPECT_EQ(settings.classes.svm.scheme, features::ClassScheme::kOneAgainstAll);
  EXPECT_TRUE(settings.classes.svm.standardize);
  EXPECT_EQ(settings.rotation.moments, features::ComparedMoments::kPrinted);
  EXPECT_EQ(settings.rotation.num_candidates, 6U);
  EXPECT_EQ(settings.rotation.angle_weight, 0.0);
  EXPECT_EQ(settings.classes.descriptor.box, features::GridBox::kSquare);
  EXPECT_EQ(settings.classes.moved.num_copies, 4);
  EXPECT_EQ(settings.num_classes, 4U);
  EXPECT_EQ(Applied({{"descriptor", "vfh"}}).classes.descriptor.type,
            features::CloudDescriptorType::kViewpointHistogram);
  EXPECT_EQ(Applied({{"descriptor", "esf"}}).classes.descriptor.type,
            features::CloudDescriptorType::kShapeFunctions);
  EXPECT_EQ(settings.grasps.num_neighbours, 5U);
  EXPECT_EQ(settings.grasps.max_distance_m, 0.02);
  EXPECT_EQ(settings.grasps.held_out, HeldOutPart::kView);
  EXPECT_EQ(settings.grasps.max_attempts, 3);
  EXPECT_EQ(settings.grasps.robot, "arm.toml");
  EXPECT_EQ(settings.grasps.grasp_points, "p.safetensors");
  EXPECT_EQ(settings.rejection, ClassRejection::kCalibrated);
  EXPECT_EQ(settings.grasps.click, GraspClick::kObject);
  EXPECT_TRUE(settings.grasps.is_class_told);
  EXPECT_EQ(settings.grasps.position, GraspPosition::kDemonstration);
  EXPECT_EQ(ViewSettingKeys().size(), 28U) << "a new key is tried here";
}

TEST(ViewSettings, RefuseWhatDoesNotFit) {
  const std::pair<Setting, const char*> cases[] = {
      {{"descriptor", "photo"}, "descriptor is \"photo\"; it must be grid, "},
      {{"grid_size", "0"}, "a number from 1 to"},
      {{"grid_size", "2.5"}, "a number from 1 to"},
      {{"gamma", "-1"}, "a number from 0 to"},
      {{"gamma", "nan"}, "a number from 0 to"},
      {{"C", "0"}, "a number above 0"},
      {{"standardize", "true"}, "yes or no"},
      {{"scheme", "all"}, "one-against-one or one-against-all"},
      {{"candidates", "65"}, "a number from 0 to 64"},
      {{"neighbours", "33"}, "a number from 1 to 32"},
      {{"rejection", "some"}, "it must be none, calibrated"},
      {{"held_out", "class"}, "it must be demonstration, view"},
      {{"colour", "red"}, "\"colour\" is no setting; there are: descriptor, "},
  };
  for (const auto& [setting, message] : cases) {
    EXPECT_THROWS_MESSAGE(static_cast<void>(Applied({setting})), Error, HasSubstr(message));
  }
}

}  // namespace
}  // namespace handcraft::experiments
