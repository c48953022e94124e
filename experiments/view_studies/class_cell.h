// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/view_set.h"
#include "experiments/view_studies/view_cell_result.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

/// Layer 1 on views: support vector machines of feature vectors of their clouds. Without `test`
/// each view is classified by machines that were trained without it and its moved copies; else the
/// views of `test` are classified, by the runtime, after training on all of `train`. Rows of the
/// answers are classes, the last column is "none of these" (kNoneOfThese, which is right where the
/// study associates a class with it); groups are the classes and "all". The rejection curve, with
/// `test`, is over minus the margin.
/// Throws Error as TrainObjectClasses and EvaluateClouds do, and Error(kNoResult) when training
/// does not converge.
/// Source: dissertation, sections 4.2.2 and 4.3.1, Tables 4.2 to 4.4.
[[nodiscard]] ViewCellResult TellClasses(const ViewStudy& study,
                                         const ViewCell& cell,
                                         const datasets::ViewSet& train,
                                         const datasets::ViewSet* test,
                                         int num_threads,
                                         const Progress& progress);

}  // namespace handcraft::experiments
