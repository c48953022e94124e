// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "experiments/evaluation/svg_figure.h"
#include "experiments/feature_analysis/feature_analysis.h"

namespace handcraft::experiments {

/// The dissertation's Figure 3.2: the first 100 eigenvalues over the largest, on a logarithmic
/// axis, one line a scaling. Eigenvalues below 1e-12 of the largest, which are rounding, are left
/// out.
[[nodiscard]] SvgFigure PlotEigenvalues(const std::vector<EnergySpectrum>& spectra);

/// Figure 3.3: the entries of the first eigenvector over the largest of them, a grid line at every
/// window pixel: the period is the number of filters.
[[nodiscard]] SvgFigure PlotFirstComponent(const EnergySpectrum& spectrum,
                                           const features::FeatureSpec& spec);

/// Both rankings side by side: one line a filter from its rank by energy, in every scaling, to its
/// rank by usefulness.
[[nodiscard]] SvgFigure PlotRankings(const FeatureAnalysis& analysis);

/// Held-out log-loss against the number of filters left, with the 95 % interval of its increase.
[[nodiscard]] SvgFigure PlotElimination(const FeatureAnalysis& analysis);

/// 1 for the largest value; equal ones in order.
[[nodiscard]] std::vector<std::size_t> RanksOf(const std::vector<double>& values);

/// Of each filter, 1 for the one that stays to the last.
[[nodiscard]] std::vector<std::size_t> UsefulnessRanks(const BackwardElimination& elimination);

/// "raw features", "edge masks as printed", "standardised features".
[[nodiscard]] std::string TitleOf(FeatureScaling scaling);

}  // namespace handcraft::experiments
