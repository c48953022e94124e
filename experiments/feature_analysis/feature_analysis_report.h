// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>

#include "experiments/feature_analysis/feature_analysis.h"

namespace handcraft::experiments {

/// The result as files, name to text: summary.md; report.html (one self-contained page);
/// results.json; filters.csv, positions.csv, eigenvalues.csv, elimination.csv, hypotheses.csv; and
/// the figures as SVG. Two runs give the same bytes. `data_name` is what the page calls the data
/// set.
[[nodiscard]] std::map<std::string, std::string> FeatureAnalysisFiles(
    const FeatureAnalysis& analysis, const std::string& data_name);

}  // namespace handcraft::experiments
