// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "lib/robot/robot_file.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/robot_text.h"

namespace handcraft::tools {
namespace {

struct RobotFkOptions {
  std::string file;
  std::vector<double> joints;
  bool json = false;
};

void RunRobotFk(const RobotFkOptions& options, const Console& console) {
  const robot::RobotArm arm = robot::ReadRobotFile(options.file);
  arm.chain.RequireWithinLimits(options.joints);
  const robot::Pose pose = robot::ForwardKinematics(arm.chain, options.joints);
  if (options.json) {
    console.Print(ToJson(pose));
    return;
  }
  console.out << "position [m]        " << ToText(pose.translation_m) << "\nquaternion x,y,z,w  "
              << ToText(robot::QuaternionFromRotation(pose.rotation)) << '\n';
}

}  // namespace

void AddRobotFk(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<RobotFkOptions>();
  CLI::App* command =
      parent.add_subcommand("fk", "Forward kinematics: where the tip is, in the base's frame");
  AddRobotFile(*command, options->file);
  AddNumberList(*command, "--joints", options->joints, "Joint values [rad or m]")->required();
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft robot fk models/robots/dual_wam/left_arm.toml --joints "
             "0.1,-1.2,0.3,1.9,0.2,0.4,-0.5");
  command->callback([options, &console] { RunRobotFk(*options, console); });
}

}  // namespace handcraft::tools
