// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/grasp_library/grasp_library.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::grasp_library {
namespace {

using features::GraspLibrary;
using ::testing::HasSubstr;

constexpr double kTurn = 2.0 * std::numbers::pi;

SeenView Seen(std::size_t object_class, double angle_rad) {
  SeenView view{.object_class = object_class, .angle_rad = angle_rad};
  view.description.normal = {std::cos(angle_rad), std::sin(angle_rad), 0.0};
  view.description.moments.fill(1.0 + angle_rad);
  return view;
}

// Two classes in mixed order.
TrainingSet SomeSet() {
  TrainingSet set{.classes = {"mug", "drill"}};
  Rng rng(1);
  std::int32_t number = 0;
  for (int i = 0; i < 6; ++i) {
    for (const std::size_t c : {1, 0}) {
      set.views.push_back(Seen(c, 1.0 * i));
      for (int k = 0; k < 15; ++k) {
        set.poses.push_back({.object_class = c,
                             .angle_rad = i % 2 == 0 ? 0.5 : 2.0,
                             .mean_m = {0.1 * i, 0.2, 0.3},
                             .position_m = {rng.Normal(), rng.Normal(), rng.Normal()},
                             .rotation = features::TurnAboutZ(rng.Normal()),
                             .number = number++});
      }
    }
  }
  return set;
}

TEST(TrainGraspLibrary, OrdersByClassAndAngle) {
  const GraspLibrary library = TrainGraspLibrary(SomeSet());
  EXPECT_EQ(library.view_begins, (std::vector<std::int32_t>{0, 6, 12}));
  EXPECT_EQ(library.angle_begins, (std::vector<std::int32_t>{0, 2, 4}));
  EXPECT_EQ(library.pose_begins, (std::vector<std::int32_t>{0, 45, 90, 135, 180}));
  EXPECT_EQ(library.shown_angles_rad, (std::vector<double>{0.5, 2.0, 0.5, 2.0}));
  EXPECT_FALSE(library.rejection_distance_m.has_value());
}

TEST(TrainGraspLibrary, KeepsEachPoseFromItsMean) {
  const TrainingSet set = SomeSet();
  const GraspLibrary library = TrainGraspLibrary(set);
  for (std::size_t row = 0; row < library.numbers.size(); ++row) {
    const ShownPose& pose = set.poses[static_cast<std::size_t>(library.numbers[row])];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(library.positions_m[3 * row + axis], pose.position_m[axis] - pose.mean_m[axis]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(library.rotations[4 * row + i], pose.rotation[i], 1e-15);
    }
    const bool is_mug = row < 90;
    EXPECT_EQ(pose.object_class, is_mug ? 0U : 1U);
  }
}

TEST(TrainGraspLibrary, FindsEveryDemonstrationAgain) {
  const TrainingSet set = SomeSet();
  const GraspLibrary library = TrainGraspLibrary(set);
  for (const ShownPose& pose : set.poses) {
    const features::FoundGrasp found = features::FindGraspAt(library.Class(pose.object_class),
                                                             pose.angle_rad,
                                                             pose.mean_m,
                                                             {.point_m = pose.position_m});
    EXPECT_EQ(found.number, pose.number);
    EXPECT_EQ(found.distance_m, 0.0);
    EXPECT_EQ(found.turn_rad, 0.0);
  }
}

TEST(TrainGraspLibrary, TakesAnglesModuloATurn) {
  TrainingSet set{.classes = {"mug"}};
  set.views = {Seen(0, -0.5), Seen(0, kTurn + 0.25), Seen(0, -1e-17)};
  set.poses = {{.rotation = {0, 0, 0, 1}}, {.angle_rad = kTurn, .rotation = {0, 0, 0, 2}}};
  const GraspLibrary library = TrainGraspLibrary(set);
  EXPECT_NEAR(library.view_angles_rad[0], kTurn - 0.5, 1e-15);
  EXPECT_NEAR(library.view_angles_rad[1], 0.25, 1e-15);
  EXPECT_EQ(library.view_angles_rad[2], 0.0);
  EXPECT_EQ(library.shown_angles_rad, (std::vector<double>{0.0}));
  EXPECT_EQ(library.rotations[7], 1.0);  // scaled to length 1
}

TEST(TrainGraspLibrary, KeepsItsOptions) {
  const GraspLibrary library =
      TrainGraspLibrary(SomeSet(),
                        {.compared_moments = features::ComparedMoments::kPrinted,
                         .num_candidates = 6,
                         .angle_weight = 0.0,
                         .rejection_distance_m = 0.07});
  EXPECT_EQ(library.rule.moments, features::ComparedMoments::kPrinted);
  EXPECT_EQ(library.rule.num_candidates, 6U);
  EXPECT_EQ(library.rule.angle_weight, 0.0);
  EXPECT_EQ(library.rejection_distance_m, 0.07);
}

TEST(TrainGraspLibrary, RefusesClassesThatLackSomething) {
  const auto train = [](const TrainingSet& set) { static_cast<void>(TrainGraspLibrary(set)); };
  EXPECT_THROWS_MESSAGE(train({}), Error, HasSubstr("there is no class to learn"));
  TrainingSet set{.classes = {"mug"}};
  EXPECT_THROWS_MESSAGE(train(set), Error, HasSubstr("class mug has no view"));
  set.views = {Seen(0, 0.0)};
  EXPECT_THROWS_MESSAGE(train(set), Error, HasSubstr("class mug has no demonstration"));
  set.poses = {ShownPose{}};
  set.poses[0].object_class = 1;
  EXPECT_THROW(train(set), std::logic_error);
}

TEST(Options, NameTheFieldThatIsWrong) {
  Options options;
  options.num_candidates = 65;
  EXPECT_THROWS_MESSAGE(
      options.Validate(), Error, HasSubstr("num_candidates is 65; it must be from 0 to 64"));
  options = {};
  options.angle_weight = -1.0;
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("angle_weight is -1"));
  options = {};
  options.rejection_distance_m = 101.0;
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("rejection_distance_m is 101"));
}

}  // namespace
}  // namespace handcraft::grasp_library
