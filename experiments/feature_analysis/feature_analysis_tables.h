// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/evaluation/report_table.h"
#include "experiments/feature_analysis/feature_analysis.h"

namespace handcraft::experiments {

/// People read rounded numbers, machines exact ones.
enum class Reader { kPeople, kMachines };

/// The tables of a feature analysis; rows in the order of the specification, of the components or
/// of the steps.
[[nodiscard]] ReportTable FilterTable(const FeatureAnalysis& analysis, Reader reader);
[[nodiscard]] ReportTable PositionTable(const FeatureAnalysis& analysis, Reader reader);
[[nodiscard]] ReportTable EigenvalueTable(const FeatureAnalysis& analysis);
[[nodiscard]] ReportTable ComponentTable(const FeatureAnalysis& analysis);
[[nodiscard]] ReportTable RingTable(const FeatureAnalysis& analysis);
[[nodiscard]] ReportTable EliminationTable(const FeatureAnalysis& analysis);
[[nodiscard]] ReportTable HypothesisTable(const FeatureAnalysis& analysis, Reader reader);

/// Name of the filter at an index of the specification.
[[nodiscard]] std::string NameOfFilter(const FeatureAnalysis& analysis, std::size_t filter);

/// The filters of `part`, a specification of some of those of `whole`, for people: "edge_0,
/// edge_90", "all but laws_SS" when most are there, or "all 20".
[[nodiscard]] std::string KeptFiltersText(const features::FeatureSpec& part,
                                          const features::FeatureSpec& whole);

/// The names of the window's pixels and scales, "(-2,1)" or "1/3", in order.
[[nodiscard]] std::vector<std::string> PositionNames(const features::FeatureSpec& spec);

}  // namespace handcraft::experiments
