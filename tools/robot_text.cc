// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/robot_text.h"

#include <cmath>
#include <vector>

#include "lib/core/fields.h"
#include "tools/number_option.h"

namespace handcraft::tools {

void AddRobotFile(CLI::App& command, std::string& file) {
  command.add_option("FILE", file, "TOML file: urdf, base, tip, locked joints, limits")->required();
}

CLI::Option* AddNumberList(CLI::App& command,
                           const std::string& name,
                           std::vector<double>& values,
                           const std::string& description) {
  return command.add_option(name, values, description)
      ->delimiter(',')
      ->expected(1, -1)
      ->transform(CheckNumber<double>(
          [](double value) { return std::isfinite(value) ? std::string() : "a finite number"; }))
      ->type_name("NUMBER,...");
}

nlohmann::ordered_json ToJson(const robot::Pose& pose) {
  return {{"position_m", pose.translation_m},
          {"quaternion_xyzw", robot::QuaternionFromRotation(pose.rotation)}};
}

std::string ToText(std::span<const double> values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ",";
    text += NumberToText(value);
  }
  return text;
}

nlohmann::ordered_json JointsToJson(const robot::SerialChain& chain,
                                    std::span<const double> joints) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t j = 0; j < chain.size(); ++j) json[chain.joints[j].name] = joints[j];
  return json;
}

}  // namespace handcraft::tools
