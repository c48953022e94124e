// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

const std::string kArm = HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/left_arm.toml";

// All joints at 0: the arm is stretched to the left, 0.3 + 0.55 + 0.3 + 0.06 m from the middle.
TEST(RobotFk, TellsWhereTheStretchedArmEnds) {
  const Outcome outcome = RunLine("robot fk " + kArm + " --joints 0,0,0,0,0,0,0 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_NEAR(json["position_m"][0].get<double>(), -0.5, 1e-12);
  EXPECT_NEAR(json["position_m"][1].get<double>(), 1.21, 1e-12);
  EXPECT_NEAR(json["position_m"][2].get<double>(), 0.35, 1e-12);
  EXPECT_NEAR(json["quaternion_xyzw"][0].get<double>(), -0.70710678, 1e-8);
  EXPECT_THAT(RunLine("robot fk " + kArm + " --joints 0,0,0,0,0,0,0").out,
              HasSubstr("position [m]"));
}

TEST(RobotFk, RefusesJointsThatAreNone) {
  Outcome outcome = RunLine("robot fk " + kArm + " --joints 0,0,0");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("3 joint values given; the arm has 7: left_j1"));
  outcome = RunLine("robot fk " + kArm + " --joints 0,0,0,4,0,0,0");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("joint left_j4 is 4; its limits are -0.9 and 3.1"));
  outcome = RunLine("robot fk " + kArm + " --joints 0,x");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("x given; it must be a number"));
}

}  // namespace
}  // namespace handcraft::tools
