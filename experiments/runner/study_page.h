// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "experiments/runner/figure_files.h"
#include "experiments/runner/study_examples.h"
#include "experiments/runner/study_summary.h"

namespace handcraft::experiments {

/// report.html: one page that opens offline, with tables (accuracy by class as a heat map,
/// differences to the baseline), figures, each method's confusion matrices and curves, and
/// examples. Pure: the same contents give the same bytes.
[[nodiscard]] std::string MakeStudyPage(const StudyRun& run,
                                        const StudySummary& summary,
                                        const std::vector<PageFigure>& figures,
                                        const std::vector<Example>& examples);

}  // namespace handcraft::experiments
