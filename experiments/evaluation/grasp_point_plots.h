// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/svg_figure.h"
#include "experiments/metrics/probability_bins.h"

namespace handcraft::experiments {

/// True against false positive rate with its band, and the diagonal of guessing. Empty curves give
/// the empty frame, here and below.
[[nodiscard]] SvgFigure PlotRoc(const PixelCurves& curves);

/// Precision against recall, with its band.
[[nodiscard]] SvgFigure PlotPrecisionRecall(const PixelCurves& curves);

/// Share of good pixels against mean probability, a marker with its interval for each bin that has
/// any.
[[nodiscard]] SvgFigure PlotReliability(std::span<const ReliabilityBin> reliability);

/// Share of the good and of the bad pixels a bin holds, side by side.
[[nodiscard]] SvgFigure PlotScoreHistogram(std::span<const ProbabilityBin> bins);

/// Best-pixel accuracy with its interval, a bar a class and one for all: the dissertation's
/// Figure 3.7.
[[nodiscard]] SvgFigure PlotBestPixelAccuracy(const GraspPointEvaluation& evaluation);

}  // namespace handcraft::experiments
