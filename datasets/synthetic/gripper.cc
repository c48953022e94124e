// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/gripper.h"

#include <algorithm>
#include <string>

#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

using Eigen::AlignedBox3f;
using Eigen::Vector3f;

// A finger's two boxes, on the side of +x.
struct Finger {
  AlignedBox3f last_link;
  AlignedBox3f root;
};

// Where a finger is: its contact, from the centre (beyond it the number is negative), and how far
// out its outside comes.
struct FingerPlace {
  float contact_m = 0.0F;
  float outside_m = 0.0F;
};

float LastInsideM(const Gripper& gripper, float contact_m) {
  return contact_m + gripper.pad_slack_m;
}

float RootInsideM(const Gripper& gripper, float contact_m) {
  return std::max(contact_m + gripper.stand_off_m, gripper.knuckle_m);
}

// All between the contact and the full opening.
FingerPlace Swept(const Gripper& gripper, float contact_m) {
  return {contact_m, 0.5F * gripper.max_opening_m + gripper.finger_thickness_m};
}

// The finger alone where it has come to rest, and what its root stands off.
FingerPlace Closed(const Gripper& gripper, float contact_m) {
  const float inside_m = std::max(LastInsideM(gripper, contact_m), RootInsideM(gripper, contact_m));
  return {contact_m, inside_m + gripper.finger_thickness_m};
}

Finger MakeFinger(const Gripper& gripper, const FingerPlace& place, float y_m) {
  const float half_width_m = 0.5F * gripper.finger_width_m;
  const float joint_m = gripper.tip_m - gripper.last_link_m;
  const float last_inside_m = LastInsideM(gripper, place.contact_m);
  const float root_inside_m = RootInsideM(gripper, place.contact_m);
  return {.last_link = {Vector3f(last_inside_m, y_m - half_width_m, joint_m),
                        Vector3f(place.outside_m, y_m + half_width_m, gripper.tip_m)},
          .root = {Vector3f(root_inside_m, y_m - half_width_m, -gripper.finger_reach_m),
                   Vector3f(place.outside_m, y_m + half_width_m, joint_m)}};
}

AlignedBox3f Mirrored(const AlignedBox3f& box) {
  const Vector3f turn(-1.0F, 1.0F, 1.0F);
  AlignedBox3f mirrored;
  mirrored.extend(Vector3f(turn.cwiseProduct(box.min())));
  mirrored.extend(Vector3f(turn.cwiseProduct(box.max())));
  return mirrored;
}

// A box of this size about the z axis whose upper face is at `top_m`.
AlignedBox3f Below(float top_m, const Vector3f& size_m) {
  return {Vector3f(-0.5F * size_m.x(), -0.5F * size_m.y(), top_m - size_m.z()),
          Vector3f(0.5F * size_m.x(), 0.5F * size_m.y(), top_m)};
}

template <class PlaceOf>
GripperBoxes MakeBoxes(const Gripper& gripper,
                       const ContactPlaces& contacts,
                       const Eigen::Isometry3f& frame_from_grasp,
                       const PlaceOf& place_of) {
  const FingerPlace fingers = place_of(gripper, contacts.fingers_m);
  const Finger thumb = MakeFinger(gripper, place_of(gripper, -contacts.thumb_m), 0.0F);
  const Finger left = MakeFinger(gripper, fingers, gripper.finger_apart_m);
  const Finger right = MakeFinger(gripper, fingers, -gripper.finger_apart_m);
  const float palm_m = -gripper.finger_reach_m;
  const std::array<AlignedBox3f, kNumGripperBoxes> boxes = {
      left.last_link,
      right.last_link,
      Mirrored(thumb.last_link),
      left.root,
      right.root,
      Mirrored(thumb.root),
      Below(palm_m, gripper.palm_m),
      Below(palm_m - gripper.palm_m.z(), gripper.wrist_m)};
  GripperBoxes moved;
  std::transform(boxes.begin(), boxes.end(), moved.begin(), [&](const AlignedBox3f& box) {
    return MovedBox(box, frame_from_grasp);
  });
  return moved;
}

void RequirePositive(float value, const std::string& field) {
  RequireOption(value > 0.0F && value <= 1.0F, "Gripper." + field, value, "in (0, 1]");
}

}  // namespace

void Gripper::Validate() const {
  RequirePositive(finger_reach_m, "finger_reach_m");
  RequirePositive(last_link_m, "last_link_m");
  RequirePositive(finger_width_m, "finger_width_m");
  RequirePositive(finger_thickness_m, "finger_thickness_m");
  RequirePositive(knuckle_m, "knuckle_m");
  RequirePositive(palm_m.minCoeff(), "palm_m");
  RequirePositive(wrist_m.minCoeff(), "wrist_m");
  RequireOption(least_clearance_m >= 0.0F && max_opening_m > 2.0F * least_clearance_m,
                "Gripper.max_opening_m",
                max_opening_m,
                "more than twice least_clearance_m");
  // The boxes of a finger must hang together with each other and the palm.
  RequireOption(pad_slack_m >= 0.0F && pad_slack_m <= least_clearance_m + finger_thickness_m,
                "Gripper.pad_slack_m",
                pad_slack_m,
                "from 0 to least_clearance_m + finger_thickness_m");
  RequireOption(
      0.5F * WidestM() + stand_off_m <= 0.5F * palm_m.x() && knuckle_m <= 0.5F * palm_m.x(),
      "Gripper.stand_off_m",
      stand_off_m,
      "so small that a finger's root stands on the palm");
  RequireOption(knuckle_m <= 0.5F * max_opening_m,
                "Gripper.knuckle_m",
                knuckle_m,
                "at most half of max_opening_m");
  RequireOption(tip_m >= 0.0F && last_link_m - tip_m < finger_reach_m,
                "Gripper.tip_m",
                tip_m,
                "such that the last link ends in front of the palm");
}

GripperBoxes SweptBoxes(const Gripper& gripper,
                        const ContactPlaces& contacts,
                        const Eigen::Isometry3f& frame_from_grasp) {
  return MakeBoxes(gripper, contacts, frame_from_grasp, Swept);
}

GripperBoxes ClosedBoxes(const Gripper& gripper,
                         const ContactPlaces& contacts,
                         const Eigen::Isometry3f& frame_from_grasp) {
  return MakeBoxes(gripper, contacts, frame_from_grasp, Closed);
}

bool Collide(const GripperBoxes& a, const GripperBoxes& b) {
  return std::any_of(a.begin(), a.end(), [&](const OrientedBox& box) {
    return std::any_of(
        b.begin(), b.end(), [&](const OrientedBox& other) { return Overlap(box, other); });
  });
}

}  // namespace handcraft::synthetic
