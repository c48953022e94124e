// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_trial.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;

// The first fault of several, in their order.
template <class... Checks>
GraspFault FirstOf(const Checks&... checks) {
  GraspFault fault = GraspFault::kNone;
  static_cast<void>(((fault = checks(), fault == GraspFault::kNone) && ...));
  return fault;
}

// How far the object is pushed along the closing axis, from the hand.
float PushM(const ContactPlaces& contacts, const GraspRules& rules) {
  const float middle_m = 0.5F * (contacts.thumb_m + contacts.fingers_m);
  return middle_m - std::clamp(middle_m, -rules.off_centre_m, rules.off_centre_m);
}

GraspFault CheckOpenHand(const GraspCheck& check, const Isometry3f& pose) {
  const float opened_m = 0.5F * check.gripper().max_opening_m;
  const GripperBoxes boxes = SweptBoxes(check.gripper(), {-opened_m, opened_m}, pose);
  return FirstOf([&] { return check.CheckTable(boxes); }, [&] { return check.CheckObject(boxes); });
}

// The object is pushed against the hand: in its frame the hand moves the other way.
GraspFault CheckWay(const GraspCheck& check,
                    const Isometry3f& pose,
                    const ContactPlaces& contacts,
                    float push_m) {
  Isometry3f last = pose;
  last.translation() += push_m * pose.linear().col(0);
  return FirstOf([&] { return check.CheckTable(SweptBoxes(check.gripper(), contacts, pose)); },
                 [&] { return check.CheckObject(SweptBoxes(check.gripper(), contacts, last)); });
}

}  // namespace

GraspRules TrialRules() { return {.table_clearance_m = 0.0F}; }

GraspOutcome TryGrasp(const GraspCheck& check, const Isometry3f& object_from_grasp) {
  const GraspFault arrival = CheckOpenHand(check, object_from_grasp);
  if (arrival != GraspFault::kNone) return {arrival, {}};
  const std::optional<ClosingLine> line = check.MeetSurface(object_from_grasp);
  if (!line) return {GraspFault::kNothingHeld, {}};
  GraspOutcome outcome{GraspFault::kNone, line->contacts};
  if (line->begins_inside || outcome.contacts.WidthM() > check.gripper().WidestM()) {
    outcome.fault = GraspFault::kTooWide;
    return outcome;
  }
  const float push_m = PushM(outcome.contacts, check.rules());
  const float raised_m = std::abs(0.5F * (outcome.contacts.thumb_m + outcome.contacts.fingers_m) *
                                  object_from_grasp.linear().col(0).z());
  outcome.contacts.thumb_m -= push_m;
  outcome.contacts.fingers_m -= push_m;
  if (raised_m > check.rules().off_centre_m) {
    outcome.fault = GraspFault::kOffCentre;
  } else if (!check.IsHeld(*line, object_from_grasp)) {
    outcome.fault = GraspFault::kSlips;
  } else {
    outcome.fault = CheckWay(check, object_from_grasp, outcome.contacts, push_m);
  }
  return outcome;
}

}  // namespace handcraft::synthetic
