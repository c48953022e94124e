// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/gripper.h"

#include <set>

#include "datasets/synthetic/draw.h"
#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using ::testing::HasSubstr;

bool Meets(const GripperBoxes& boxes, const Eigen::AlignedBox3f& thing) {
  for (const OrientedBox& box : boxes) {
    if (Overlap(box, MovedBox(thing, Isometry3f::Identity()))) return true;
  }
  return false;
}

TEST(SweptBoxes, LeaveRoomForWhatIsHeld) {
  const Gripper gripper;
  const GripperBoxes boxes = SweptBoxes(gripper, {-0.03F, 0.04F}, Isometry3f::Identity());
  const float palm_m = -gripper.finger_reach_m;
  EXPECT_FALSE(Meets(boxes, {Vector3f(-0.03F, -0.1F, palm_m + 1e-4F), Vector3f(0.04F, 0.1F, 0.1F)}))
      << "a slab from the palm outwards, as thick as the contacts are apart";
  EXPECT_FALSE(Meets(boxes, {Vector3f(-0.034F, -0.1F, -0.02F), Vector3f(0.044F, 0.1F, 0.1F)}))
      << "the last links yield by less than 5 mm";
  EXPECT_TRUE(Meets(boxes, {Vector3f(-0.036F, 0.0F, 0.0F), Vector3f(0.0F, 0.01F, 0.01F)}))
      << "the thumb";
  EXPECT_TRUE(Meets(boxes, {Vector3f(0.0F, 0.02F, 0.0F), Vector3f(0.046F, 0.03F, 0.01F)}));
  EXPECT_FALSE(Meets(boxes, {Vector3f(0.0F, -0.01F, 0.0F), Vector3f(0.1F, 0.01F, 0.01F)}))
      << "between the two fingers";
  EXPECT_TRUE(Meets(boxes, {Vector3f(0.0F, 0.0F, palm_m - 0.01F), Vector3f(0.01F, 0.01F, 0.0F)}))
      << "the palm";
}

TEST(SweptBoxes, ReachFromTheContactsToTheOpening) {
  const Gripper gripper;
  const float outside_m = 0.5F * gripper.max_opening_m + gripper.finger_thickness_m;
  const GripperBoxes boxes = SweptBoxes(gripper, {-0.03F, 0.02F}, Isometry3f::Identity());
  Eigen::AlignedBox3f fingers;
  Eigen::AlignedBox3f thumb;
  for (std::size_t i : {0U, 1U}) fingers.extend(Around(boxes[i]));
  thumb = Around(boxes[2]);
  EXPECT_NEAR(fingers.min().x(), 0.02F + gripper.pad_slack_m, 1e-6F);
  EXPECT_NEAR(fingers.max().x(), outside_m, 1e-6F);
  EXPECT_NEAR(thumb.max().x(), -0.03F - gripper.pad_slack_m, 1e-6F);
  EXPECT_NEAR(thumb.min().x(), -outside_m, 1e-6F);
}

TEST(ClosedBoxes, LieWithinTheSweptOnesAndAreAsThickAsAFinger) {
  const Gripper gripper;
  const ContactPlaces contacts{-0.02F, 0.045F};
  const GripperBoxes swept = SweptBoxes(gripper, contacts, Isometry3f::Identity());
  const GripperBoxes closed = ClosedBoxes(gripper, contacts, Isometry3f::Identity());
  for (std::size_t i = 0; i < kNumGripperBoxes; ++i) {
    EXPECT_TRUE(Around(swept[i]).contains(Around(closed[i]))) << i;
  }
  // The fingers' last links come to 0.05, their roots to 0.053; both end a finger's thickness
  // behind that.
  EXPECT_NEAR(Around(closed[0]).min().x(), 0.05F, 1e-6F);
  EXPECT_NEAR(Around(closed[0]).max().x(), 0.053F + gripper.finger_thickness_m, 1e-6F);
  EXPECT_NEAR(Around(closed[3]).min().x(), 0.053F, 1e-6F);
  EXPECT_NEAR(Around(closed[5]).max().x(), -gripper.knuckle_m, 1e-6F) << "the thumb stands upright";
}

