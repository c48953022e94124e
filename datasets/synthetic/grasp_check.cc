// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_check.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "lib/core/check.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

constexpr float kFarM = 100.0F;
constexpr std::array<std::string_view, kNumGraspFaults> kNames = {"valid",
                                                                  "nothing held",
                                                                  "too wide",
                                                                  "off centre",
                                                                  "slips",
                                                                  "near the table",
                                                                  "touches the object",
                                                                  "out of reach",
                                                                  "from behind",
                                                                  "from below"};

const Gripper& Validated(const Gripper& gripper) {
  gripper.Validate();
  return gripper;
}

const GraspRules& Validated(const GraspRules& rules) {
  rules.Validate();
  return rules;
}

}  // namespace

std::string_view NameOf(GraspFault fault) {
  const auto index = static_cast<std::size_t>(fault);
  HC_CHECK(index < kNames.size(), index);
  return kNames[index];
}

void GraspRules::Validate() const {
  RequireOption(friction > 0.0F && friction <= 2.0F, "GraspRules.friction", friction, "in (0, 2]");
  RequireOption(off_centre_m >= 0.0F && off_centre_m <= 0.1F,
                "GraspRules.off_centre_m",
                off_centre_m,
                "from 0 to 0.1");
  RequireOption(table_clearance_m >= 0.0F && table_clearance_m <= 0.1F,
                "GraspRules.table_clearance_m",
                table_clearance_m,
                "from 0 to 0.1");
}

GraspCheck::GraspCheck(const Mesh& object, const Gripper& gripper, const GraspRules& rules)
    : object_(object),
      gripper_(Validated(gripper)),
      rules_(Validated(rules)),
      tracer_(std::span(&object_, 1)),
      tree_(object_) {}

Vector3f GraspCheck::NormalOf(std::uint32_t face) const {
  const auto& corners = object_.faces[face].vertices;
  const Vector3f& a = object_.vertices[corners[0]];
  return (object_.vertices[corners[1]] - a).cross(object_.vertices[corners[2]] - a).normalized();
}

bool GraspCheck::IsInFrictionCone(const Vector3f& direction, const Vector3f& normal) const {
  const float inwards = -direction.dot(normal);
  return inwards > 0.0F && direction.cross(normal).norm() <= rules_.friction * inwards;
}

std::optional<ClosingLine> GraspCheck::MeetSurface(const Isometry3f& object_from_grasp) const {
  const Vector3f closing = object_from_grasp.linear().col(0);
  const Vector3f centre = object_from_grasp.translation();
  const float opened_m = 0.5F * gripper_.max_opening_m;
  RayPacket rays;
  rays.Add(centre + opened_m * closing, -closing, kFarM);
  rays.Add(centre - opened_m * closing, closing, kFarM);
  const std::array<Hit, 4> hits = tracer_.Intersect(rays);
  if (hits[0].mesh == Hit::kNothing || hits[1].mesh == Hit::kNothing) return std::nullopt;
  ClosingLine line{.contacts = {.thumb_m = hits[1].distance - opened_m,
                                .fingers_m = opened_m - hits[0].distance},
                   .fingers_normal = NormalOf(hits[0].face),
                   .thumb_normal = NormalOf(hits[1].face)};
  // A ray that meets a back face began inside the object.
  line.begins_inside =
      closing.dot(line.fingers_normal) < 0.0F || closing.dot(line.thumb_normal) > 0.0F;
  const bool is_beyond = std::max(hits[0].distance, hits[1].distance) > gripper_.max_opening_m;
  if (is_beyond && !line.begins_inside) return std::nullopt;
  return line;
}

bool GraspCheck::IsHeld(const ClosingLine& line, const Isometry3f& object_from_grasp) const {
  const Vector3f closing = object_from_grasp.linear().col(0);
  return IsInFrictionCone(-closing, line.fingers_normal) &&
         IsInFrictionCone(closing, line.thumb_normal);
}

GraspOutcome GraspCheck::FindContacts(const Isometry3f& object_from_grasp) const {
  const std::optional<ClosingLine> line = MeetSurface(object_from_grasp);
  if (!line) return {GraspFault::kNothingHeld, {}};
  const ContactPlaces& contacts = line->contacts;
  const float opened_m = 0.5F * gripper_.max_opening_m;
  const float clearance_m = opened_m - std::max(contacts.fingers_m, -contacts.thumb_m);
  if (line->begins_inside || clearance_m < gripper_.least_clearance_m) {
    return {GraspFault::kTooWide, contacts};
  }
  if (std::abs(contacts.thumb_m + contacts.fingers_m) > 2.0F * rules_.off_centre_m) {
    return {GraspFault::kOffCentre, contacts};
  }
  return {IsHeld(*line, object_from_grasp) ? GraspFault::kNone : GraspFault::kSlips, contacts};
}

GraspFault GraspCheck::CheckTable(const GripperBoxes& boxes) const {
  const auto is_low = [&](const OrientedBox& box) {
    return Around(box).min().z() < rules_.table_clearance_m;
  };
  return std::any_of(boxes.begin(), boxes.end(), is_low) ? GraspFault::kNearTable
                                                         : GraspFault::kNone;
}

GraspFault GraspCheck::CheckObject(const GripperBoxes& boxes) const {
  const auto touches = [&](const OrientedBox& box) { return tree_.Touches(box); };
  return std::any_of(boxes.begin(), boxes.end(), touches) ? GraspFault::kTouchesObject
                                                          : GraspFault::kNone;
}

GraspOutcome GraspCheck::Close(const Isometry3f& object_from_grasp) const {
  GraspOutcome outcome = FindContacts(object_from_grasp);
  if (outcome.fault != GraspFault::kNone) return outcome;
  const GripperBoxes boxes = SweptBoxes(gripper_, outcome.contacts, object_from_grasp);
  outcome.fault = CheckTable(boxes);
  if (outcome.fault == GraspFault::kNone) outcome.fault = CheckObject(boxes);
  return outcome;
}

}  // namespace handcraft::synthetic
