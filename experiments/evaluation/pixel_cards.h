// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "experiments/evaluation/grasp_point_evaluation.h"

namespace handcraft::experiments {

/// What is known of a classifier of labelled pixels, but for its curves.
struct PixelFigures {
  ConfusionMatrix confusion = {};
  ConfusionRates rates = {};
  double threshold = 0.5;  ///< of `confusion`
  ConfusionMatrix strict_confusion = {};
  ConfusionRates strict_rates = {};
  double strict_threshold = 0.9;  ///< of `strict_confusion`
  Estimate auc = {};
  Estimate average_precision = {};
  Estimate brier = {};
};

/// Five cards for a page's grid of plots, on the page of `evaluate` and of a study alike: the two
/// confusion matrices, ROC curve, precision and recall, reliability, all with their intervals.
/// Pure.
[[nodiscard]] std::string PixelCards(const PixelFigures& figures, const PixelCurves& curves);

}  // namespace handcraft::experiments
