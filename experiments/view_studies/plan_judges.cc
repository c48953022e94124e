// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/plan_judges.h"

#include <algorithm>
#include <array>

#include "datasets/synthetic/grasp_trial.h"
#include "datasets/synthetic/true_objects.h"

namespace handcraft::experiments {
namespace {

using synthetic::GraspFault;

enum Reached : std::size_t { kNearest, kNextNearest, kNotReached, kRejected, kOtherClass };

std::size_t ReachedBy(const GraspPlan& plan, const std::vector<std::string>& right_classes) {
  if (std::find(right_classes.begin(), right_classes.end(), plan.object_class) ==
      right_classes.end()) {
    return kOtherClass;
  }
  if (plan.IsRejected()) return kRejected;
  if (!plan.kinematics.IsSolved()) return kNotReached;
  return plan.rank == 0 ? kNearest : kNextNearest;
}

// The faults that a trial may find, in the order of the columns; last what keeps the hand away.
constexpr std::array kFaults = {GraspFault::kNone,
                                GraspFault::kNearTable,
                                GraspFault::kTouchesObject,
                                GraspFault::kNothingHeld,
                                GraspFault::kTooWide,
                                GraspFault::kOffCentre,
                                GraspFault::kSlips,
                                GraspFault::kOutOfReach};
constexpr std::size_t kTooFar = kFaults.size();

GraspFault FaultOf(const GraspPlan& plan, const synthetic::TrueObject& object) {
  if (!plan.kinematics.IsSolved()) return GraspFault::kOutOfReach;
  const synthetic::GraspCheck check(object.mesh, {}, synthetic::TrialRules());
  return synthetic::TryGrasp(check, object.base_from_object.inverse() * BaseFromGrasp(plan)).fault;
}

}  // namespace

PlanJudge JudgeByJointValues(const ViewStudy& study, const datasets::ViewSet& views) {
  return {.outcomes =
              {"nearest reached", "next nearest reached", "out of reach", "too far", "other class"},
          .is_right = {true, true, false, false, false},
          .outcome_of = [&study, &views](std::size_t view, const GraspPlan& plan) {
            return ReachedBy(plan, RightClasses(study, views.items[view].object_class));
          }};
}

PlanJudge JudgeByTrueShape(const datasets::ViewSet& views) {
  PlanJudge judge;
  for (const GraspFault fault : kFaults) {
    judge.outcomes.emplace_back(fault == GraspFault::kNone ? "held" : NameOf(fault));
    judge.is_right.push_back(fault == GraspFault::kNone);
  }
  judge.outcomes.emplace_back("too far");
  judge.is_right.push_back(false);
  judge.outcome_of = [&views](std::size_t view, const GraspPlan& plan) -> std::size_t {
    if (plan.IsRejected()) return kTooFar;
    const GraspFault fault = FaultOf(plan, synthetic::DrawTrueObject(views, view));
    return static_cast<std::size_t>(std::find(kFaults.begin(), kFaults.end(), fault) -
                                    kFaults.begin());
  };
  return judge;
}

}  // namespace handcraft::experiments
