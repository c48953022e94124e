// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "experiments/runner/figure_files.h"
#include "experiments/view_studies/view_study_run.h"

namespace handcraft::experiments {

/// Writes summary.md, report.html and figures/ (SVG and PDF, with their programs for gnuplot) into
/// the folder of the run's results. Throws Error.
GnuplotReport WriteViewStudyReport(const std::filesystem::path& out, const ViewStudyRun& run);

}  // namespace handcraft::experiments
