// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "experiments/runner/figure_files.h"
#include "experiments/view_studies/view_study_run.h"

namespace handcraft::experiments {

/// The figures of a study of views, each with a dashed line where a publication has a value:
/// - right_answers: what is right of each group, a bar a cell; with more bars than can be told
///   apart, of the groups of many rows alone;
/// - rotation_histogram_KIND (task kObjectRotation; dissertation, Figure 4.7): how many views were
///   found how far from the actual turn, a figure a kind of symmetry;
/// - outcomes (tasks of plans): how many views ended how;
/// - layer_times: the times that the publication has too, but for their sum, logarithmic;
/// - right, position_error, rotation_error and times against each factor whose values are numbers
///   (NAME_by_FACTOR), a line a method;
/// - rejection: what is right of the answers kept against how many are kept, a line a curve.
[[nodiscard]] std::vector<NamedFigure> ViewStudyFigures(const ViewStudyRun& run);

}  // namespace handcraft::experiments
