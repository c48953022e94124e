// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/nearest_attempt.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/lib/robot/shipped_arms.h"

namespace handcraft::robot {
namespace {

TEST(SquaredError, WeighsTurnsByATenthOfAMetre) {
  EXPECT_DOUBLE_EQ(SquaredError({.position_m = 0.3, .rotation_rad = 4.0}), 0.25);
}

TEST(MoveToNearest, ReachesPosesNearby) {
  for (const SerialChain& chain : {testing::LeftWam(), testing::Panda()}) {
    Rng rng(1);
    for (int i = 0; i < 100; ++i) {
      const std::vector<double> wanted = testing::DrawJoints(chain, rng);
      std::vector<double> joints = wanted;
      for (std::size_t j = 0; j < joints.size(); ++j) {
        joints[j] = std::clamp(
            joints[j] + 0.05 * rng.Normal(), chain.joints[j].lower, chain.joints[j].upper);
      }
      const Pose goal = ForwardKinematics(chain, wanted);
      const PoseError error = MoveToNearest(chain, goal, joints);
      EXPECT_LT(error.position_m, 1e-9) << i;
      EXPECT_LT(error.rotation_rad, 1e-9) << i;
      EXPECT_TRUE(chain.IsWithinLimits(joints, 0.0));
      const PoseError again = ErrorBetween(goal, ForwardKinematics(chain, joints));
      EXPECT_NEAR(again.position_m, error.position_m, 1e-14);
    }
  }
}

// Two links of 1 m in a plane: the nearest to a point beyond reach is the arm stretched towards it.
TEST(MoveToNearest, StretchesTowardsWhatIsOutOfReach) {
  const SerialChain chain{
      .base = "base",
      .tip = "tip",
      .joints =
          {{.name = "a", .parent_from_joint = {}, .lower = -3, .upper = 3},
           {.name = "b", .parent_from_joint = {kIdentity3, {1, 0, 0}}, .lower = -3, .upper = 3}},
      .last_from_tip = {kIdentity3, {1, 0, 0}}};
  std::vector<double> joints = {0.2, 0.3};
  const PoseError error = MoveToNearest(chain, {kIdentity3, {2.5, 0, 0}}, joints);
  EXPECT_NEAR(error.position_m, 0.5, 1e-6);
  EXPECT_NEAR(error.rotation_rad, 0.0, 1e-3);
}

TEST(MoveToNearest, StopsAtALimit) {
  const SerialChain chain{
      .base = "base",
      .tip = "tip",
      .joints = {{.name = "a", .parent_from_joint = {}, .lower = -1, .upper = 0.5}},
      .last_from_tip = {kIdentity3, {1, 0, 0}}};
  std::vector<double> joints = {0.0};
  const Pose goal{AxisRotation({0, 0, 1}, 0.8), {std::cos(0.8), std::sin(0.8), 0}};
  const PoseError error = MoveToNearest(chain, goal, joints);
  EXPECT_DOUBLE_EQ(joints[0], 0.5);
  EXPECT_NEAR(error.rotation_rad, 0.3, 1e-12);
}

}  // namespace
}  // namespace handcraft::robot