TEST(Collide, FindsHandsThatMeet) {
  const GripperBoxes hand = ClosedBoxes({}, {-0.03F, 0.03F}, Isometry3f::Identity());
  const auto other_at = [](float x_m, float turn_rad) {
    const Isometry3f pose = Eigen::Translation3f(x_m, 0.0F, 0.0F) *
                            Isometry3f(Eigen::AngleAxisf(turn_rad, Vector3f::UnitX()));
    return ClosedBoxes({}, {-0.03F, 0.03F}, pose);
  };
  EXPECT_TRUE(Collide(hand, hand));
  EXPECT_FALSE(Collide(hand, other_at(0.5F, 0.0F)));
  EXPECT_TRUE(Collide(hand, other_at(0.12F, 0.0F))) << "palms are 0.13 m wide";
  EXPECT_FALSE(Collide(hand, other_at(0.131F, 0.0F)));
  EXPECT_TRUE(Collide(hand, other_at(0.0F, 3.14F))) << "face to face, the fingers meet";
}

TEST(SweptBoxes, HangTogether) {
  const Gripper gripper;
  gripper.Validate();
  Rng rng = Rng::Stream(1, "contacts");
  for (int i = 0; i < 100; ++i) {
    const float thumb_m = Between(rng, -0.5F * gripper.WidestM(), 0.01F);
    const float fingers_m = thumb_m + Between(rng, 0.0F, 0.5F * gripper.WidestM() - thumb_m);
    const GripperBoxes boxes = SweptBoxes(gripper, {thumb_m, fingers_m}, Isometry3f::Identity());
    std::set<std::size_t> reached = {kNumGripperBoxes - 1};
    for (std::size_t round = 0; round < kNumGripperBoxes; ++round) {
      for (std::size_t box = 0; box < kNumGripperBoxes; ++box) {
        for (const std::size_t other : reached) {
          if (!Overlap(boxes[box], boxes[other])) continue;
          reached.insert(box);
          break;
        }
      }
    }
    EXPECT_EQ(reached.size(), kNumGripperBoxes) << thumb_m << " " << fingers_m;
  }
}

TEST(SweptBoxes, MoveWithTheHand) {
  const Isometry3f pose = Eigen::Translation3f(1.0F, 2.0F, 3.0F) *
                          Isometry3f(Eigen::AngleAxisf(1.0F, Vector3f(1, 2, 3).normalized()));
  const GripperBoxes still = SweptBoxes({}, {-0.02F, 0.03F}, Isometry3f::Identity());
  const GripperBoxes moved = SweptBoxes({}, {-0.02F, 0.03F}, pose);
  for (std::size_t i = 0; i < kNumGripperBoxes; ++i) {
    EXPECT_TRUE(moved[i].frame_from_box.isApprox(pose * still[i].frame_from_box, 1e-5F));
    EXPECT_EQ(moved[i].half_size_m, still[i].half_size_m);
  }
}

TEST(Gripper, KnowsItsMeasures) {
  EXPECT_NEAR(Gripper{}.WidestM(), 0.11F, 1e-6F);
  EXPECT_NEAR(Gripper{}.WristToGraspM(), 0.235F, 1e-6F);
}

TEST(Gripper, RefusesWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(Gripper{.max_opening_m = 0.01F}.Validate(),
                        Error,
                        HasSubstr("Gripper.max_opening_m is 0.01; it must be more than twice"));
  EXPECT_THROWS_MESSAGE(Gripper{.stand_off_m = 0.02F}.Validate(),
                        Error,
                        HasSubstr("a finger's root stands on the palm"));
  EXPECT_THROWS_MESSAGE(Gripper{.finger_width_m = 0.0F}.Validate(),
                        Error,
                        HasSubstr("Gripper.finger_width_m is 0; it must be in (0, 1]"));
  EXPECT_THROWS_MESSAGE(
      Gripper{.tip_m = -0.05F}.Validate(), Error, HasSubstr("Gripper.tip_m is -0.05"));
  EXPECT_THROWS_MESSAGE(
      Gripper{.pad_slack_m = 0.05F}.Validate(), Error, HasSubstr("Gripper.pad_slack_m"));
}

}  // namespace
}  // namespace handcraft::synthetic
