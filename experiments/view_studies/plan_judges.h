// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "experiments/grasp_planning/grasp_planner.h"
#include "experiments/view_studies/view_study.h"

namespace handcraft::experiments {

/// What may become of a plan, and which of it a plan has become.
struct PlanJudge {
  std::vector<std::string> outcomes;
  std::vector<bool> is_right;  ///< of each outcome
  /// The number of the outcome of a plan for the view of this number.
  std::function<std::size_t(std::size_t view, const GraspPlan& plan)> outcome_of;
};

/// Whether the plan ends in joint values, at the nearest demonstration or a next nearest one; it
/// does not where the class is none that is right (RightClasses), the nearest demonstration is too
/// far, or the arm reaches none. Study and views must outlive the judge.
[[nodiscard]] PlanJudge JudgeByJointValues(const ViewStudy& study, const datasets::ViewSet& views);

/// Whether the hand, at the pose that was planned, would hold what truly stands in the view:
/// synthetic::TryGrasp with the default Gripper on the mesh that was rendered, where it stood
/// (synthetic::DrawTrueObject). "held" is right, the other outcomes are the faults that TryGrasp
/// finds; a pose that the arm's inverse kinematics does not solve is "out of reach", one that the
/// library's distance rejects "too far". The class is not looked at. Calls throw what
/// DrawTrueObject throws. The views must outlive the judge.
[[nodiscard]] PlanJudge JudgeByTrueShape(const datasets::ViewSet& views);

}  // namespace handcraft::experiments
