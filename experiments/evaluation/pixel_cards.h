// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>

#include "experiments/metrics/binary_metrics.h"
#include "experiments/metrics/precision_recall.h"
#include "experiments/metrics/probability_bins.h"

namespace handcraft::experiments {

/// What is known of a classifier of labelled pixels, with the curves of its figures.
struct PixelFigures {
  ConfusionMatrix confusion = {};
  double threshold = 0.5;  ///< of `confusion`
  ConfusionMatrix strict_confusion = {};
  double strict_threshold = 0.9;  ///< of `strict_confusion`
  Estimate auc = {};
  Estimate average_precision = {};
  double brier = 0.0;
  std::span<const RocPoint> roc = {};
  std::span<const PrecisionRecallPoint> precision_recall = {};
  std::span<const ProbabilityBin> reliability = {};
};

/// Five cards for a page's grid of plots, on the page of `evaluate` and of a study alike: the two
/// confusion matrices, ROC curve, precision and recall, reliability. Pure.
[[nodiscard]] std::string PixelCards(const PixelFigures& figures);

}  // namespace handcraft::experiments
