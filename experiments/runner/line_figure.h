// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/evaluation/svg_figure.h"

namespace handcraft::experiments {

/// Lines through named points, both axes from 0, and a dashed line across at a value aimed at.
struct LineFigure {
  struct Point {
    double x = 0.0;  ///< ≥ 0
    double y = 0.0;  ///< ≥ 0; NaN: left out
    std::string name;
  };
  struct Series {
    std::string name;
    std::vector<Point> points;  ///< by ascending x
  };
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  std::optional<double> target = {};
  std::string target_name = {};  ///< "Table 4.2"
};

/// The figure as a program for gnuplot that writes NAME.svg and NAME.pdf beside the program. Same
/// figure, same text.
[[nodiscard]] std::string GnuplotProgram(const LineFigure& figure, const std::string& name);

/// The same, drawn by ourselves.
[[nodiscard]] SvgFigure PlotLines(const LineFigure& figure);

}  // namespace handcraft::experiments
