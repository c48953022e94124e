// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "experiments/evaluation/report_table.h"
#include "experiments/view_studies/view_study_run.h"

namespace handcraft::experiments {

/// Errors of the answers that were not rejected, a row a cell, over all groups.
[[nodiscard]] ReportTable ErrorsTable(const ViewStudyRun& run);

/// For errors.csv: a row a cell and group.
[[nodiscard]] ReportTable AllErrors(const std::vector<ViewCellResult>& results);

/// For rejection.csv: a row a cell and point of its curve.
[[nodiscard]] ReportTable AllRejectionPoints(const std::vector<ViewCellResult>& results);

}  // namespace handcraft::experiments
