// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/features/object_rotation.h"
#include "lib/features/position_tree.h"
#include "lib/features/rotation_mean.h"

namespace handcraft::features {

/// What was shown of one class of objects, in somebody else's memory: its views (layer 2), and the
/// poses that were shown at some angles (layer 3).
struct ShownClass {
  KnownViews views;
  std::span<const double> view_angles_rad;   ///< of the object about z, in each view
  std::span<const double> shown_angles_rad;  ///< where poses were shown, ≥ 1
  /// num_angles + 1 numbers: the poses of angle i are rows begins[i] … begins[i + 1] − 1 below, not
  /// none, and a tree of their own.
  std::span<const std::int32_t> begins;
  std::span<const double> positions_m;    ///< num_poses × 3: of the hand, from the view's p_m
  std::span<const double> rotations;      ///< num_poses × 4: quaternions of the hand
  std::span<const std::int32_t> numbers;  ///< num_poses: which demonstration each is
};

inline constexpr std::size_t kMaxGraspNeighbours = 32;

struct GraspRequest {
  Vector3 point_m = {};            ///< p_g in the base frame
  std::size_t num_neighbours = 1;  ///< 1 to kMaxGraspNeighbours
};

struct FoundGrasp {
  std::size_t view = 0;           ///< of the class: the one most like the object's
  double object_angle_rad = 0.0;  ///< α_g, that view's angle
  double turn_rad = 0.0;          ///< α_t, in [−π, π]: from α_g to where poses were shown
  Vector3 position_m = {};        ///< of the hand that was shown, brought to the object
  Quaternion rotation = {};       ///< R_g
  double distance_m = 0.0;        ///< from p_p to the nearest position
  std::int32_t number = 0;        ///< which demonstration that is
};

/// Layers 2 and 3: how to hold an object of this class. α_g is the angle of the nearest view;
/// α_t the smallest turn to an angle at which poses were shown (of equal ones the first);
///   p_p = Rz(α_t)(p_g − p_m)            Eq. 4.6, about the object's own mean point,
/// the nearest positions to p_p among the poses shown there, and
///   R_g = Rz(−α_t) R_E                  Eq. 4.7.
/// Positions on both sides are taken from p_m, so that the object may stand anywhere. Of several
/// neighbours R_E is the mean rotation (MeanRotation) and the position the mean position, weighted
/// by 1 / (distance + 1 mm). Does not allocate; thread-safe.
/// Source: dissertation sections 4.2.3 and 4.2.4; docs/methods/grasp_library.md.
[[nodiscard]] FoundGrasp FindGrasp(const ShownClass& shown,
                                   const RotationRule& rule,
                                   const ViewDescription& view,
                                   const GraspRequest& request) noexcept;

/// As FindGrasp when the object's angle is known.
[[nodiscard]] FoundGrasp FindGraspAt(const ShownClass& shown,
                                     double object_angle_rad,
                                     const Vector3& mean_m,
                                     const GraspRequest& request) noexcept;

/// The most grasps that are ranked.
inline constexpr std::size_t kMaxRankedGrasps = 64;

/// As FindGraspAt for the nearest position, the next nearest and so on, for an arm that does not
/// reach the first: grasp i passes over the i nearest ones and means the request's neighbours from
/// there, as many as are left. Returns how many there are: at most kMaxRankedGrasps and what
/// `grasps` holds, which is one or more. Grasp 0 is that of FindGraspAt. Does not allocate;
/// thread-safe.
std::size_t RankGraspsAt(const ShownClass& shown,
                         double object_angle_rad,
                         const Vector3& mean_m,
                         const GraspRequest& request,
                         std::span<FoundGrasp> grasps) noexcept;

/// The smallest turn from one angle to another, in [−π, π] [rad].
[[nodiscard]] double TurnBetween(double from_rad, double to_rad) noexcept;

/// Rz(angle) p.
[[nodiscard]] Vector3 TurnedAboutZ(const Vector3& p, double angle_rad) noexcept;

}  // namespace handcraft::features
