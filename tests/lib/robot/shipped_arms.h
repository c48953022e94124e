// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/core/rng.h"
#include "lib/robot/robot_file.h"

/// The arms that the project ships, and joint values for them.
namespace handcraft::robot::testing {

inline SerialChain ShippedArm(const std::string& file) {
  return ReadRobotFile(HANDCRAFT_SOURCE_DIR "/models/robots/" + file).chain;
}
inline SerialChain LeftWam() { return ShippedArm("dual_wam/left_arm.toml"); }
inline SerialChain RightWam() { return ShippedArm("dual_wam/right_arm.toml"); }
inline SerialChain Panda() { return ShippedArm("franka_panda/panda.toml"); }

/// Uniform within the limits.
inline std::vector<double> DrawJoints(const SerialChain& chain, Rng& rng) {
  std::vector<double> joints;
  for (const Joint& joint : chain.joints) {
    joints.push_back(joint.lower + rng.Uniform() * (joint.upper - joint.lower));
  }
  return joints;
}

}  // namespace handcraft::robot::testing
