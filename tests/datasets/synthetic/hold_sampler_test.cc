// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/hold_sampler.h"

#include "lib/core/error.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using ::testing::HasSubstr;
using testing::PoseOf;

ShownGrasp Shown(const Isometry3f& pose) {
  return {datasets::EndEffectorPose::Rounded(pose.cast<double>()), {-0.03F, 0.03F}};
}

ShownGrasp FromTheRight(float height_m) {
  return Shown(PoseOf({0, 0, height_m}, Vector3f::UnitX(), Vector3f::UnitY()));
}

ShownGrasp FromTheLeft(float height_m) {
  return Shown(PoseOf({0, 0, height_m}, Vector3f::UnitX(), -Vector3f::UnitY()));
}

TEST(CheckHold, KnowsHandCases) {
  const Gripper gripper;
  const auto check = [&](const ShownGrasp& right, const ShownGrasp& left) {
    return CheckHold({right, left}, gripper, {});
  };
  EXPECT_EQ(check(FromTheRight(0.10F), FromTheLeft(0.20F)), HoldFault::kNone);
  EXPECT_EQ(check(FromTheRight(0.10F), FromTheLeft(0.12F)), HoldFault::kHandsMeet);
  EXPECT_EQ(check(FromTheRight(0.10F), FromTheRight(0.18F)), HoldFault::kHandsMeet)
      << "palms and wrists are 9 and 10 cm high";
  EXPECT_EQ(check(FromTheRight(0.10F), FromTheRight(0.21F)), HoldFault::kNone);
  EXPECT_EQ(check(FromTheRight(0.049F), FromTheLeft(0.20F)), HoldFault::kNearTable);
  EXPECT_EQ(check(FromTheRight(0.20F), FromTheLeft(0.049F)), HoldFault::kNearTable);
}

TEST(CheckHold, LeavesRoomForEitherHandToOpen) {
  // The left hand beside the right one, its thumb as high as one of the right hand's fingers.
  const Gripper gripper;
  const auto beside = [&](float x_m) {
    return ShownHold{FromTheRight(0.10F),
                     Shown(PoseOf({x_m, 0, 0.125F}, Vector3f::UnitX(), -Vector3f::UnitY()))};
  };
  const auto closed = [&](const ShownGrasp& shown) {
    return ClosedBoxes(gripper, shown.contacts, shown.base_from_grasp.ToIsometry().cast<float>());
  };
  // Closed on ±30 mm a finger reaches 60.5 mm to the side, open 82.5 mm.
  const ShownHold near = beside(0.14F);
  EXPECT_FALSE(Collide(closed(near.right), closed(near.left)));
  EXPECT_EQ(CheckHold(near, gripper, {}), HoldFault::kHandsMeet);
  EXPECT_EQ(CheckHold(beside(0.15F), gripper, {}), HoldFault::kNone);
}

// A tall can within reach of the right arm, and of the left one.
class CanBeforeTwoArms : public ::testing::Test {
 protected:
  CanBeforeTwoArms() {
    Rng rng = Rng::Stream(1, "grasps");
    GraspCounts counts;
    grasps_ = SampleGrasps(check_, {.num_tries = 2000, .most_grasps = 400}, rng, counts);
  }

  [[nodiscard]] Demonstrator Before(const ArmReach& arm) const {
    PlacedBeforeArm place;
    place.arm_in_base = arm;
    Rng rng = Rng::Stream(1, "favourites");
    return {check_, grasps_, place, {}, rng};
  }

  Mesh object_ = testing::Can(0.03F, 0.3F);
  GraspCheck check_{object_, {}, {}};
  std::vector<Grasp> grasps_;
};

TEST_F(CanBeforeTwoArms, IsHeldByBothHands) {
  const Demonstrator right = Before(RightArm());
  const Demonstrator left = Before(LeftArm());
  HoldCounts counts;
  for (std::uint64_t i = 0; i < 10; ++i) {
    Rng rng = Rng::Stream(1, "holds", i);
    const ShownHold hold = DrawHold(right, left, check_.gripper(), {}, rng, counts);
    for (const ShownGrasp& shown : {hold.right, hold.left}) {
      EXPECT_GE(shown.base_from_grasp.position_m.z(), 0.05);
      const Isometry3f pose = InObject(shown.base_from_grasp, Isometry3f::Identity());
      EXPECT_EQ(testing::SlowClose(object_, check_.gripper(), check_.rules(), pose, 2e-5),
                GraspFault::kNone);
    }
    EXPECT_EQ(CheckHold(hold, check_.gripper(), {}), HoldFault::kNone);
  }
  EXPECT_EQ(counts[HoldFault::kNone], 10U);
  EXPECT_GE(counts.poses.Total(), 20U);
}

TEST_F(CanBeforeTwoArms, IsHeldInTheSameWayForTheSameSeed) {
  const Demonstrator right = Before(RightArm());
  const Demonstrator left = Before(LeftArm());
  const auto draw = [&](std::uint64_t seed) {
    Rng rng = Rng::Stream(seed, "holds");
    HoldCounts counts;
    return DrawHold(right, left, check_.gripper(), {}, rng, counts);
  };
  EXPECT_EQ(draw(1).left.base_from_grasp.position_m, draw(1).left.base_from_grasp.position_m);
  EXPECT_NE(draw(1).left.base_from_grasp.position_m, draw(2).left.base_from_grasp.position_m);
}

TEST_F(CanBeforeTwoArms, SaysSoWhenThereIsNoRoomForTwoHands) {
  const Demonstrator right = Before(RightArm());
  Rng rng = Rng::Stream(1, "holds");
  HoldCounts counts;
  EXPECT_THROWS_MESSAGE(
      DrawHold(
          right, right, check_.gripper(), {.least_height_m = 0.29F, .num_tries = 20}, rng, counts),
      Error,
      HasSubstr("no way for two hands to hold the object at once in 20 pairs of poses"));
}

TEST(HoldRules, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(
      HoldRules{.least_height_m = -1.0F}.Validate(), Error, HasSubstr("least_height_m is -1"));
  EXPECT_THROWS_MESSAGE(HoldRules{.num_tries = 0}.Validate(),
                        Error,
                        HasSubstr("HoldRules.num_tries is 0; it must be from 1 to 1000000"));
}

}  // namespace
}  // namespace handcraft::synthetic
