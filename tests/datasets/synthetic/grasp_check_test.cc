// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_check.h"

#include <set>

#include "datasets/synthetic/draw.h"
#include "lib/core/error.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using ::testing::HasSubstr;
using testing::PoseOf;

// A can of 60 mm diameter and 200 mm height.
class CanInHand : public ::testing::Test {
 protected:
  [[nodiscard]] GraspFault FaultAt(const Isometry3f& pose) const {
    return check_.Close(pose).fault;
  }

  // From the side, level, closing on the can's diameter.
  [[nodiscard]] static Isometry3f FromTheSide(float height_m) {
    return PoseOf({0.0F, 0.0F, height_m}, Vector3f::UnitY(), Vector3f::UnitX());
  }

  GraspCheck check_{testing::Can(0.03F, 0.2F), {}, {}};
};

TEST_F(CanInHand, IsHeldAcrossItsDiameter) {
  const GraspOutcome outcome = check_.Close(FromTheSide(0.12F));
  EXPECT_EQ(outcome.fault, GraspFault::kNone);
  EXPECT_NEAR(outcome.contacts.thumb_m, -0.03F, 1e-5F);
  EXPECT_NEAR(outcome.contacts.fingers_m, 0.03F, 1e-5F);
  EXPECT_NEAR(outcome.contacts.WidthM(), 0.06F, 1e-5F);
  EXPECT_EQ(FaultAt(PoseOf({0.0F, 0.0F, 0.19F}, Vector3f::UnitX(), -Vector3f::UnitZ())),
            GraspFault::kNone)
      << "from above";
}

TEST_F(CanInHand, TellsWhichRuleIsBroken) {
  EXPECT_EQ(FaultAt(FromTheSide(0.3F)), GraspFault::kNothingHeld);
  EXPECT_EQ(FaultAt(PoseOf({0.0F, 0.0F, 0.1F}, Vector3f::UnitZ(), Vector3f::UnitX())),
            GraspFault::kTooWide)
      << "closing along its length";
  Isometry3f aside = FromTheSide(0.12F);
  aside.translation().y() = 0.011F;
  EXPECT_EQ(FaultAt(aside), GraspFault::kOffCentre);
  aside.translation().y() = 0.009F;
  EXPECT_EQ(FaultAt(aside), GraspFault::kNone);
  Isometry3f deep = FromTheSide(0.12F);
  deep.translation().x() = 0.02F;  // where the can's surface has turned by more than 26.6°
  EXPECT_EQ(FaultAt(deep), GraspFault::kSlips);
  EXPECT_EQ(FaultAt(FromTheSide(0.055F)), GraspFault::kNearTable) << "the wrist is 10 cm thick";
  EXPECT_EQ(FaultAt(FromTheSide(0.061F)), GraspFault::kNone);
  EXPECT_EQ(FaultAt(PoseOf({0.0F, 0.0F, 0.1F}, Vector3f::UnitX(), -Vector3f::UnitZ())),
            GraspFault::kTouchesObject)
      << "the can is longer than the fingers";
}

TEST_F(CanInHand, SlipsWhereTheConeEnds) {
  // At distance s from the middle the normal is off the closing axis by asin(s / r).
  const GraspCheck check(testing::Can(0.03F, 0.2F, 512), {}, {});
  const float cone_rad = std::atan(check.rules().friction);
  for (const float slant : {0.95F, 1.05F}) {
    Isometry3f pose = FromTheSide(0.12F);
    pose.translation().x() = -0.03F * std::sin(slant * cone_rad);
    EXPECT_EQ(check.Close(pose).fault, slant < 1.0F ? GraspFault::kNone : GraspFault::kSlips);
  }
}

TEST(GraspCheck, PutsNoFingerIntoAVesselThatIsNarrowerThanTheOpenHand) {
  const Mesh tube =
      Revolve({{0.03F, 0.0F, {}}, {0.03F, 0.1F, {}}, {0.026F, 0.1F, {}}, {0.026F, 0.0F, {}}},
              Ends::kJoined);
  const GraspCheck check(tube, {}, {});
  // The wall between thumb and fingers, from above.
  const Isometry3f pose = PoseOf({0.028F, 0.0F, 0.09F}, -Vector3f::UnitX(), -Vector3f::UnitZ());
  EXPECT_EQ(check.Close(pose).fault, GraspFault::kTooWide) << "the other wall is in the way";
}

TEST(GraspCheck, AgreesWithASlowSecondAnswer) {
  const std::vector<Mesh> objects = {testing::Ball(0.04F, 0.12F, 12),
                                     testing::Can(0.03F, 0.16F, 12),
                                     RoundedBox({0.05F, 0.08F, 0.15F}, 0.006F, {})};
  Rng rng = Rng::Stream(1, "poses");
  std::set<GraspFault> met;
  int num_clear = 0;
  constexpr int kNumPoses = 700;
  for (int i = 0; i < kNumPoses; ++i) {
    const Mesh& object = objects[static_cast<std::size_t>(i) % objects.size()];
    const GraspCheck check(object, {}, {});
    const float turn_rad = Between(rng, 0.0F, 6.3F);
    const Vector3f closing(std::cos(turn_rad), std::sin(turn_rad), Between(rng, -0.3F, 0.3F));
    const Vector3f approach(-std::sin(turn_rad), std::cos(turn_rad), Between(rng, -3.0F, 0.5F));
    const Vector3f at(
        Between(rng, -0.015F, 0.015F), Between(rng, -0.015F, 0.015F), Between(rng, 0.06F, 0.17F));
    const Isometry3f pose = PoseOf(at, closing, approach);
    const auto slow = [&](double slack) {
      return testing::SlowClose(object, check.gripper(), check.rules(), pose, slack);
    };
    const GraspFault expected = slow(2e-5);
    if (expected != slow(-2e-5)) continue;  // too near to call in single precision
    ++num_clear;
    met.insert(expected);
    EXPECT_EQ(check.Close(pose).fault, expected) << i;
  }
  EXPECT_GT(num_clear, kNumPoses * 9 / 10);
  EXPECT_GE(met.size(), 6U) << "most rules are tried";
}

TEST(GraspRules, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(GraspRules{.friction = 0.0F}.Validate(),
                        Error,
                        HasSubstr("GraspRules.friction is 0; it must be in (0, 2]"));
  EXPECT_THROWS_MESSAGE(
      GraspRules{.off_centre_m = -1.0F}.Validate(), Error, HasSubstr("off_centre_m is -1"));
  EXPECT_THROWS_MESSAGE(
      GraspRules{.table_clearance_m = 1.0F}.Validate(), Error, HasSubstr("table_clearance_m is 1"));
  EXPECT_THROWS_MESSAGE(GraspCheck(testing::Can(0.03F, 0.1F), {}, {.friction = 3.0F}),
                        Error,
                        HasSubstr("GraspRules.friction is 3"));
}

TEST(NameOf, HasAWordForEachFault) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kNumGraspFaults; ++i)
    names.insert(NameOf(static_cast<GraspFault>(i)));
  EXPECT_EQ(names.size(), kNumGraspFaults);
  EXPECT_EQ(NameOf(GraspFault::kSlips), "slips");
}

}  // namespace
}  // namespace handcraft::synthetic
