// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lib/robot/inverse_kinematics.h"
#include "lib/robot/robot_file.h"
#include "lib/robot/spherical_arm.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/robot_text.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct RobotInfoOptions {
  std::string file;
  bool json = false;
};

const char* NameOf(robot::JointType type) {
  return type == robot::JointType::kPrismatic ? "prismatic" : "revolute";
}

void RunRobotInfo(const RobotInfoOptions& options, const Console& console) {
  const robot::RobotArm arm = robot::ReadRobotFile(options.file);
  const auto solver = robot::MakeInverseKinematics(arm.chain);
  const std::string reason = robot::FindSphericalArm(arm.chain).reason;
  if (options.json) {
    Json joints = Json::array();
    for (const robot::Joint& joint : arm.chain.joints) {
      joints.push_back({{"name", joint.name},
                        {"type", NameOf(joint.type)},
                        {"lower", joint.lower},
                        {"upper", joint.upper}});
    }
    console.Print({{"robot", arm.robot},
                   {"urdf", arm.urdf.string()},
                   {"base", arm.chain.base},
                   {"tip", arm.chain.tip},
                   {"inverse_kinematics", solver->Method()},
                   {"no_closed_form", reason},
                   {"joints", joints}});
    return;
  }
  console.out << fmt::format("Robot {}: {} moves against {} ({})\n\n",
                             arm.robot,
                             arm.chain.tip,
                             arm.chain.base,
                             arm.urdf.string());
  TextTable table({"joint", "type", "lower", "upper", "unit"});
  for (const robot::Joint& joint : arm.chain.joints) {
    table.AddRow({joint.name,
                  NameOf(joint.type),
                  fmt::format("{:.4g}", joint.lower),
                  fmt::format("{:.4g}", joint.upper),
                  joint.type == robot::JointType::kPrismatic ? "m" : "rad"});
  }
  console.out << table.ToText() << fmt::format("\nInverse kinematics: {}", solver->Method())
              << (reason.empty() ? "" : " (no closed form: " + reason + ")") << '\n';
}

}  // namespace

void AddRobotInfo(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<RobotInfoOptions>();
  CLI::App* command = parent.add_subcommand("info", "The joints of an arm and how it is solved");
  AddRobotFile(*command, options->file);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft robot info models/robots/dual_wam/left_arm.toml");
  command->callback([options, &console] { RunRobotInfo(*options, console); });
}

}  // namespace handcraft::tools
