// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lib/robot/serial_chain.h"

namespace handcraft::robot {

/// A joint of a URDF file, whatever its type.
struct UrdfJoint {
  std::string name;
  std::string type;  ///< "revolute", "continuous", "prismatic", "fixed"; others as they stand
  std::string parent;
  std::string child;
  Pose parent_from_joint = {};
  Vector3 axis = {1, 0, 0};  ///< unit vector
  bool has_limits = false;
  double lower = 0.0;
  double upper = 0.0;
  bool is_mimic = false;  ///< follows another joint
};

/// The links and joints of a URDF file; masses, shapes and sensors are passed over.
struct Urdf {
  std::filesystem::path path;
  std::string robot;
  std::vector<std::string> links = {};
  std::vector<UrdfJoint> joints = {};
};

/// Reads a URDF file. Throws Error with path and line for XML faults, a root that is no <robot>,
/// names that are missing or taken, numbers that are none, an axis of length 0, links that are not
/// declared, and a link with two parents.
/// Source: the URDF XML specification (wiki.ros.org/urdf/XML).
[[nodiscard]] Urdf ReadUrdf(const std::filesystem::path& path);

/// The joints between two links, the locked ones and the fixed ones folded into their successors'
/// frames. A continuous joint gets the limits ±π. `locked`: value [rad or m] by joint. Throws Error
/// (path) when base or tip is no link, tip does not hang on base, no joint is left, there are more
/// than kMaxJoints, a joint is of another type or mimics one, has no limits or lower ≥ upper, or a
/// locked joint is not between the two links.
[[nodiscard]] SerialChain ChainBetween(const Urdf& urdf,
                                       const std::string& base,
                                       const std::string& tip,
                                       const std::map<std::string, double>& locked = {});

}  // namespace handcraft::robot
