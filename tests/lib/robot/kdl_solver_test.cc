// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/kdl_solver.h"

#include <gtest/gtest.h>

#include "tests/lib/robot/shipped_arms.h"

namespace handcraft::robot {
namespace {

// KDL's own kinematics must mean the same arm: its answer is judged by ours.
TEST(KdlSolver, SolvesOnceNearTheStart) {
  for (const SerialChain& chain : {testing::Panda(), testing::LeftWam()}) {
    const KdlSolver solver(chain, {.position_tolerance_m = 1e-7, .rotation_tolerance_rad = 1e-7});
    Rng rng(1);
    for (int i = 0; i < 20; ++i) {
      const std::vector<double> start = testing::DrawJoints(chain, rng);
      std::vector<double> wanted = start;
      for (double& value : wanted) value += 0.02 * rng.Normal();
      const Pose pose = ForwardKinematics(chain, wanted);
      const auto joints = solver.SolveOnce(KdlMethod::kLevenbergMarquardt, pose, start);
      ASSERT_TRUE(joints);
      const PoseError error = ErrorBetween(ForwardKinematics(chain, *joints), pose);
      EXPECT_LT(error.position_m, 1e-6);
      EXPECT_LT(error.rotation_rad, 1e-6);
    }
  }
}

TEST(KdlSolver, HasAMethodThatKeepsTheLimits) {
  const SerialChain chain = testing::Panda();
  const KdlSolver solver(chain, {.position_tolerance_m = 1e-6, .rotation_tolerance_rad = 1e-6});
  const Pose pose = ForwardKinematics(chain, chain.Middle());
  std::vector<double> start = chain.Middle();
  for (double& value : start) value += 0.05;
  const auto joints = solver.SolveOnce(KdlMethod::kNewtonRaphsonLimits, pose, start);
  ASSERT_TRUE(joints);
  EXPECT_TRUE(chain.IsWithinLimits(*joints, 1e-12));
}

TEST(KdlSolver, TakesPrismaticJoints) {
  const SerialChain chain{
      .base = "base",
      .tip = "tip",
      .joints = {{.name = "slide",
                  .type = JointType::kPrismatic,
                  .parent_from_joint = {},
                  .lower = 0,
                  .upper = 1},
                 {.name = "turn", .parent_from_joint = {}, .lower = -2, .upper = 2}},
      .last_from_tip = {kIdentity3, {0.3, 0, 0}}};
  const std::vector<double> wanted = {0.4, -1.2};
  InverseKinematicsResult result;
  KdlSolver(chain).Solve(ForwardKinematics(chain, wanted), {}, result);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_NEAR(result.joints[0], 0.4, 1e-9);
  EXPECT_NEAR(result.joints[1], -1.2, 1e-9);
}

TEST(KdlSolver, SaysHowFarTheBestAttemptIs) {
  const SerialChain chain = testing::Panda();
  const KdlSolver solver(chain, {.max_starts = 3});
  InverseKinematicsResult result;
  Pose pose = ForwardKinematics(chain, chain.Middle());
  pose.translation_m = {3, 0, 0.5};
  solver.Solve(pose, {}, result);
  EXPECT_FALSE(result.IsSolved());
  EXPECT_EQ(result.best.joints.size(), 7U);
  EXPECT_GT(result.best.error.position_m, 1.5);
  EXPECT_LT(result.best.error.position_m, 2.5);
}

TEST(KdlSolver, GivesTheSameForTheSameSeed) {
  const SerialChain chain = testing::Panda();
  Rng rng(4);
  const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
  InverseKinematicsResult first;
  InverseKinematicsResult second;
  KdlSolver(chain, {.max_solutions = 4}).Solve(pose, {}, first);
  KdlSolver(chain, {.max_solutions = 4}).Solve(pose, {}, second);
  EXPECT_EQ(first.joints, second.joints);
}

}  // namespace
}  // namespace handcraft::robot
