// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "lib/robot/serial_chain.h"

namespace handcraft::robot {

/// One arm of a robot, as a TOML file describes it.
struct RobotArm {
  std::string robot;           ///< name in the URDF
  std::filesystem::path urdf;  ///< found
  SerialChain chain;
};

/// Reads a robot file:
///
///     urdf = "dual_wam.urdf"   # beside this file, or an absolute path
///     base = "base"            # link that poses are given in
///     tip = "left_tool"        # link whose pose they are
///     [locked]                 # joints that do not move: rad or m
///     torso = 0.0
///     [limits]                 # in place of the URDF's: rad or m
///     left_j5 = [-4.55, 1.25]
///
/// Throws Error with path and line for keys that are unknown, missing or of another type, limits
/// the wrong way round, and joints that are not between base and tip; and those of ReadUrdf and
/// ChainBetween.
[[nodiscard]] RobotArm ReadRobotFile(const std::filesystem::path& path);

}  // namespace handcraft::robot
