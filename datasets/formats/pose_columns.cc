// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/pose_columns.h"

#include <cmath>

#include "lib/core/fields.h"

namespace handcraft::datasets {
namespace {

std::array<double, kPoseColumns.size()> NumbersOf(const EndEffectorPose& pose) {
  const Eigen::Vector3d& p = pose.position_m;
  const Eigen::Quaterniond& q = pose.rotation;
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

// Never −0, which would be written "-0".
double RoundToMillionths(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

void CheckName(const CsvRows& rows,
               std::size_t first,
               std::size_t which,
               std::string_view due,
               std::string_view remedy) {
  const std::string_view found = rows.Text(first + which);
  if (found == due) return;
  rows.Fail(std::string(kFrameColumns[which]) + " '" + std::string(found) + "'; '" +
                std::string(due) + "' is due",
            std::string(remedy));
}

}  // namespace

Eigen::Isometry3d EndEffectorPose::ToIsometry() const {
  return Eigen::Translation3d(position_m) * rotation.normalized();
}

EndEffectorPose EndEffectorPose::Rounded(const Eigen::Isometry3d& frame_from_end_effector) {
  EndEffectorPose pose;
  pose.position_m = frame_from_end_effector.translation().unaryExpr(&RoundToMillionths);
  Eigen::Quaterniond rotation(frame_from_end_effector.linear());
  if (rotation.w() < 0.0) rotation.coeffs() *= -1.0;
  pose.rotation.coeffs() = rotation.coeffs().unaryExpr(&RoundToMillionths);
  return pose;
}

EndEffectorPose ReadPose(const CsvRows& rows, std::size_t first) {
  EndEffectorPose pose;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double coordinate_m = rows.Number(first + axis);
    if (std::abs(coordinate_m) > kFarthestM) {
      rows.Fail("column '" + std::string(rows.Name(first + axis)) +
                    "': " + NumberToText(coordinate_m) + " m is out of a robot's reach",
                "give metres");
    }
    pose.position_m[static_cast<Eigen::Index>(axis)] = coordinate_m;
  }
  for (std::size_t part = 0; part < 4; ++part) {
    pose.rotation.coeffs()[static_cast<Eigen::Index>(part)] = rows.Number(first + 3 + part);
  }
  const double length = pose.rotation.norm();
  if (!(std::abs(length - 1.0) <= kUnitTolerance)) {
    rows.Fail("the quaternion has length " + NumberToText(length) + "; 1 is due",
              "its parts are qx, qy, qz, qw, the real one last");
  }
  return pose;
}

void CheckFrames(const CsvRows& rows, std::size_t first) {
  CheckName(rows, first, 0, kBaseFrame, "bring the poses into the frame of the views' clouds");
  CheckName(rows,
            first,
            1,
            kGraspCentre,
            "give the point between the fingertips, z the approach axis, x the closing axis");
}

std::string FrameFields() { return std::string(kBaseFrame) + "," + std::string(kGraspCentre); }

std::string PoseFields(const EndEffectorPose& pose) {
  std::string text;
  for (const double number : NumbersOf(pose))
    text += (text.empty() ? "" : ",") + NumberToText(number);
  return text;
}

}  // namespace handcraft::datasets
