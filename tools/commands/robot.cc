// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/commands.h"

namespace handcraft::tools {

void AddRobot(CLI::App& parent, const Console& console) {
  CLI::App* robot = parent.add_subcommand(
      "robot", "Describe an arm and solve its kinematics, from URDF and TOML");
  robot->require_subcommand(1);
  AddRobotInfo(*robot, console);
  AddRobotFk(*robot, console);
  AddRobotIk(*robot, console);
}

}  // namespace handcraft::tools
