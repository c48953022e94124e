// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/arm_reach.h"

#include <gtest/gtest.h>

#include "datasets/synthetic/draw.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using testing::PoseOf;

// The hand whose wrist is here, approaching so.
Isometry3f WristAt(const Vector3f& wrist_m, const Vector3f& approach) {
  const Vector3f unit = approach.normalized();
  return PoseOf(wrist_m + Gripper{}.WristToGraspM() * unit, unit.unitOrthogonal(), unit);
}

TEST(ArmReach, KnowsHandCases) {
  const ArmReach arm{.shoulder_m = Vector3f::Zero()};
  const auto check = [&](const Vector3f& wrist_m, const Vector3f& approach) {
    return arm.Check(WristAt(wrist_m, approach), {});
  };
  EXPECT_EQ(check({0.6F, 0, 0}, Vector3f::UnitX()), GraspFault::kNone);
  EXPECT_EQ(check({0.6F, 0, 0}, -Vector3f::UnitZ()), GraspFault::kNone) << "from above";
  EXPECT_EQ(check({0.86F, 0, 0}, Vector3f::UnitX()), GraspFault::kOutOfReach);
  EXPECT_EQ(check({0.85F, 0, 0}, Vector3f::UnitX()), GraspFault::kNone);
  EXPECT_EQ(check({0.27F, 0, 0}, Vector3f::UnitX()), GraspFault::kOutOfReach) << "too near";
  EXPECT_EQ(check({0.6F, 0, 0}, {-1, 0, -1}), GraspFault::kFromBehind);
  EXPECT_EQ(check({0.6F, 0, 0}, -Vector3f::UnitX()), GraspFault::kOutOfReach)
      << "no wrist bends so";
  EXPECT_EQ(check({0.84F, 0, 0}, {-0.4F, 0, -1}), GraspFault::kOutOfReach)
      << "a stretched arm has no elbow to turn";
  EXPECT_EQ(check({0.6F, 0, 0}, {1.0F, 0, 0.3F}), GraspFault::kFromBelow);
}

TEST(ArmReach, RefusesPosesThatAreNotFinite) {
  Isometry3f pose = WristAt({0.6F, 0, 0}, Vector3f::UnitX());
  pose.translation().x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ArmReach{}.Check(pose, {}), GraspFault::kOutOfReach);
}

// The elbow of a Barrett WAM: two links whose axis is offset by 45 mm, joint 4 from −0.9 to 3.1.
TEST(ArmReach, HasTheLimitsOfTheElbow) {
  const Eigen::Vector2d upper(0.045, 0.55);
  const Eigen::Vector2d lower(-0.045, 0.3);
  double nearest_m = 10.0;
  double farthest_m = 0.0;
  for (double q = -0.9; q <= 3.1; q += 1e-4) {
    const double distance_m = (upper + Eigen::Rotation2Dd(-q) * lower).norm();
    nearest_m = std::min(nearest_m, distance_m);
    farthest_m = std::max(farthest_m, distance_m);
  }
  const ArmReach arm;
  EXPECT_NEAR(static_cast<double>(arm.upper_arm_m), upper.norm(), 1e-4);
  EXPECT_NEAR(static_cast<double>(arm.forearm_m), lower.norm(), 1e-4);
  EXPECT_NEAR(static_cast<double>(arm.nearest_m), nearest_m, 1e-3);
  EXPECT_NEAR(static_cast<double>(arm.farthest_m), farthest_m, 1e-3);
}

// The least angle between forearm and hand over all turns of the elbow about shoulder and wrist.
float LeastBend(const ArmReach& arm, const Vector3f& to_wrist, const Vector3f& approach) {
  const float distance_m = to_wrist.norm();
  const float along_m = (distance_m * distance_m + arm.upper_arm_m * arm.upper_arm_m -
                         arm.forearm_m * arm.forearm_m) /
                        (2.0F * distance_m);
  const float aside_m =
      std::sqrt(std::max(arm.upper_arm_m * arm.upper_arm_m - along_m * along_m, 0.0F));
  const Vector3f axis = to_wrist / distance_m;
  const Vector3f side = axis.unitOrthogonal();
  float least_rad = 10.0F;
  for (int i = 0; i < 720; ++i) {
    const Vector3f elbow =
        along_m * axis +
        aside_m * (Eigen::AngleAxisf(static_cast<float>(i) * 0.0087266F, axis) * side);
    const float cosine = (to_wrist - elbow).normalized().dot(approach);
    least_rad = std::min(least_rad, std::acos(std::clamp(cosine, -1.0F, 1.0F)));
  }
  return least_rad;
}

TEST(ArmReach, BendsTheWristAsTurningTheElbowAllows) {
  ArmReach arm{.shoulder_m = Vector3f::Zero(), .least_forward = -2.0F, .most_upward = 2.0F};
  Rng rng = Rng::Stream(1, "wrists");
  int num_reached = 0;
  constexpr int kNumPoses = 500;
  for (int i = 0; i < kNumPoses; ++i) {
    const auto draw = [&] {
      const auto x = static_cast<float>(rng.Normal());
      const auto y = static_cast<float>(rng.Normal());
      return Vector3f(x, y, static_cast<float>(rng.Normal())).normalized();
    };
    const Vector3f wrist_m = Between(rng, 0.28F, 0.85F) * draw();
    const Vector3f approach = draw();
    const float bend_rad = LeastBend(arm, wrist_m, approach);
    if (std::abs(bend_rad - arm.wrist_bend_rad) < 0.01F) continue;  // turns are 0.5° apart
    const bool reached = arm.Check(WristAt(wrist_m, approach), {}) == GraspFault::kNone;
    num_reached += reached ? 1 : 0;
    EXPECT_EQ(reached, bend_rad < arm.wrist_bend_rad) << i;
  }
  EXPECT_GT(num_reached, kNumPoses / 2);
  EXPECT_LT(num_reached, kNumPoses * 19 / 20);
}

TEST(ArmReach, IsTheSameInATurnedFrame) {
  const Isometry3f turned = Eigen::Translation3f(0.3F, -0.1F, 0.0F) *
                            Isometry3f(Eigen::AngleAxisf(2.0F, Vector3f::UnitZ()));
  const ArmReach arm = RightArm();
  Rng rng = Rng::Stream(2, "wrists");
  for (int i = 0; i < 100; ++i) {
    const Vector3f wrist_m(Between(rng, -0.5F, 0.5F), Between(rng, -0.5F, 0.5F), 0.2F);
    const Vector3f approach(Between(rng, -1.0F, 1.0F), Between(rng, -1.0F, 1.0F), -0.3F);
    const Isometry3f pose = WristAt(wrist_m, approach);
    EXPECT_EQ(arm.In(turned).Check(turned * pose, {}), arm.Check(pose, {})) << i;
  }
}

TEST(Arms, AreMirrored) {
  EXPECT_EQ(RightArm().shoulder_m.y(), -LeftArm().shoulder_m.y());
  EXPECT_LT(RightArm().shoulder_m.y(), 0.0F) << "y points to the robot's left";
  const Isometry3f pose = WristAt({-0.1F, -0.6F, 0.2F}, {1, -0.5F, -0.2F});
  EXPECT_EQ(RightArm().Check(pose, {}), GraspFault::kNone);
  EXPECT_EQ(LeftArm().Check(pose, {}), GraspFault::kOutOfReach);
}

}  // namespace
}  // namespace handcraft::synthetic
