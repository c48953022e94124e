// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_trial.h"

#include <set>

#include <gtest/gtest.h>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/grasp_sampler.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using testing::PoseOf;

// A block standing on the table, its faces along the axes; corners hardly rounded.
Mesh Block(float x_m, float y_m, float z_m) { return RoundedBox({x_m, y_m, z_m}, 1e-4F, {}); }

GraspCheck TrialOf(const Mesh& mesh) { return {mesh, {}, TrialRules()}; }

// From the side, level, closing along y: the wrist, 0.1 m thick, needs 0.05 m above the table.
Isometry3f Along(const Vector3f& at_m) {
  return PoseOf(at_m, Vector3f::UnitY(), Vector3f::UnitX());
}

// A block of 40 × 60 × 200 mm, approached along x.
class BlockInHand : public ::testing::Test {
 protected:
  [[nodiscard]] GraspFault FaultAt(const Isometry3f& pose) const {
    return TryGrasp(check_, pose).fault;
  }
  GraspCheck check_ = TrialOf(Block(0.04F, 0.06F, 0.2F));
};

TEST_F(BlockInHand, IsHeldAcross) {
  const GraspOutcome outcome = TryGrasp(check_, Along({0.0F, 0.0F, 0.12F}));
  EXPECT_EQ(outcome.fault, GraspFault::kNone);
  EXPECT_NEAR(outcome.contacts.thumb_m, -0.03F, 1e-5F);
  EXPECT_NEAR(outcome.contacts.fingers_m, 0.03F, 1e-5F);
}

TEST_F(BlockInHand, IsPushedToTheMiddleAsFarAsTheHandDoesNotYield) {
  // 25 mm to one side: 10 mm yield, 15 mm are pushed, so the contacts are at -20 and 40 mm.
  const GraspOutcome outcome = TryGrasp(check_, Along({0.0F, -0.025F, 0.12F}));
  EXPECT_EQ(outcome.fault, GraspFault::kNone);
  EXPECT_NEAR(outcome.contacts.thumb_m, -0.02F, 1e-5F);
  EXPECT_NEAR(outcome.contacts.fingers_m, 0.04F, 1e-5F);
}

TEST_F(BlockInHand, AFingerThatComesDownOnItCollides) {
  // The open thumb's inside is at 60 mm and yields by 5: the block, 30 mm to its side, is in it.
  EXPECT_EQ(FaultAt(Along({0.0F, 0.029F, 0.12F})), GraspFault::kNone);
  EXPECT_EQ(FaultAt(Along({0.0F, 0.034F, 0.12F})), GraspFault::kTooWide) << "it cannot close";
  EXPECT_EQ(FaultAt(Along({0.0F, 0.036F, 0.12F})), GraspFault::kTouchesObject);
}

TEST_F(BlockInHand, CollidesWhereThePalmWouldBe) {
  // The palm is 85 mm behind the centre, the block's face 20 mm before it.
  EXPECT_EQ(FaultAt(Along({0.064F, 0.0F, 0.12F})), GraspFault::kNothingHeld);
  EXPECT_EQ(FaultAt(Along({0.066F, 0.0F, 0.12F})), GraspFault::kTouchesObject);
}

TEST_F(BlockInHand, IsMissedAboveAndBefore) {
  EXPECT_EQ(FaultAt(Along({0.0F, 0.0F, 0.205F})), GraspFault::kNothingHeld);
  EXPECT_EQ(FaultAt(Along({-0.021F, 0.0F, 0.12F})), GraspFault::kNothingHeld);
  EXPECT_EQ(FaultAt(Along({-0.019F, 0.0F, 0.12F})), GraspFault::kNone);
}

TEST_F(BlockInHand, TheHandMustNotGoThroughTheTable) {
  EXPECT_EQ(FaultAt(Along({0.0F, 0.0F, 0.051F})), GraspFault::kNone) << "no margin is asked for";
  EXPECT_EQ(FaultAt(Along({0.0F, 0.0F, 0.049F})), GraspFault::kNearTable);
  EXPECT_EQ(FaultAt(PoseOf({0.0F, 0.0F, 0.014F}, Vector3f::UnitY(), -Vector3f::UnitZ())),
            GraspFault::kNearTable)
      << "fingertips are 15 mm beyond the centre";
}

TEST_F(BlockInHand, GlancingContactsSlip) {
  // Turned about the approach's vertical: friction 0.5 holds to 26.57°.
  for (const float turn_deg : {26.0F, 27.0F}) {
    const float turn_rad = turn_deg * std::numbers::pi_v<float> / 180.0F;
    const Isometry3f pose =
        Isometry3f(Eigen::AngleAxisf(turn_rad, Vector3f::UnitZ())) * Along(Vector3f::Zero());
    Isometry3f placed = pose;
    placed.translation() = Vector3f(0.0F, 0.0F, 0.12F);
    EXPECT_EQ(FaultAt(placed), turn_deg < 26.57F ? GraspFault::kNone : GraspFault::kSlips)
        << turn_deg;
  }
}

