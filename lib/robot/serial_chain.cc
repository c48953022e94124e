// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/serial_chain.h"

#include <cmath>

#include "lib/core/error.h"
#include "lib/core/fields.h"

namespace handcraft::robot {
namespace {

Pose Motion(const Joint& joint, double value) noexcept {
  if (joint.type == JointType::kPrismatic) return {kIdentity3, Scale(joint.axis, value)};
  return {AxisRotation(joint.axis, value), {}};
}

}  // namespace

std::string SerialChain::JointNames() const {
  std::string names;
  for (const Joint& joint : joints) {
    if (!names.empty()) names += ", ";
    names += joint.name;
  }
  return names;
}

std::vector<double> SerialChain::Middle() const {
  std::vector<double> middle;
  middle.reserve(joints.size());
  for (const Joint& joint : joints) middle.push_back(joint.Middle());
  return middle;
}

bool SerialChain::IsWithinLimits(std::span<const double> joints_in,
                                 double tolerance) const noexcept {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const bool is_within =
        joints_in[j] >= joints[j].lower - tolerance && joints_in[j] <= joints[j].upper + tolerance;
    if (!is_within) return false;
  }
  return true;
}

void SerialChain::RequireWithinLimits(std::span<const double> joints_in) const {
  constexpr double kTolerance = 1e-9;
  if (joints_in.size() != joints.size()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = NumberToText(joints_in.size()) + " joint values given; the arm has " +
                           NumberToText(joints.size()) + ": " + JointNames()});
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joints_in[j] >= joint.lower - kTolerance && joints_in[j] <= joint.upper + kTolerance) {
      continue;
    }
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "joint " + joint.name + " is " + NumberToText(joints_in[j]) +
                           "; its limits are " + NumberToText(joint.lower) + " and " +
                           NumberToText(joint.upper)});
  }
}

Pose ForwardKinematics(const SerialChain& chain, std::span<const double> joints) noexcept {
  Pose base_from_joint;
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[j];
    base_from_joint = base_from_joint * joint.parent_from_joint * Motion(joint, joints[j]);
  }
  return base_from_joint * chain.last_from_tip;
}

Pose ForwardKinematics(const SerialChain& chain,
                       std::span<const double> joints,
                       std::span<JointLine> lines) noexcept {
  Pose base_from_joint;
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[j];
    base_from_joint = base_from_joint * joint.parent_from_joint;
    lines[j] = {Multiply(base_from_joint.rotation, joint.axis), base_from_joint.translation_m};
    base_from_joint = base_from_joint * Motion(joint, joints[j]);
  }
  return base_from_joint * chain.last_from_tip;
}

}  // namespace handcraft::robot
