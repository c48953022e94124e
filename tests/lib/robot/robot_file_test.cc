// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/robot_file.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/lib/robot/shipped_arms.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::robot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A file for the left arm of the shipped torso with more lines after it.
RobotArm ReadLeftArmWith(const std::string& lines) {
  const handcraft::testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "arm.toml",
                      "urdf = '" + std::filesystem::absolute(HANDCRAFT_SOURCE_DIR).string() +
                          "/models/robots/dual_wam/dual_wam.urdf'\n"
                          "base = 'base'\ntip = 'left_tool'\n" +
                          lines);
  return ReadRobotFile(folder / "arm.toml");
}

TEST(ReadRobotFile, ReadsTheShippedArms) {
  EXPECT_EQ(testing::LeftWam().JointNames(),
            "left_j1, left_j2, left_j3, left_j4, left_j5, left_j6, left_j7");
  EXPECT_EQ(testing::RightWam().joints[4].lower, -4.76);
  EXPECT_EQ(testing::Panda().size(), 7U);
}

TEST(ReadRobotFile, TakesLimitsAndLockedJoints) {
  const RobotArm arm = ReadLeftArmWith(
      "[locked]\nleft_j7 = 0.5\n[limits]\nleft_j5 = [-4.55, 1.25]\nleft_j2 = [-1, 1]\n");
  EXPECT_EQ(arm.robot, "dual_wam");
  ASSERT_EQ(arm.chain.size(), 6U);
  EXPECT_EQ(arm.chain.joints[4].lower, -4.55);
  EXPECT_EQ(arm.chain.joints[1].upper, 1.0);
  std::vector<double> joints = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const Pose locked = ForwardKinematics(arm.chain, joints);
  joints.push_back(0.5);
  const PoseError error = ErrorBetween(locked, ForwardKinematics(testing::LeftWam(), joints));
  EXPECT_LT(error.position_m + error.rotation_rad, 1e-14);
}

TEST(ReadRobotFile, NamesTheLineOfWhatIsWrong) {
  EXPECT_THROWS_MESSAGE(
      ReadLeftArmWith("[limits]\nleft_j5 = [1.25, -4.55]\n"),
      Error,
      AllOf(HasSubstr("arm.toml:5: the limits of 'left_j5' are the wrong way round"),
            HasSubstr("exchange them")));
  EXPECT_THROWS_MESSAGE(
      ReadLeftArmWith("[limits]\nright_j5 = [0, 1]\n"),
      Error,
      AllOf(HasSubstr("arm.toml:5: 'right_j5' is no joint that moves 'left_tool'"),
            HasSubstr("there are: left_j1, ")));
  EXPECT_THROWS_MESSAGE(
      ReadLeftArmWith("[limits]\nleft_j5 = [0, 1, 2]\n"), Error, HasSubstr("must be two numbers"));
  EXPECT_THROWS_MESSAGE(
      ReadLeftArmWith("[limits]\nleft_j5 = [0, nan]\n"), Error, HasSubstr("must be two numbers"));
  EXPECT_THROWS_MESSAGE(ReadLeftArmWith("[locked]\nelbow = 0\n"),
                        Error,
                        HasSubstr("the locked joint 'elbow' is not between"));
  EXPECT_THROWS_MESSAGE(
      ReadLeftArmWith("[locked]\nleft_j1 = 'x'\n"), Error, HasSubstr("arm.toml:5"));
  EXPECT_THROWS_MESSAGE(
      ReadLeftArmWith("limit = 1\n"), Error, HasSubstr("\"limit\" is no key of this file"));
}

TEST(ReadRobotFile, NamesWhatIsMissing) {
  const handcraft::testing::TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(ReadRobotFile(folder / "no.toml"), Error, HasSubstr("No such file"));
  WriteFileAtomically(folder / "arm.toml", "base = 'a'\n");
  EXPECT_THROWS_MESSAGE(ReadRobotFile(folder / "arm.toml"), Error, HasSubstr("urdf is missing"));
  WriteFileAtomically(folder / "arm.toml", "urdf = 'no.urdf'\n");
  EXPECT_THROWS_MESSAGE(ReadRobotFile(folder / "arm.toml"), Error, HasSubstr("no.urdf"));
}

}  // namespace
}  // namespace handcraft::robot
