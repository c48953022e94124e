// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/robot/pose.h"

namespace handcraft::robot {

/// Joints that a chain may have; solvers keep their scratch on the stack.
inline constexpr std::size_t kMaxJoints = 16;

enum class JointType : std::uint8_t { kRevolute, kPrismatic };

struct Joint {
  std::string name;
  JointType type = JointType::kRevolute;
  Pose parent_from_joint;    ///< at joint value 0
  Vector3 axis = {0, 0, 1};  ///< unit vector, in the joint's frame
  double lower = 0.0;        ///< [rad] or [m]
  double upper = 0.0;        ///< [rad] or [m]

  [[nodiscard]] double Middle() const noexcept { return 0.5 * (lower + upper); }
};

/// The joints that move a tip against a base, in order; fixed and locked ones are folded in.
struct SerialChain {
  std::string base;
  std::string tip;
  std::vector<Joint> joints = {};
  Pose last_from_tip = {};

  [[nodiscard]] std::size_t size() const noexcept { return joints.size(); }
  /// Names of the joints, separated by ", ".
  [[nodiscard]] std::string JointNames() const;
  /// The middle of each joint's limits.
  [[nodiscard]] std::vector<double> Middle() const;
  /// Whether each value lies within its joint's limits, up to a tolerance.
  [[nodiscard]] bool IsWithinLimits(std::span<const double> joints_in,
                                    double tolerance) const noexcept;
  /// Throws Error(kUsage), naming the joint, for values that are not as many as the joints, not
  /// finite, or outside the limits by more than 1e-9.
  void RequireWithinLimits(std::span<const double> joints_in) const;
};

/// The axis of a joint as it stands, in the base frame.
struct JointLine {
  Vector3 axis;
  Vector3 point_m;
};

/// Forward kinematics: base_from_tip = Π (parent_from_joint · motion(q_i)) · last_from_tip. As many
/// values as joints [rad or m]; their limits are not looked at. Allocates nothing; thread-safe.
[[nodiscard]] Pose ForwardKinematics(const SerialChain& chain,
                                     std::span<const double> joints) noexcept;

/// The same; also says where each joint's axis stands. lines.size() ≥ chain.size().
Pose ForwardKinematics(const SerialChain& chain,
                       std::span<const double> joints,
                       std::span<JointLine> lines) noexcept;

}  // namespace handcraft::robot
