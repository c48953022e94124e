// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/pixel_cards.h"

#include <fmt/format.h>

#include "experiments/evaluation/confusion_table.h"
#include "experiments/evaluation/grasp_point_plots.h"
#include "experiments/evaluation/grasp_point_templates.h"
#include "experiments/evaluation/html_text.h"

namespace handcraft::experiments {

std::string PixelCards(const PixelFigures& figures, const PixelCurves& curves) {
  return fmt::format(
      fmt::runtime(kPixelCardsTemplate),
      fmt::arg("confusion", ConfusionTable(figures.confusion, figures.rates, figures.threshold)),
      fmt::arg("roc", PlotRoc(curves).ToInlineText()),
      fmt::arg("auc", DecimalEstimateText(figures.auc, 3)),
      fmt::arg("precision_recall", PlotPrecisionRecall(curves).ToInlineText()),
      fmt::arg("average_precision", DecimalEstimateText(figures.average_precision, 3)),
      fmt::arg(
          "strict_confusion",
          ConfusionTable(figures.strict_confusion, figures.strict_rates, figures.strict_threshold)),
      fmt::arg("reliability", PlotReliability(curves.reliability).ToInlineText()),
      fmt::arg("brier", DecimalEstimateText(figures.brier, 3)));
}

}  // namespace handcraft::experiments
