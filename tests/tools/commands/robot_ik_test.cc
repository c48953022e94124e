// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/run.h"
#include "tools/robot_text.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

const std::string kArm = HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/left_arm.toml";
const std::string kPanda = HANDCRAFT_SOURCE_DIR "/models/robots/franka_panda/panda.toml";
constexpr const char* kReached = " --position 0,0.1,0.3 --quaternion 0,1,0,0 ";

TEST(RobotIk, PrintsSolutionsThatFkConfirms) {
  const Outcome outcome = RunLine("robot ik " + kArm + kReached + "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json["solved"].get<bool>());
  ASSERT_GT(json["solutions"].size(), 10U);
  const auto joints = json["solutions"][0]["joints"].get<std::vector<double>>();
  const Outcome back = RunLine("robot fk " + kArm + " --json --joints " + ToText(joints));
  ASSERT_EQ(back.code, 0) << back.err;
  const auto pose = nlohmann::json::parse(back.out);
  EXPECT_NEAR(pose["position_m"][1].get<double>(), 0.1, 1e-9);
  EXPECT_NEAR(std::abs(pose["quaternion_xyzw"][1].get<double>()), 1.0, 1e-9);
}

TEST(RobotIk, PrintsATableOfTheFirst) {
  const Outcome outcome = RunLine("robot ik " + kArm + kReached + "--show 3");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("left_j7"), HasSubstr("3 shown"), HasSubstr("(closed form)")));
}

TEST(RobotIk, SolvesAnArmOfAnotherMake) {
  const Outcome outcome =
      RunLine("robot ik " + kPanda + " --position 0.4,0.1,0.5 --quaternion 1,0,0,0 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["method"], "Orocos KDL");
}

TEST(RobotIk, SaysHowFarTheBestAttemptIs) {
  const Outcome outcome = RunLine("robot ik " + kArm + " --position 2,0,0.3 --json");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("no joint values within the limits reach the pose"),
                    HasSubstr(" rad, at --joints ")));
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(json["solved"].get<bool>());
  EXPECT_GT(json["best"]["position_error_m"].get<double>(), 1.0);
  EXPECT_TRUE(json["best"]["joints"].contains("left_j1"));
}

TEST(RobotIk, RefusesWhatIsNoPose) {
  Outcome outcome = RunLine("robot ik " + kArm + " --position 0,0");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--position: 2 numbers given; 3 are due"));
  outcome = RunLine("robot ik " + kArm + " --position 0,0,nan");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nan given; it must be a finite number"));
  outcome = RunLine("robot ik " + kArm + " --position 0,0,0 --quaternion 0,0,0,0");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--quaternion: a length of 0 given; a rotation has one of 1"));
  EXPECT_EQ(RunLine("robot ik " + kArm + kReached + "--step-deg 0").code, 2);
  outcome = RunLine("robot ik " + kArm + kReached + "--reference 9,0,0,0,0,0,0");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("joint left_j1 is 9"));
}

}  // namespace
}  // namespace handcraft::tools
