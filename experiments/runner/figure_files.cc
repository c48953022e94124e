// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/figure_files.h"

#include <cstdint>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/svg_figure.h"
#include "experiments/runner/gnuplot.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

SvgFigure Plot(const BarFigure& figure) { return PlotBars(figure); }
SvgFigure Plot(const LineFigure& figure) { return PlotLines(figure); }

// Whether gnuplot drew the figure; the report is told when it did not.
bool DrawByGnuplot(const fs::path& program, const std::string& name, GnuplotReport& report) {
  if (!report.has_gnuplot) return false;
  const GnuplotOutcome outcome = RunGnuplot(program);
  if (outcome == GnuplotOutcome::kNoGnuplot) report.has_gnuplot = false;
  if (outcome == GnuplotOutcome::kFailed) report.failed.push_back(name);
  return outcome == GnuplotOutcome::kDone;
}

// The SVG of a figure, by gnuplot where that works.
PageFigure WriteFigure(const fs::path& folder, const NamedFigure& named, GnuplotReport& report) {
  const fs::path program = folder / (named.name + ".gnuplot");
  const fs::path svg = folder / (named.name + ".svg");
  return std::visit(
      [&](const auto& figure) -> PageFigure {
        WriteFileAtomically(program, GnuplotProgram(figure, named.name));
        if (!DrawByGnuplot(program, named.name, report)) {
          WriteFileAtomically(svg, Plot(figure).ToFileText());
          fs::remove(folder / (named.name + ".pdf"));
        }
        return {figure.title, ReadTextFile(svg)};
      },
      named.figure);
}

}  // namespace

FigureFiles WriteFigures(const fs::path& folder, std::span<const NamedFigure> figures) {
  fs::create_directories(folder);
  FigureFiles files;
  for (const NamedFigure& figure : figures) {
    files.figures.push_back(WriteFigure(folder, figure, files.gnuplot));
  }
  return files;
}

std::string FigureCards(std::span<const PageFigure> figures) {
  std::string text;
  for (const PageFigure& figure : figures) {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(figure.svg.data()),
                          figure.svg.size());
    text += fmt::format(
        "<figure class=\"card wide\"><img style=\"width: 100%; background: #fff\" alt=\"{}\" "
        "src=\"{}\"></figure>\n",
        EscapeHtml(figure.title),
        DataUri("image/svg+xml", bytes));
  }
  return text;
}

}  // namespace handcraft::experiments