TEST(TryGrasp, TakesNothingWiderThanTheHandOpensLessItsClearances) {
  // 110 mm: the clearances of 5 mm on either side may lie on one.
  EXPECT_EQ(TryGrasp(TrialOf(Block(0.04F, 0.1095F, 0.2F)), Along({0.0F, 0.004F, 0.12F})).fault,
            GraspFault::kNone);
  EXPECT_EQ(TryGrasp(TrialOf(Block(0.04F, 0.1105F, 0.2F)), Along({0.0F, 0.0F, 0.12F})).fault,
            GraspFault::kTooWide);
  EXPECT_EQ(TryGrasp(TrialOf(Block(0.04F, 0.14F, 0.2F)), Along({0.0F, 0.0F, 0.12F})).fault,
            GraspFault::kTouchesObject)
      << "the open fingers are in it";
}

TEST(TryGrasp, PushesNothingIntoTheTable) {
  // A plate lying on the table's edge is closed on from above and below.
  const Mesh shelf = [] {
    Mesh plate = Block(0.06F, 0.06F, 0.01F);
    Transform(plate, Isometry3f(Eigen::Translation3f(0.0F, 0.0F, 0.2F)));
    return plate;
  }();
  const GraspCheck check = TrialOf(shelf);
  const auto closing_down = [](float height_m) {
    return PoseOf({0.0F, 0.0F, height_m}, Vector3f::UnitZ(), Vector3f::UnitX());
  };
  EXPECT_EQ(TryGrasp(check, closing_down(0.214F)).fault, GraspFault::kNone);
  EXPECT_EQ(TryGrasp(check, closing_down(0.216F)).fault, GraspFault::kOffCentre);
}

// Poses all about some objects, most of which hold nothing.
template <class Visit>
void ForManyPoses(int num_poses, const Visit& visit) {
  const std::vector<Mesh> objects = {
      testing::Ball(0.04F, 0.12F, 12), testing::Can(0.03F, 0.16F, 12), Block(0.05F, 0.08F, 0.15F)};
  Rng rng = Rng::Stream(2, "trials");
  for (int i = 0; i < num_poses; ++i) {
    const Mesh& object = objects[static_cast<std::size_t>(i) % objects.size()];
    const float turn_rad = Between(rng, 0.0F, 6.3F);
    const Vector3f closing(std::cos(turn_rad), std::sin(turn_rad), Between(rng, -0.3F, 0.3F));
    const Vector3f approach(-std::sin(turn_rad), std::cos(turn_rad), Between(rng, -3.0F, 0.5F));
    const Vector3f at(
        Between(rng, -0.03F, 0.03F), Between(rng, -0.03F, 0.03F), Between(rng, 0.05F, 0.17F));
    visit(object, PoseOf(at, closing, approach));
  }
}

// Law: what a person could have shown is held, and held by the same contacts.
TEST(TryGrasp, HoldsWhateverPassesTheRulesOfDemonstrations) {
  int num_shown = 0;
  ForManyPoses(1200, [&](const Mesh& object, const Isometry3f& pose) {
    const GraspOutcome shown = GraspCheck(object, {}, {}).Close(pose);
    if (shown.fault != GraspFault::kNone) return;
    ++num_shown;
    const GraspOutcome tried = TryGrasp(TrialOf(object), pose);
    EXPECT_EQ(tried.fault, GraspFault::kNone) << NameOf(tried.fault);
    EXPECT_EQ(tried.contacts.thumb_m, shown.contacts.thumb_m);
    EXPECT_EQ(tried.contacts.fingers_m, shown.contacts.fingers_m);
  });
  EXPECT_GT(num_shown, 15);
}

// Law: turning and moving object and hand together on the table changes nothing.
TEST(TryGrasp, DoesNotDependOnWhereTheTwoStand) {
  Rng rng = Rng::Stream(3, "moves");
  std::set<GraspFault> met;
  int num_changed = 0;
  constexpr int kNumPoses = 300;
  ForManyPoses(kNumPoses, [&](const Mesh& object, const Isometry3f& pose) {
    Isometry3f moved_from_object(Eigen::AngleAxisf(Between(rng, 0.0F, 6.3F), Vector3f::UnitZ()));
    moved_from_object.translation() =
        Vector3f(Between(rng, -1.0F, 1.0F), Between(rng, -1.0F, 1.0F), 0.0F);
    Mesh moved = object;
    Transform(moved, moved_from_object);
    const GraspFault here = TryGrasp(TrialOf(object), pose).fault;
    met.insert(here);
    num_changed += TryGrasp(TrialOf(moved), moved_from_object * pose).fault == here ? 0 : 1;
  });
  EXPECT_LE(num_changed, 2) << "of " << kNumPoses << "; too near to call in single precision";
  EXPECT_GE(met.size(), 4U) << "several outcomes are met";
}

}  // namespace
}  // namespace handcraft::synthetic
