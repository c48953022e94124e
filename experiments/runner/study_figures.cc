// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_figures.h"

#include <fmt/format.h>

namespace handcraft::experiments {
namespace {

Estimate InPercent(const Estimate& share) {
  return {100.0 * share.value, 100.0 * share.low, 100.0 * share.high};
}

// A bar a series; what was measured once has no interval.
NamedFigure TimesFigure(const StudyRun& run,
                        const StudySummary& summary,
                        const std::string& name,
                        const std::string& label,
                        double CellResult::*time) {
  NamedFigure named{.name = name,
                    .figure = {.title = label, .y_label = label, .groups = {}, .series = {}}};
  BarFigure::Series bars{.name = label, .bars = {}};
  for (const SeriesSummary& series : summary.series) {
    double sum = 0.0;
    for (const std::size_t i : series.cells) sum += run.results[i].*time;
    const double mean = sum / static_cast<double>(series.cells.size());
    bars.bars.push_back({mean, mean, mean});
    named.figure.groups.push_back(fmt::format(
        "{} ({} features)", series.label, run.results[series.cells.front()].num_features));
  }
  named.figure.series.push_back(std::move(bars));
  return named;
}

}  // namespace

std::vector<NamedFigure> FiguresOf(const StudyRun& run, const StudySummary& summary) {
  const Study& study = run.study;
  NamedFigure accuracy{.name = "best_pixel_accuracy",
                       .figure = {.title = study.title,
                                  .y_label = "best-pixel accuracy [%]",
                                  .groups = summary.classes,
                                  .series = {}}};
  NamedFigure difference{
      .name = "difference_to_baseline",
      .figure = {.title = fmt::format("Difference to {}, same images", study.baseline),
                 .y_label = "best-pixel accuracy [points]",
                 .groups = summary.classes,
                 .series = {}}};
  for (const SeriesSummary& series : summary.series) {
    BarFigure::Series level{.name = series.label, .bars = {}};
    BarFigure::Series change{.name = series.label, .bars = {}};
    for (const ClassSummary& of_class : series.by_class) {
      level.bars.push_back(InPercent(of_class.figures.best_pixel_accuracy));
      if (!of_class.difference) continue;
      change.bars.push_back(InPercent(of_class.difference->best_pixel_accuracy));
    }
    if (!change.bars.empty()) difference.figure.series.push_back(std::move(change));
    accuracy.figure.series.push_back(std::move(level));
  }
  std::vector<NamedFigure> figures = {std::move(accuracy)};
  if (!difference.figure.series.empty()) figures.push_back(std::move(difference));
  figures.push_back(TimesFigure(
      run, summary, "score_time", "time to score a picture [ms]", &CellResult::score_time_ms));
  figures.push_back(TimesFigure(
      run, summary, "training_time", "time to train [s]", &CellResult::training_time_s));
  return figures;
}

}  // namespace handcraft::experiments
