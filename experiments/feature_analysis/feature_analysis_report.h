// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/feature_analysis/feature_analysis.h"

namespace handcraft::experiments {

/// The result as files, name to text: summary.md; report.html (one self-contained page);
/// results.json; filters.csv, positions.csv, eigenvalues.csv, elimination.csv, hypotheses.csv; and
/// the figures as SVG. Two runs give the same bytes. `data_name` is what the page calls the data
/// set.
[[nodiscard]] std::map<std::string, std::string> FeatureAnalysisFiles(
    const FeatureAnalysis& analysis, const std::string& data_name);

/// The filters of `part`, a specification of some of those of `whole`, for people: "edge_0,
/// edge_90", "all but laws_SS" when most are there, or "all 20".
[[nodiscard]] std::string KeptFiltersText(const features::FeatureSpec& part,
                                          const features::FeatureSpec& whole);

/// The names of the window's pixels and scales, "(-2,1)" or "1/3", in order.
[[nodiscard]] std::vector<std::string> PositionNames(const features::FeatureSpec& spec);

}  // namespace handcraft::experiments
