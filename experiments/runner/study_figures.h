// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "experiments/runner/figure_files.h"
#include "experiments/runner/study_summary.h"

namespace handcraft::experiments {

/// Best-pixel accuracy by class, a bar a series (the dissertation's Figures 3.7 and 3.8); and how
/// far each series is from the baseline on the same images, where there is another method; and how
/// long scoring and training took, mean over repetitions: against the number of features (Figures
/// 3.10 and 3.11), a line for each number of filters, classifier, region and choice of other
/// factors; bars where all methods have as many features.
[[nodiscard]] std::vector<NamedFigure> FiguresOf(const StudyRun& run, const StudySummary& summary);

}  // namespace handcraft::experiments
