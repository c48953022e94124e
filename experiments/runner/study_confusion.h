// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "experiments/evaluation/report_table.h"
#include "experiments/runner/study_summary.h"

namespace handcraft::experiments {

/// What each method makes of labelled pixels, all pictures and repetitions together, with 95 %
/// intervals over images; features and samples of its first cell.
[[nodiscard]] ReportTable PixelFiguresTable(const StudyRun& run, const StudySummary& summary);

/// The confusion matrices over labelled pixels of all pictures and repetitions, at both thresholds:
/// counts, and their share of good or of bad pixels with its 95 % interval over images.
[[nodiscard]] ReportTable ConfusionCountsTable(const StudySummary& summary);

/// The same at the lower threshold in percent of all pixels, as measured and at the class ratio of
/// the dissertation's, beside its own of linear discriminant analysis (section 3.1.4). No rows for
/// a study without that method.
[[nodiscard]] ReportTable LdaConfusionTable(const StudyRun& run, const StudySummary& summary);

}  // namespace handcraft::experiments
