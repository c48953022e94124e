// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/robot_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "lib/robot/urdf.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::robot {
namespace {

// Joint values are angles or lengths: nothing sound is larger.
constexpr double kLargest = 1e3;

std::map<std::string, double> ReadLocked(const TomlTable& file) {
  std::map<std::string, double> locked;
  if (!file.Has("locked")) return locked;
  const TomlTable table = file.Table("locked");
  for (const auto& [key, node] : table.table()) {
    locked[std::string(key.str())] = table.Number(key.str(), -kLargest, kLargest);
  }
  return locked;
}

// The joint of a name; throws Error at `node` when the chain has none.
Joint& FindJoint(SerialChain& chain,
                 const TomlTable& table,
                 const toml::node& node,
                 std::string_view name) {
  const auto found = std::find_if(chain.joints.begin(),
                                  chain.joints.end(),
                                  [&](const Joint& joint) { return joint.name == name; });
  if (found == chain.joints.end()) {
    table.Fail(node,
               fmt::format("'{}' is no joint that moves '{}'", name, chain.tip),
               fmt::format("there are: {}", chain.JointNames()));
  }
  return *found;
}

// Number i of the two that `node`, the limits of a joint, must hold.
double ReadLimit(const TomlTable& table,
                 const toml::node& node,
                 std::string_view joint,
                 std::size_t i) {
  const toml::array* const pair = node.as_array();
  const bool is_pair = pair != nullptr && pair->size() == 2;
  const auto value = is_pair ? (*pair)[i].value<double>() : std::nullopt;
  if (!value || !(std::abs(*value) <= kLargest)) {
    table.Fail(node, fmt::format("limits of '{}' must be two numbers, [lower, upper]", joint));
  }
  return *value;
}

void ApplyLimits(const TomlTable& file, SerialChain& chain) {
  if (!file.Has("limits")) return;
  const TomlTable table = file.Table("limits");
  for (const auto& [key, node] : table.table()) {
    Joint& joint = FindJoint(chain, table, node, key.str());
    joint.lower = ReadLimit(table, node, key.str(), 0);
    joint.upper = ReadLimit(table, node, key.str(), 1);
    if (!(joint.lower < joint.upper)) {
      table.Fail(
          node,
          fmt::format("the limits of '{}' are the wrong way round: lower {} is not below upper {}",
                      key.str(),
                      joint.lower,
                      joint.upper),
          "exchange them");
    }
  }
}

}  // namespace

RobotArm ReadRobotFile(const std::filesystem::path& path) {
  const toml::table parsed = ReadTomlFile(path);
  const TomlTable file(path.string(), parsed, "");
  constexpr std::array<std::string_view, 5> kKeys = {"urdf", "base", "tip", "locked", "limits"};
  file.AllowOnly(kKeys);
  const std::filesystem::path urdf_path = path.parent_path() / file.Text("urdf");
  const Urdf urdf = ReadUrdf(urdf_path);
  RobotArm arm{.robot = urdf.robot,
               .urdf = urdf_path,
               .chain = ChainBetween(urdf, file.Text("base"), file.Text("tip"), ReadLocked(file))};
  ApplyLimits(file, arm.chain);
  return arm;
}

}  // namespace handcraft::robot
