// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "datasets/synthetic/grasp_check.h"
#include "datasets/synthetic/loft.h"

/// Slow and simple second answers, in double precision, to what GraspCheck and its parts find:
/// every triangle is looked at, and cut by a box's planes instead of being told apart from it by an
/// axis.
namespace handcraft::synthetic::testing {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Whether anything of the triangle is left after all outside of the box's six planes is cut off
/// (Sutherland and Hodgman). The box is grown by `margin_m` on each side.
inline bool CutLeavesSomething(const OrientedBox& box, const Corners& triangle, double margin_m) {
  const Eigen::Isometry3d box_from_frame = box.frame_from_box.cast<double>().inverse();
  std::vector<Eigen::Vector3d> polygon;
  for (const Eigen::Vector3d& corner : triangle) polygon.push_back(box_from_frame * corner);
  for (int side = 0; side < 6 && !polygon.empty(); ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1.0 : -1.0;
    const double reach_m = static_cast<double>(box.half_size_m[axis]) + margin_m;
    const auto inside_m = [&](const Eigen::Vector3d& p) { return reach_m - sign * p[axis]; };
    std::vector<Eigen::Vector3d> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector3d& from = polygon[i];
      const Eigen::Vector3d& to = polygon[(i + 1) % polygon.size()];
      if (inside_m(from) >= 0.0) kept.push_back(from);
      if ((inside_m(from) >= 0.0) != (inside_m(to) >= 0.0)) {
        kept.push_back(from + inside_m(from) / (inside_m(from) - inside_m(to)) * (to - from));
      }
    }
    polygon = kept;
  }
  return !polygon.empty();
}

inline Corners CornersOf(const Mesh& mesh, const Face& face) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = mesh.vertices[face.vertices[i]].cast<double>();
  }
  return corners;
}

inline bool TouchesAny(const Mesh& mesh, const OrientedBox& box, double margin_m) {
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
    return CutLeavesSomething(box, CornersOf(mesh, face), margin_m);
  });
}

/// The nearest point of the mesh along a ray: how far, and its outward normal.
struct Met {
  double distance_m = std::numeric_limits<double>::infinity();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

inline Met MeetMesh(const Mesh& mesh,
                    const Eigen::Vector3d& origin,
                    const Eigen::Vector3d& direction) {
  Met met;
  for (const Face& face : mesh.faces) {
    const auto [a, b, c] = CornersOf(mesh, face);
    Eigen::Matrix3d system;
    system << b - a, c - a, -direction;
    if (system.determinant() == 0.0) continue;
    const Eigen::Vector3d at = system.inverse() * (origin - a);
    const bool is_inside = at.x() >= 0.0 && at.y() >= 0.0 && at.x() + at.y() <= 1.0;
    if (!is_inside || at.z() < 0.0 || at.z() >= met.distance_m) continue;
    met = {at.z(), (b - a).cross(c - a).normalized()};
  }
  return met;
}

/// What GraspCheck::Close should find, with every threshold moved by `slack` of its own unit in
/// favour of the pose.
inline GraspFault SlowClose(const Mesh& mesh,
                            const Gripper& gripper,
                            const GraspRules& rules,
                            const Eigen::Isometry3f& object_from_grasp,
                            double slack) {
  const Eigen::Isometry3d pose = object_from_grasp.cast<double>();
  const Eigen::Vector3d closing = pose.linear().col(0);
  const double opened_m = 0.5 * static_cast<double>(gripper.max_opening_m);
  const Met right = MeetMesh(mesh, pose * Eigen::Vector3d(opened_m, 0.0, 0.0), -closing);
  const Met left = MeetMesh(mesh, pose * Eigen::Vector3d(-opened_m, 0.0, 0.0), closing);
  if (closing.dot(right.normal) < 0.0 || closing.dot(left.normal) > 0.0) {
    return GraspFault::kTooWide;
  }
  if (right.distance_m > 2.0 * opened_m || left.distance_m > 2.0 * opened_m) {
    return GraspFault::kNothingHeld;
  }
  const double clearance_m = std::min(left.distance_m, right.distance_m) + slack;
  if (clearance_m < static_cast<double>(gripper.least_clearance_m)) {
    return GraspFault::kTooWide;
  }
  const double off_centre_m = 0.5 * std::abs(left.distance_m - right.distance_m);
  if (off_centre_m > static_cast<double>(rules.off_centre_m) + slack) return GraspFault::kOffCentre;
  const double cone_rad = std::atan(static_cast<double>(rules.friction)) + slack;
  if (std::acos(std::min(closing.dot(right.normal), 1.0)) > cone_rad ||
      std::acos(std::min(-closing.dot(left.normal), 1.0)) > cone_rad) {
    return GraspFault::kSlips;
  }
  const ContactPlaces contacts{static_cast<float>(left.distance_m - opened_m),
                               static_cast<float>(opened_m - right.distance_m)};
  const GripperBoxes boxes = SweptBoxes(gripper, contacts, object_from_grasp);
  for (const OrientedBox& box : boxes) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3f sign(
          corner & 1 ? 1.0F : -1.0F, corner & 2 ? 1.0F : -1.0F, corner & 4 ? 1.0F : -1.0F);
      const Eigen::Vector3f at = box.frame_from_box * sign.cwiseProduct(box.half_size_m);
      if (static_cast<double>(at.z()) < static_cast<double>(rules.table_clearance_m) - slack) {
        return GraspFault::kNearTable;
      }
    }
  }
  const bool touches = std::any_of(boxes.begin(), boxes.end(), [&](const OrientedBox& box) {
    return TouchesAny(mesh, box, -slack);
  });
  return touches ? GraspFault::kTouchesObject : GraspFault::kNone;
}

/// A ball about (0, 0, height_m), flattened a little at its poles.
inline Mesh Ball(float radius_m, float height_m, int num_segments = 24) {
  Profile profile;
  const int num_rings = num_segments / 2;
  for (int i = 0; i < num_rings; ++i) {
    const float angle_rad = std::numbers::pi_v<float> *
                            ((static_cast<float>(i) + 0.5F) / static_cast<float>(num_rings) - 0.5F);
    profile.push_back({radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), {}});
  }
  Mesh ball = Revolve(profile, Ends::kCapped, num_segments);
  Transform(ball, Eigen::Isometry3f(Eigen::Translation3f(0.0F, 0.0F, height_m)));
  return ball;
}

/// A can that stands on the table.
inline Mesh Can(float radius_m, float height_m, int num_segments = 32) {
  return Revolve({{radius_m, 0.0F, {}}, {radius_m, height_m, {}}}, Ends::kCapped, num_segments);
}

/// The pose at a point with these axes, which are made orthogonal and of unit length.
inline Eigen::Isometry3f PoseOf(const Eigen::Vector3f& at_m,
                                const Eigen::Vector3f& closing,
                                const Eigen::Vector3f& approach) {
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity();
  pose.translation() = at_m;
  pose.linear().col(0) = closing.normalized();
  pose.linear().col(1) = approach.cross(closing).normalized();
  pose.linear().col(2) = pose.linear().col(0).cross(pose.linear().col(1));
  return pose;
}

}  // namespace handcraft::synthetic::testing
