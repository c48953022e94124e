// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "experiments/runner/study_summary.h"

namespace handcraft::experiments {

/// The claim's verdict in a sentence; empty without a claim.
[[nodiscard]] std::string VerdictText(const Study& study, const StudySummary& summary);

/// summary.md: question, figures by class, differences to the baseline, verdict, warnings, inputs.
/// Holds no time and no path, so that two runs give the same bytes.
[[nodiscard]] std::string SummaryMarkdown(const StudyRun& run, const StudySummary& summary);

}  // namespace handcraft::experiments
