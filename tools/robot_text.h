// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "lib/robot/serial_chain.h"

namespace handcraft::tools {

/// Adds the positional FILE of the robot commands.
void AddRobotFile(CLI::App& command, std::string& file);

/// An option for numbers separated by commas, none of them other than a finite number.
CLI::Option* AddNumberList(CLI::App& command,
                           const std::string& name,
                           std::vector<double>& values,
                           const std::string& description);

/// {"position_m": [x, y, z], "quaternion_xyzw": [x, y, z, w]}
[[nodiscard]] nlohmann::ordered_json ToJson(const robot::Pose& pose);

/// Numbers separated by commas, as AddNumberList reads them back: "0.1,-0.25".
[[nodiscard]] std::string ToText(std::span<const double> values);

/// Joint values by the names of their joints.
[[nodiscard]] nlohmann::ordered_json JointsToJson(const robot::SerialChain& chain,
                                                  std::span<const double> joints);

}  // namespace handcraft::tools
