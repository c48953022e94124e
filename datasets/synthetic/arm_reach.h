// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/grasp_check.h"

namespace handcraft::synthetic {

/// Where an arm of seven joints can bring its hand, and from where a person would let it.
///
/// Necessary conditions, not inverse kinematics. With the wrist's centre at distance d from the
/// shoulder (the point where the first three axes meet), upper arm a and forearm b:
///  - nearest ≤ d ≤ farthest, which the elbow's limits give;
///  - for some turn of the elbow about the line from shoulder to wrist, the hand leaves the forearm
///    by no more than the wrist bends: |γ − β| ≤ wrist_bend, with γ the angle between that line
///    and the approach axis, cos β = (d² + b² − a²) / 2db;
///  - the approach does not come back towards the robot, nor up from the table.
/// The limits are those of a Barrett WAM (manual D1001): a = |(0.045, 0.55)|, b = |(−0.045, 0.3)|,
/// joint 4 from −0.9 to 3.1 rad, joint 6 ±1.6 rad.
struct ArmReach {
  Eigen::Vector3f shoulder_m = {-0.50F, -0.30F, 0.35F};  ///< in the frame of the poses, z up
  float upper_arm_m = 0.5518F;
  float forearm_m = 0.3034F;
  float nearest_m = 0.272F;
  float farthest_m = 0.855F;
  float wrist_bend_rad = 1.6F;
  float least_forward = -0.25F;  ///< cosine of approach axis and level direction from the shoulder
  float most_upward = 0.17F;     ///< sine of the approach axis above the horizon

  /// The first of kOutOfReach, kFromBehind, kFromBelow that a pose breaks, or kNone.
  [[nodiscard]] GraspFault Check(const Eigen::Isometry3f& frame_from_grasp,
                                 const Gripper& gripper) const;

  /// The same arm in another frame with z upwards.
  [[nodiscard]] ArmReach In(const Eigen::Isometry3f& other_from_frame) const;
};

/// The two arms of the robot that the made-up sets imagine, in the base frame: it stands on the −x
/// side, its shoulders 0.35 m above the table and 0.6 m apart. (The dissertation shows such a torso
/// and gives no measures.)
[[nodiscard]] ArmReach RightArm();
[[nodiscard]] ArmReach LeftArm();

}  // namespace handcraft::synthetic
