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

/// Groups of bars with intervals, a bar a series in each group, and across a group a dashed line at
/// the value that was aimed at.
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
  std::string x_label = {};
  std::vector<double> targets = {};  ///< one a group, NaN: none; empty: none at all
  std::string target_name = {};      ///< "Table 4.2"
  bool log_y = false;  ///< bars grow from the foot of the axis; all values are above 0
};

/// The figure as a program for gnuplot that writes NAME.svg and NAME.pdf beside the program. The
/// axis holds every interval and target, and 0 unless it is logarithmic. Same figure, same text.
[[nodiscard]] std::string GnuplotProgram(const BarFigure& figure, const std::string& name);

/// The same, drawn by ourselves.
[[nodiscard]] SvgFigure PlotBars(const BarFigure& figure);

}  // namespace handcraft::experiments
