// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_report.h"

#include <variant>

#include "experiments/runner/gnuplot.h"
#include "experiments/runner/study_examples.h"
#include "experiments/runner/study_figures.h"
#include "experiments/runner/study_page.h"
#include "experiments/runner/summary_markdown.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxExamples = 5;

SvgFigure Plot(const BarFigure& figure) { return PlotBars(figure); }
SvgFigure Plot(const LineFigure& figure) { return PlotLines(figure); }

// The SVG of a figure, by gnuplot where there is one.
PageFigure WriteFigure(const fs::path& folder, const NamedFigure& named, bool& has_gnuplot) {
  const fs::path program = folder / (named.name + ".gnuplot");
  const fs::path svg = folder / (named.name + ".svg");
  return std::visit(
      [&](const auto& figure) -> PageFigure {
        WriteFileAtomically(program, GnuplotProgram(figure, named.name));
        has_gnuplot = has_gnuplot && RunGnuplot(program);
        if (!has_gnuplot) WriteFileAtomically(svg, Plot(figure).ToFileText());
        return {figure.title, ReadTextFile(svg)};
      },
      named.figure);
}

}  // namespace

StudyReport WriteStudyReport(const fs::path& out,
                             const StudyRun& run,
                             const StudySummary& summary) {
  StudyReport report{.has_gnuplot = true};
  fs::create_directories(out / "figures");
  std::vector<PageFigure> figures;
  for (const NamedFigure& figure : FiguresOf(run, summary)) {
    figures.push_back(WriteFigure(out / "figures", figure, report.has_gnuplot));
  }
  WriteFileAtomically(out / "summary.md", SummaryMarkdown(run, summary));
  WriteFileAtomically(
      out / "report.html",
      MakeStudyPage(run, summary, figures, MakeExamples(run, summary, out, kMaxExamples)));
  return report;
}

}  // namespace handcraft::experiments
