// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/grasp_check.h"

namespace handcraft::synthetic {

/// The rules of a trial: those that demonstrations keep to, without their margin above the table.
[[nodiscard]] GraspRules TrialRules();

/// Whether the hand, brought open to a pose that was planned and closed there, would hold the
/// object of `check` (made with TrialRules). The rules of GraspCheck::Close, in the order in which
/// things happen, and made fair to a pose that is a little off:
///  1. the open hand, in its place, keeps off the table (kNearTable) and the object's surface
///     (kTouchesObject), fingers yielding by Gripper::pad_slack_m;
///  2. fingers and thumb close on something (kNothingHeld) no wider than Gripper::WidestM
///     (kTooWide): the clearance may lie on one side. What is between them must not begin behind
///     the open pads, yielding or not (kTooWide too);
///  3. what lies to one side is pushed there by the finger that meets it first, along the closing
///     axis, until the other one meets it too: by |middle of the contacts| − off_centre_m, which
///     the hand yields as it does to a person. Its part along z, in which the table does not let
///     the object move, is at most off_centre_m: kOffCentre;
///  4. the line between the contacts lies in both friction cones (kSlips);
///  5. all that the hand passes through while it closes keeps off table and object, which rests in
///     its last place.
/// A pose at which Close finds no fault has none here. The contacts of the outcome are those after
/// the push.
///
/// A rule of geometry, not of dynamics: how the hand comes to the pose (nearly all that it sweeps
/// on its way along the approach axis is hand at its end), how far the object turns or tips while
/// it is pushed, its weight, and whether it stays in the hand when it is lifted are not looked at.
[[nodiscard]] GraspOutcome TryGrasp(const GraspCheck& check,
                                    const Eigen::Isometry3f& object_from_grasp);

}  // namespace handcraft::synthetic
