// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/svg_figure.h"
#include "experiments/metrics/probability_bins.h"

namespace handcraft::experiments {

/// True against false positive rate, with the diagonal of guessing. An empty curve gives the empty
/// frame.
[[nodiscard]] SvgFigure PlotRoc(std::span<const RocPoint> curve);

/// Precision against recall. An empty curve gives the empty frame.
[[nodiscard]] SvgFigure PlotPrecisionRecall(std::span<const PrecisionRecallPoint> curve);

/// Share of good pixels against mean probability, one marker a bin that has any.
[[nodiscard]] SvgFigure PlotReliability(std::span<const ProbabilityBin> bins);

/// Share of the good and of the bad pixels a bin holds, side by side.
[[nodiscard]] SvgFigure PlotScoreHistogram(std::span<const ProbabilityBin> bins);

/// Best-pixel accuracy with its interval, a bar a class and one for all: the dissertation's
/// Figure 3.7.
[[nodiscard]] SvgFigure PlotBestPixelAccuracy(const GraspPointEvaluation& evaluation);

}  // namespace handcraft::experiments
