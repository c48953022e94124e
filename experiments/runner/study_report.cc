// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_report.h"

#include <utility>

#include "experiments/runner/study_examples.h"
#include "experiments/runner/study_figures.h"
#include "experiments/runner/study_page.h"
#include "experiments/runner/summary_markdown.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxExamples = 5;

}  // namespace

GnuplotReport WriteStudyReport(const fs::path& out,
                               const StudyRun& run,
                               const StudySummary& summary) {
  FigureFiles files = WriteFigures(out / "figures", FiguresOf(run, summary));
  WriteFileAtomically(out / "summary.md", SummaryMarkdown(run, summary));
  WriteFileAtomically(
      out / "report.html",
      MakeStudyPage(run, summary, files.figures, MakeExamples(run, summary, out, kMaxExamples)));
  return std::move(files.gnuplot);
}

}  // namespace handcraft::experiments
