// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

const std::string kRobots = HANDCRAFT_SOURCE_DIR "/models/robots/";

TEST(RobotInfo, DescribesAnArmWithAClosedForm) {
  const Outcome outcome = RunLine("robot info " + kRobots + "dual_wam/left_arm.toml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("left_tool moves against base"),
                    HasSubstr("left_j5"),
                    HasSubstr("-4.76"),
                    HasSubstr("Inverse kinematics: closed form\n")));
}

TEST(RobotInfo, SaysWhyAnArmHasNone) {
  const Outcome outcome = RunLine("robot info " + kRobots + "franka_panda/panda.toml --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["inverse_kinematics"], "Orocos KDL");
  EXPECT_EQ(json["joints"].size(), 7U);
  EXPECT_THAT(json["no_closed_form"].get<std::string>(), HasSubstr("the wrist do not meet"));
}

TEST(RobotInfo, NamesAMissingFile) {
  const Outcome outcome = RunLine("robot info no.toml");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no.toml"));
}

}  // namespace
}  // namespace handcraft::tools
