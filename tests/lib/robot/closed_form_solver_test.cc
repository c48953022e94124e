// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/closed_form_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/core/error.h"
#include "lib/robot/kdl_solver.h"
#include "lib/robot/nearest_attempt.h"
#include "tests/lib/robot/shipped_arms.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::robot {
namespace {

using handcraft::testing::AllocationCounter;
using ::testing::HasSubstr;

constexpr double kStep = 0.06981317007977318;

bool Contains(const InverseKinematicsResult& result,
              const std::vector<double>& joints,
              double tolerance) {
  for (std::size_t k = 0; k < result.size(); ++k) {
    const auto solution = result.Solution(k);
    if (std::equal(joints.begin(), joints.end(), solution.begin(), [&](double a, double b) {
          return std::abs(a - b) < tolerance;
        })) {
      return true;
    }
  }
  return false;
}

// Every solution brings the tip to the pose, within the limits, cheapest first.
void ExpectSound(const SerialChain& chain,
                 const Pose& pose,
                 const InverseKinematicsResult& result) {
  EXPECT_TRUE(std::is_sorted(result.costs.begin(), result.costs.end()));
  for (std::size_t k = 0; k < result.size(); ++k) {
    const PoseError error = ErrorBetween(ForwardKinematics(chain, result.Solution(k)), pose);
    EXPECT_LT(error.position_m, 1e-9);
    EXPECT_LT(error.rotation_rad, 1e-9);
    EXPECT_TRUE(chain.IsWithinLimits(result.Solution(k), 0.0));
  }
}

TEST(ClosedFormSolver, SolvesEveryReachablePose) {
  for (const SerialChain& chain : {testing::LeftWam(), testing::RightWam()}) {
    const ClosedFormSolver solver(chain);
    Rng rng(1);
    InverseKinematicsResult result;
    for (int i = 0; i < 500; ++i) {
      const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
      solver.Solve(pose, {}, result);
      ASSERT_TRUE(result.IsSolved()) << i;
      ExpectSound(chain, pose, result);
      EXPECT_LT(result.best.error.position_m, 1e-9);
    }
  }
}

// Joint values whose third is a sample must come back.
TEST(ClosedFormSolver, FindsTheSolutionOfASample) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  Rng rng(2);
  InverseKinematicsResult result;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> joints = testing::DrawJoints(chain, rng);
    joints[2] = chain.joints[2].lower + kStep * static_cast<double>(rng.UniformInt(81));
    solver.Solve(ForwardKinematics(chain, joints), {}, result);
    // A turn about a nearly singular wrist magnifies rounding.
    EXPECT_TRUE(Contains(result, joints, 1e-6)) << i;
  }
}

// Eight solutions of one sample: two elbows, two shoulders, two wrists; a stretched arm has room
// for all when nothing limits it.
TEST(ClosedFormSolver, FindsEightSolutionsASample) {
  SerialChain chain = testing::LeftWam();
  for (Joint& joint : chain.joints) {
    joint.lower = -3.2;
    joint.upper = 3.2;
  }
  chain.joints[2].lower = 0.3;
  chain.joints[2].upper = 0.3 + 0.5 * kStep;
  const ClosedFormSolver solver(chain);
  InverseKinematicsResult result;
  const std::vector<double> joints = {0.4, 0.5, 0.3, 0.9, -0.7, 0.8, 0.2};
  solver.Solve(ForwardKinematics(chain, joints), {}, result);
  EXPECT_EQ(result.size(), 8U);
  EXPECT_TRUE(Contains(result, joints, 1e-12));
}

// An independent solver's answers, with joint 3 moved to a sample, are among ours.
TEST(ClosedFormSolver, ContainsWhatKdlFinds) {
  const SerialChain chain = testing::LeftWam();
  Rng rng(3);
  InverseKinematicsResult from_kdl;
  InverseKinematicsResult result;
  for (int i = 0; i < 10; ++i) {
    const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
    KdlSolver(chain, {.max_starts = 6}).Solve(pose, {}, from_kdl);
    for (std::size_t k = 0; k < from_kdl.size(); ++k) {
      const auto solution = from_kdl.Solution(k);
      SerialChain shifted = chain;  // the grid starts at KDL's joint 3
      shifted.joints[2].lower = solution[2];
      ClosedFormSolver(shifted).Solve(pose, {}, result);
      EXPECT_TRUE(Contains(result, {solution.begin(), solution.end()}, 1e-6)) << i;
    }
  }
}

