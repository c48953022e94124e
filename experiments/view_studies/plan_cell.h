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

/// Grasp planning, from picture and cloud to joint values, and the time of each layer. A classifier
/// of the views and a library of their turns and of the demonstrations are trained, written into
/// `models` and planned with (GraspPlanner), one view after the other in one thread. The object's
/// pixels are those of its mask; the point to grasp at is told by ViewSettings.grasps.grasp_points,
/// a model, or else is the picture's middle, where a turntable has its object. Rows of the answers
/// are classes, columns what became of the plans; right is one that ends in joint values. Times are
/// medians over the views, by the steady clock, and of the whole plan also processor time; image
/// processing, with a model alone, counts the search for what stands on the table too. Throws Error
/// as GraspPlanner does, and what training throws.
/// Source: dissertation, Table 4.5.
[[nodiscard]] ViewCellResult PlanGrasps(const ViewCell& cell,
                                        const datasets::ViewSet& views,
                                        const grasp_library::TrainingSet& shown,
                                        const std::filesystem::path& models,
                                        const Progress& progress);

}  // namespace handcraft::experiments
