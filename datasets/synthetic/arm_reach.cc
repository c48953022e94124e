// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/arm_reach.h"

#include <algorithm>
#include <cmath>

namespace handcraft::synthetic {

using Eigen::Isometry3f;
using Eigen::Vector3f;

GraspFault ArmReach::Check(const Isometry3f& frame_from_grasp, const Gripper& gripper) const {
  const Vector3f approach = frame_from_grasp.linear().col(2);
  const Vector3f wrist_m = frame_from_grasp.translation() - gripper.WristToGraspM() * approach;
  const Vector3f to_wrist = wrist_m - shoulder_m;
  const float distance_m = to_wrist.norm();
  if (!(distance_m >= nearest_m && distance_m <= farthest_m)) return GraspFault::kOutOfReach;
  const auto angle = [](float cosine) { return std::acos(std::clamp(cosine, -1.0F, 1.0F)); };
  const float forearm_rad =
      angle((distance_m * distance_m + forearm_m * forearm_m - upper_arm_m * upper_arm_m) /
            (2.0F * distance_m * forearm_m));
  const float hand_rad = angle(approach.dot(to_wrist) / distance_m);
  if (std::abs(hand_rad - forearm_rad) > wrist_bend_rad) return GraspFault::kOutOfReach;
  const Vector3f to_grasp = frame_from_grasp.translation() - shoulder_m;
  if (approach.head<2>().dot(to_grasp.head<2>().normalized()) < least_forward) {
    return GraspFault::kFromBehind;
  }
  return approach.z() > most_upward ? GraspFault::kFromBelow : GraspFault::kNone;
}

ArmReach ArmReach::In(const Isometry3f& other_from_frame) const {
  ArmReach moved = *this;
  moved.shoulder_m = other_from_frame * shoulder_m;
  return moved;
}

ArmReach RightArm() { return {}; }

ArmReach LeftArm() {
  ArmReach arm = RightArm();
  arm.shoulder_m.y() *= -1.0F;
  return arm;
}

}  // namespace handcraft::synthetic
