// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "experiments/runner/bar_figure.h"
#include "experiments/runner/line_figure.h"

namespace handcraft::experiments {

/// A figure of the report and the name of its files.
struct NamedFigure {
  std::string name;
  std::variant<BarFigure, LineFigure> figure;
};

/// A figure as the text of an SVG file.
struct PageFigure {
  std::string title;
  std::string svg;
};

/// What gnuplot made of figures, for the caller to tell.
struct GnuplotReport {
  bool has_gnuplot = true;               ///< false: the SVG are our own, and there are no PDF
  std::vector<std::string> failed = {};  ///< names of the figures it failed on: the same of these
};

/// Figures as files, and what a page shows of them.
struct FigureFiles {
  std::vector<PageFigure> figures = {};
  GnuplotReport gnuplot = {};
};

/// Writes each figure into the folder, which is made: its program for gnuplot, and NAME.svg and
/// NAME.pdf by gnuplot; without gnuplot, or where it fails, NAME.svg drawn by ourselves and no
/// NAME.pdf, not even an earlier one. Throws Error when it cannot write.
[[nodiscard]] FigureFiles WriteFigures(const std::filesystem::path& folder,
                                       std::span<const NamedFigure> figures);

/// The figures as cards of a page (experiments/evaluation/html_text.h).
[[nodiscard]] std::string FigureCards(std::span<const PageFigure> figures);

}  // namespace handcraft::experiments
