// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/spherical_arm.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace handcraft::robot {
namespace {

constexpr double kMeet_m = 1e-9;
constexpr double kLeastSine = 0.05;

// How far a point is from a line.
double Distance(const Vector3& point_m, const JointLine& line) {
  return Norm(Cross(line.axis, Subtract(point_m, line.point_m)));
}

// The point of the first line that is nearest to the second, which is not parallel to it.
Vector3 NearestPoint(const JointLine& first, const JointLine& second) {
  const Vector3 normal = Cross(first.axis, second.axis);
  const Vector3 between = Subtract(second.point_m, first.point_m);
  const double along = Dot(Cross(between, second.axis), normal) / Dot(normal, normal);
  return Add(first.point_m, Scale(first.axis, along));
}

// The joint of three axes; `part` and the numbers of the joints are for the reason.
std::optional<SphericalJoint> FindSphericalJoint(std::span<const JointLine, 3> lines,
                                                 const std::string& part,
                                                 std::string& reason) {
  const Vector3 normal_12 = Cross(lines[0].axis, lines[1].axis);
  const Vector3 normal_23 = Cross(lines[1].axis, lines[2].axis);
  if (Norm(normal_12) < kLeastSine || Norm(normal_23) < kLeastSine) {
    reason = "neighbouring axes of the " + part + " are parallel";
    return std::nullopt;
  }
  SphericalJoint joint;
  joint.centre_m = NearestPoint(lines[1], lines[0]);
  if (Distance(joint.centre_m, lines[0]) > kMeet_m ||
      Distance(joint.centre_m, lines[2]) > kMeet_m) {
    reason = "the axes of the " + part + " do not meet in one point";
    return std::nullopt;
  }
  const Vector3 x_12 = Scale(normal_12, 1.0 / Norm(normal_12));
  const Vector3 x_23 = Scale(normal_23, 1.0 / Norm(normal_23));
  joint.first_frame = FromColumns(x_12, Cross(lines[0].axis, x_12), lines[0].axis);
  joint.third_frame = FromColumns(x_23, Cross(lines[2].axis, x_23), lines[2].axis);
  joint.cos_12 = Dot(lines[0].axis, lines[1].axis);
  joint.sin_12 = Norm(normal_12);
  joint.cos_23 = Dot(lines[1].axis, lines[2].axis);
  joint.sin_23 = Norm(normal_23);
  joint.offset_rad = std::atan2(Dot(lines[1].axis, Cross(x_12, x_23)), Dot(x_12, x_23));
  return joint;
}

}  // namespace

SphericalArmSearch FindSphericalArm(const SerialChain& chain) {
  if (chain.size() != 7) {
    return {std::nullopt, "the arm has " + std::to_string(chain.size()) + " joints, not 7"};
  }
  if (std::any_of(chain.joints.begin(), chain.joints.end(), [](const Joint& joint) {
        return joint.type != JointType::kRevolute;
      })) {
    return {std::nullopt, "not every joint turns"};
  }
  std::array<JointLine, 7> lines;
  SphericalArm arm;
  arm.base_from_tip = ForwardKinematics(chain, std::vector<double>(7, 0.0), lines);
  std::string reason;
  const std::span<const JointLine, 7> all(lines);
  const auto shoulder = FindSphericalJoint(all.first<3>(), "shoulder", reason);
  if (!shoulder) return {std::nullopt, reason};
  const auto wrist = FindSphericalJoint(all.last<3>(), "wrist", reason);
  if (!wrist) return {std::nullopt, reason};
  arm.shoulder = *shoulder;
  arm.wrist = *wrist;
  arm.elbow = lines[3];
  // With a = elbow − shoulder, b = wrist − elbow: |a + R(q₄) b|² = |a|² + |b|² + 2 a · R(q₄) b.
  const Vector3 a = Subtract(arm.elbow.point_m, arm.shoulder.centre_m);
  const Vector3 b = Subtract(arm.wrist.centre_m, arm.elbow.point_m);
  const Vector3 along = Scale(arm.elbow.axis, Dot(arm.elbow.axis, b));
  arm.reach_constant = Dot(a, a) + Dot(b, b) + 2.0 * Dot(a, along);
  arm.reach_cosine = 2.0 * Dot(a, Subtract(b, along));
  arm.reach_sine = 2.0 * Dot(a, Cross(arm.elbow.axis, b));
  if (std::hypot(arm.reach_cosine, arm.reach_sine) < 1e-6) {
    return {std::nullopt, "the elbow does not change the distance from shoulder to wrist"};
  }
  return {arm, {}};
}

}  // namespace handcraft::robot
