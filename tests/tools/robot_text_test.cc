// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/robot_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::tools {
namespace {

using ::testing::ElementsAre;

TEST(RobotText, WritesPosesAndJoints) {
  EXPECT_EQ(ToText(std::vector<double>{0.5, -0.25, 3.0}), "0.5,-0.25,3");
  EXPECT_EQ(ToText({}), "");
  const auto json = ToJson(robot::Pose{robot::kIdentity3, {1, 2, 3}});
  EXPECT_EQ(json["position_m"][2], 3.0);
  EXPECT_EQ(json["quaternion_xyzw"][3], 1.0);
  robot::SerialChain chain;
  chain.joints = {{.name = "a", .parent_from_joint = {}}, {.name = "b", .parent_from_joint = {}}};
  EXPECT_EQ(JointsToJson(chain, std::vector<double>{1.5, 2.5}).dump(), R"({"a":1.5,"b":2.5})");
}

TEST(AddNumberList, ReadsWhatToTextWrites) {
  CLI::App app;
  std::vector<double> values;
  AddNumberList(app, "--joints", values, "values");
  app.parse("--joints -0.5,1e-3,2");
  EXPECT_THAT(values, ElementsAre(-0.5, 1e-3, 2.0));
  for (const char* wrong : {"--joints 1,x", "--joints 1,nan", "--joints inf"}) {
    EXPECT_THROW(app.parse(wrong), CLI::ParseError) << wrong;
  }
}

}  // namespace
}  // namespace handcraft::tools