TEST(ClosedFormSolver, SolvesSingularPoses) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  InverseKinematicsResult result;
  // Shoulder and wrist singular; the shoulder alone; the wrist alone; the elbow stretched; corners.
  for (const std::vector<double>& joints : {std::vector<double>{0, 0, 0, 0, 0, 0, 0},
                                            {0.3, 0, 0.5, 1.0, 0.2, 0.4, 0.1},
                                            {0.3, 0.7, 0.5, 1.0, 0.2, 0, 0.1},
                                            {0.3, 0.7, 0.5, 0.2305, 0.2, 0.4, 0.1},
                                            {2.6, 2.0, 2.8, 3.1, 1.24, 1.6, 3.0},
                                            {-2.6, -2.0, -2.8, -0.9, -4.76, -1.6, -3.0}}) {
    const Pose pose = ForwardKinematics(chain, joints);
    solver.Solve(pose, {}, result);
    EXPECT_TRUE(result.IsSolved()) << joints[1] << " " << joints[5];
    ExpectSound(chain, pose, result);
  }
}

// Between two samples, in the middle of a room of a thousandth of a radian for every joint.
TEST(ClosedFormSolver, FindsWhatLiesBetweenTwoSamples) {
  Rng rng(5);
  InverseKinematicsResult result;
  for (int i = 0; i < 50; ++i) {
    SerialChain chain = testing::LeftWam();
    const std::vector<double> joints = testing::DrawJoints(chain, rng);
    for (std::size_t j = 0; j < 7; ++j) {
      if (j == 2) continue;
      chain.joints[j].lower = joints[j] - 5e-4;
      chain.joints[j].upper = joints[j] + 5e-4;
    }
    const Pose pose = ForwardKinematics(chain, joints);
    ClosedFormSolver(chain).Solve(pose, {}, result);
    EXPECT_TRUE(result.IsSolved()) << i;
    ExpectSound(chain, pose, result);
  }
}

TEST(ClosedFormSolver, TakesArmsWhoseAxesAreNotSquare) {
  SerialChain chain = testing::LeftWam();
  for (const std::size_t j : {1U, 2U, 5U, 6U}) {
    Matrix3& rotation = chain.joints[j].parent_from_joint.rotation;
    rotation = Multiply(rotation, AxisRotation({1, 0, 0}, 0.2));
  }
  const ClosedFormSolver solver(chain);
  Rng rng(6);
  InverseKinematicsResult result;
  for (int i = 0; i < 200; ++i) {
    const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
    solver.Solve(pose, {}, result);
    EXPECT_TRUE(result.IsSolved()) << i;
    ExpectSound(chain, pose, result);
  }
}

// The wrist 0.1 m beyond the stretched arm.
TEST(ClosedFormSolver, SaysHowFarTheBestAttemptIs) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  std::vector<double> joints = {0.3, 0.7, 0.5, 0.23049, 0.2, 0.4, 0.1};
  Pose pose = ForwardKinematics(chain, joints);
  const SphericalArm arm = *FindSphericalArm(chain).arm;
  std::vector<JointLine> lines(7);
  static_cast<void>(ForwardKinematics(chain, joints, lines));
  const Vector3 reach = Subtract(lines[6].point_m, arm.shoulder.centre_m);
  pose.translation_m = Add(pose.translation_m, Scale(reach, 0.1 / Norm(reach)));
  InverseKinematicsResult result;
  solver.Solve(pose, {}, result);
  EXPECT_FALSE(result.IsSolved());
  ASSERT_EQ(result.best.joints.size(), 7U);
  EXPECT_LT(std::sqrt(SquaredError(result.best.error)), 0.1 + 1e-6);
  EXPECT_GT(std::sqrt(SquaredError(result.best.error)), 0.05);
  EXPECT_TRUE(chain.IsWithinLimits(result.best.joints, 0.0));
  const PoseError again = ErrorBetween(ForwardKinematics(chain, result.best.joints), pose);
  EXPECT_NEAR(again.position_m, result.best.error.position_m, 1e-12);
}

