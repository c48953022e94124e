// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/formats/view_set.h"
#include "experiments/view_studies/view_cell_result.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/progress.h"
#include "trainers/grasp_library/grasp_library.h"

namespace handcraft::experiments {

/// What a cell plans with, and for.
struct PlanData {
  const datasets::ViewSet& train;
  const grasp_library::TrainingSet& shown;
  const datasets::ViewSet& asked;
};

/// Grasp planning, from picture and cloud to joint values, and the time of each layer. A classifier
/// of the views `train` and a library of their turns and of the demonstrations are trained, written
/// into `models` and planned with (GraspPlanner), one view that is asked about after the other in
/// one thread. The object's pixels are those of its mask; the point to grasp at is told by
/// ViewSettings.grasps.grasp_points, a model, or else is the middle of the picture or of these
/// pixels; the class may be told (the first of RightClasses). Rows of the answers are classes,
/// columns what became of the plans: by JudgeByJointValues for ViewTask::kGraspPlan, else by
/// JudgeByTrueShape; last of them "no plan", where none can be made (Error(kNoResult)). Times are
/// medians over the plans, by the steady clock, and of the whole plan also processor time; image
/// processing, with a model alone, counts the search for what stands on the table too. Throws Error
/// as GraspPlanner and the judge do, and what training throws.
/// Source: dissertation, Table 4.5 and Figures 4.8 to 4.10.
[[nodiscard]] ViewCellResult PlanGrasps(const ViewStudy& study,
                                        const ViewCell& cell,
                                        const PlanData& data,
                                        const std::filesystem::path& models,
                                        const Progress& progress);

}  // namespace handcraft::experiments
