// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/evaluation/svg_figure.h"
#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// Groups of bars with intervals, a bar a series in each group.
struct BarFigure {
  struct Series {
    std::string name;
    std::vector<Estimate> bars;              ///< one a group; NaN: none
    std::optional<std::size_t> colour = {};  ///< as that of another figure; none: by position
  };
  std::string title;
  std::string y_label;
  std::vector<std::string> groups;
  std::vector<Series> series;
};

/// The figure as a program for gnuplot that writes NAME.svg and NAME.pdf beside the program. The
/// axis holds 0 and every interval. Same figure, same text.
[[nodiscard]] std::string GnuplotProgram(const BarFigure& figure, const std::string& name);

/// The same, drawn by ourselves.
[[nodiscard]] SvgFigure PlotBars(const BarFigure& figure);

}  // namespace handcraft::experiments
