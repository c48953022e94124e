// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "lib/robot/inverse_kinematics.h"
#include "tests/lib/robot/shipped_arms.h"

namespace handcraft::robot {
namespace {

TEST(MakeInverseKinematics, TakesTheClosedFormWhereThereIsOne) {
  EXPECT_EQ(MakeInverseKinematics(testing::LeftWam())->Method(), "closed form");
  EXPECT_EQ(MakeInverseKinematics(testing::Panda())->Method(), "Orocos KDL");
}

// The same call for arms of two makes.
TEST(MakeInverseKinematics, SolvesEitherArm) {
  for (const SerialChain& chain : {testing::RightWam(), testing::Panda()}) {
    const auto solver = MakeInverseKinematics(chain, {.max_solutions = 2});
    Rng rng(1);
    InverseKinematicsResult result;
    for (int i = 0; i < 10; ++i) {
      const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
      solver->Solve(pose, {}, result);
      ASSERT_TRUE(result.IsSolved()) << solver->Method();
      for (std::size_t k = 0; k < result.size(); ++k) {
        const PoseError error = ErrorBetween(ForwardKinematics(chain, result.Solution(k)), pose);
        EXPECT_LE(error.position_m, 1e-9);
        EXPECT_LE(error.rotation_rad, 1e-9);
        EXPECT_TRUE(chain.IsWithinLimits(result.Solution(k), 0.0));
      }
    }
  }
}

}  // namespace
}  // namespace handcraft::robot
