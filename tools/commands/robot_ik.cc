// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lib/core/error.h"
#include "lib/robot/inverse_kinematics.h"
#include "lib/robot/robot_file.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/robot_text.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct RobotIkOptions {
  std::string file;
  std::vector<double> position_m;
  std::vector<double> quaternion_xyzw = {0.0, 0.0, 0.0, 1.0};
  std::vector<double> reference;
  double step_deg = 4.0;
  int num_shown = 10;
  robot::InverseKinematicsOptions solver;
  bool json = false;
};

// The numbers of an option that has to have `N` of them.
template <std::size_t N>
std::array<double, N> Exactly(const std::vector<double>& values, const std::string& option) {
  if (values.size() != N) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format("{}: {} numbers given; {} are due", option, values.size(), N)});
  }
  std::array<double, N> array{};
  std::copy(values.begin(), values.end(), array.begin());
  return array;
}

Json ToJson(const robot::InverseKinematics& solver, const robot::InverseKinematicsResult& result) {
  Json solutions = Json::array();
  for (std::size_t i = 0; i < result.size(); ++i) {
    solutions.push_back({{"cost", result.costs[i]}, {"joints", result.Solution(i)}});
  }
  std::vector<std::string> names;
  for (const robot::Joint& joint : solver.chain().joints) names.push_back(joint.name);
  return {{"method", solver.Method()},
          {"solved", result.IsSolved()},
          {"joint_names", names},
          {"solutions", solutions},
          {"best",
           {{"joints", JointsToJson(solver.chain(), result.best.joints)},
            {"position_error_m", result.best.error.position_m},
            {"rotation_error_rad", result.best.error.rotation_rad}}}};
}

std::string ToText(const robot::InverseKinematics& solver,
                   const robot::InverseKinematicsResult& result,
                   int num_shown) {
  std::vector<std::string> head = {"cost"};
  for (const robot::Joint& joint : solver.chain().joints) head.push_back(joint.name);
  TextTable table(head);
  const std::size_t count = std::min(result.size(), static_cast<std::size_t>(num_shown));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::string> row = {fmt::format("{:.4f}", result.costs[i])};
    for (const double value : result.Solution(i)) row.push_back(fmt::format("{:.4f}", value));
    table.AddRow(row);
  }
  return table.ToText() + fmt::format(
                              "\n{} solutions within the limits ({}), {} shown; the first is off "
                              "by {:.1e} m and {:.1e} rad\n",
                              result.size(),
                              solver.Method(),
                              count,
                              result.best.error.position_m,
                              result.best.error.rotation_rad);
}

// Of any length but 0.
std::array<double, 4> ReadQuaternion(const std::vector<double>& values) {
  const std::array<double, 4> xyzw = Exactly<4>(values, "--quaternion");
  const double length = std::hypot(std::hypot(xyzw[0], xyzw[1]), std::hypot(xyzw[2], xyzw[3]));
  if (length >= 1e-6 && length <= 1e6) return xyzw;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = fmt::format("--quaternion: a length of {:.4g} given; a rotation has one "
                                     "of 1",
                                     length),
               .remedy = "0,0,0,1 turns nothing"});
}

void RunRobotIk(const RobotIkOptions& options, const Console& console) {
  const robot::Pose pose{robot::RotationFromQuaternion(ReadQuaternion(options.quaternion_xyzw)),
                         Exactly<3>(options.position_m, "--position")};
  const robot::RobotArm arm = robot::ReadRobotFile(options.file);
  robot::InverseKinematicsOptions solver_options = options.solver;
  solver_options.free_joint_step_rad = options.step_deg * std::numbers::pi / 180.0;
  const auto solver = robot::MakeInverseKinematics(arm.chain, solver_options);
  robot::InverseKinematicsResult result;
  solver->Solve(pose, options.reference, result);
  if (options.json) console.Print(ToJson(*solver, result));
  if (!result.IsSolved()) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = fmt::format("no joint values within the limits reach the pose; the best "
                                       "attempt is off by {:.4g} m and {:.4g} rad, at --joints {}",
                                       result.best.error.position_m,
                                       result.best.error.rotation_rad,
                                       tools::ToText(result.best.joints)),
                 .remedy = "ask for a pose that is nearer to the arm"});
  }
  if (!options.json) console.out << ToText(*solver, result, options.num_shown);
}

}  // namespace

void AddRobotIk(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<RobotIkOptions>();
  CLI::App* command = parent.add_subcommand(
      "ik", "Inverse kinematics: joint values that bring the tip to a pose, cheapest first");
  AddRobotFile(*command, options->file);
  AddNumberList(
      *command, "--position", options->position_m, "Of the tip in the base's frame, x,y,z [m]")
      ->required();
  AddNumberList(*command, "--quaternion", options->quaternion_xyzw, "Rotation of the tip, x,y,z,w")
      ->capture_default_str();
  AddNumberList(*command,
                "--reference",
                options->reference,
                "Joint values that solutions are to be near; else the middle of the limits");
  AddNumber(*command,
            "--step-deg",
            options->step_deg,
            CheckNumber<double>([](double value) {
              return value >= 0.06 && value <= 57.0 ? std::string() : "from 0.06 to 57";
            }),
            "Step of joint 3 in the closed form [deg]");
  AddNumber(*command,
            "--show",
            options->num_shown,
            IntegerWithin(1, 100000),
            "Solutions to print; --json has all");
  AddSeedOption(*command, options->solver.seed);
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft robot ik models/robots/dual_wam/left_arm.toml --position 0,0.1,0.3 "
             "--quaternion 0,1,0,0");
  command->callback([options, &console] { RunRobotIk(*options, console); });
}

}  // namespace handcraft::tools