// Same solutions, but no attempt where there is none, even if the result held one.
TEST(ClosedFormSolver, FindSolutionsLooksForNoAttempt) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  Rng rng(6);
  InverseKinematicsResult solved;
  InverseKinematicsResult found;
  for (int i = 0; i < 50; ++i) {
    const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
    solver.Solve(pose, {}, solved);
    solver.FindSolutions(pose, {}, found);
    ASSERT_TRUE(found.IsSolved()) << i;
    EXPECT_EQ(found.joints, solved.joints);
    EXPECT_EQ(found.best.joints, solved.best.joints);
  }
  solver.FindSolutions({kIdentity3, {3.0, 0.0, 0.0}}, {}, found);
  EXPECT_FALSE(found.IsSolved());
  EXPECT_TRUE(found.best.joints.empty());
}

TEST(ClosedFormSolver, AnswersPosesAtTheShoulderAndFarAway) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  InverseKinematicsResult result;
  for (const Vector3& place :
       {Vector3{-0.5, 0.3, 0.35}, {1e6, 0, 0}, {0, -1e300, 0}, {-0.5, 0.3, 0.41}}) {
    solver.Solve({kIdentity3, place}, {}, result);
    EXPECT_FALSE(result.IsSolved());
    EXPECT_GT(result.best.error.position_m + result.best.error.rotation_rad, 0.1);
  }
}

TEST(ClosedFormSolver, PrefersWhatIsNearTheReference) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  Rng rng(7);
  InverseKinematicsResult result;
  for (int i = 0; i < 50; ++i) {
    std::vector<double> joints = testing::DrawJoints(chain, rng);
    joints[2] = chain.joints[2].lower + kStep * 40.0;
    solver.Solve(ForwardKinematics(chain, joints), joints, result);
    ASSERT_TRUE(result.IsSolved());
    EXPECT_LT(result.costs[0], 1e-12);
  }
}

TEST(ClosedFormSolver, AllocatesNothingAfterTheFirstCalls) {
  const SerialChain chain = testing::LeftWam();
  const ClosedFormSolver solver(chain);
  const Pose pose =
      ForwardKinematics(chain, std::vector<double>{0.3, 0.7, 0.5, 1.0, 0.2, 0.4, 0.1});
  InverseKinematicsResult result;
  solver.Solve(pose, {}, result);
  ASSERT_TRUE(result.IsSolved());
  if (!AllocationCounter::Available()) GTEST_SKIP() << "the sanitizer has a malloc of its own";
  const AllocationCounter counter;
  solver.Solve(pose, {}, result);
  EXPECT_EQ(counter.Count(), 0U);
}

// As read from a text with seven digits.
TEST(ClosedFormSolver, TakesRotationsThatWereRounded) {
  const SerialChain chain = testing::LeftWam();
  Pose pose = ForwardKinematics(chain, std::vector<double>{0.3, 0.7, 0.5, 1.0, 0.2, 0.4, 0.1});
  for (double& entry : pose.rotation) entry = std::round(1e7 * entry) / 1e7;
  InverseKinematicsResult result;
  ClosedFormSolver(chain).Solve(pose, {}, result);
  ASSERT_TRUE(result.IsSolved());
  EXPECT_LT(result.best.error.rotation_rad, 1e-9);
}

TEST(ClosedFormSolver, SaysWhyAnArmHasNone) {
  EXPECT_THROWS_MESSAGE(
      ClosedFormSolver(testing::Panda()),
      Error,
      HasSubstr("no closed form for 'panda_link8': the axes of the wrist do not meet"));
  EXPECT_THROWS_MESSAGE(ClosedFormSolver(testing::LeftWam(), {.free_joint_step_rad = 0.0}),
                        Error,
                        HasSubstr("free_joint_step_rad"));
}

}  // namespace
}  // namespace handcraft::robot
