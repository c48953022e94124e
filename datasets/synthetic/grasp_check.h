// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "datasets/synthetic/gripper.h"
#include "datasets/synthetic/mesh.h"
#include "datasets/synthetic/ray_tracer.h"
#include "datasets/synthetic/triangle_tree.h"

namespace handcraft::synthetic {

/// The first rule that a pose of the hand breaks, in the order in which they are looked at.
enum class GraspFault {
  kNone,
  kNothingHeld,    ///< the fingers would close on nothing
  kTooWide,        ///< what is between them is wider than the hand opens
  kOffCentre,      ///< it lies too far to one side
  kSlips,          ///< a contact's force would leave its friction cone
  kNearTable,      ///< a part of the hand is nearer to the table than the clearance
  kTouchesObject,  ///< palm, wrist or a finger on its way meets the object
  kOutOfReach,     ///< the arm cannot bring the hand there
  kFromBehind,     ///< the hand would come back towards the robot
  kFromBelow,      ///< the hand would come up from the table
};
inline constexpr std::size_t kNumGraspFaults = 10;

/// "too wide" and the like.
[[nodiscard]] std::string_view NameOf(GraspFault fault);

struct GraspRules {
  float friction = 0.5F;            ///< coefficient at the contacts: rubber on plastic or more
  float off_centre_m = 0.01F;       ///< greatest distance of the contacts' middle from the centre
  float table_clearance_m = 0.01F;  ///< below every part of the hand

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Where the closing axis meets the surface, from the opened fingers and from the opened thumb.
struct ClosingLine {
  ContactPlaces contacts;
  Eigen::Vector3f fingers_normal = Eigen::Vector3f::Zero();  ///< unit, outwards
  Eigen::Vector3f thumb_normal = Eigen::Vector3f::Zero();
  /// Fingers or thumb would be within the object before they close; the contacts are then of no
  /// use.
  bool begins_inside = false;
};

/// What comes of closing the hand at a pose.
struct GraspOutcome {
  GraspFault fault = GraspFault::kNone;
  ContactPlaces contacts;  ///< set when something is held
};

/// Tells whether the hand, brought to a pose and closed, holds an object that stands on the table
/// z = 0 of its own frame.
///
/// The contacts are the first points of the surface met on the closing axis from either side. The
/// grasp holds when the line between them lies within both friction cones, angle(axis, normal) ≤
/// arctan(friction): two soft contacts then resist any small force and torque (Nguyen,
/// "Constructing force-closure grasps", 1988, theorem 5). The two fingers count as one here. Table
/// and object are kept from all that Gripper's SweptBoxes pass through. May be used by one thread
/// at a time.
class GraspCheck {
 public:
  /// The mesh, closed and outwards, is copied. Throws Error for options that break their rules.
  GraspCheck(const Mesh& object, const Gripper& gripper, const GraspRules& rules);

  /// All rules but those of reach.
  [[nodiscard]] GraspOutcome Close(const Eigen::Isometry3f& object_from_grasp) const;

  [[nodiscard]] const Mesh& object() const noexcept { return object_; }
  [[nodiscard]] const Gripper& gripper() const noexcept { return gripper_; }
  [[nodiscard]] const GraspRules& rules() const noexcept { return rules_; }
  [[nodiscard]] const RayTracer& tracer() const noexcept { return tracer_; }

  /// None when nothing is on the closing axis between fingers and thumb.
  [[nodiscard]] std::optional<ClosingLine> MeetSurface(
      const Eigen::Isometry3f& object_from_grasp) const;

  /// Whether both contacts hold what is between them: friction.
  [[nodiscard]] bool IsHeld(const ClosingLine& line,
                            const Eigen::Isometry3f& object_from_grasp) const;

  /// kNearTable when a box is nearer to the table than the clearance.
  [[nodiscard]] GraspFault CheckTable(const GripperBoxes& boxes) const;

  /// kTouchesObject when a box touches the object's surface.
  [[nodiscard]] GraspFault CheckObject(const GripperBoxes& boxes) const;

  /// Unit normal of a face, outwards.
  [[nodiscard]] Eigen::Vector3f NormalOf(std::uint32_t face) const;

  /// Whether a unit force along `direction` (into the surface) stays within the friction cone of a
  /// contact with this outward unit normal.
  [[nodiscard]] bool IsInFrictionCone(const Eigen::Vector3f& direction,
                                      const Eigen::Vector3f& normal) const;

 private:
  [[nodiscard]] GraspOutcome FindContacts(const Eigen::Isometry3f& object_from_grasp) const;

  Mesh object_;
  Gripper gripper_;
  GraspRules rules_;
  RayTracer tracer_;
  TriangleTree tree_;
};

}  // namespace handcraft::synthetic
