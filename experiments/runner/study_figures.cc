// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_figures.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace handcraft::experiments {
namespace {

Estimate InPercent(const Estimate& share) {
  return {100.0 * share.value, 100.0 * share.low, 100.0 * share.high};
}

// A time of CellResult and its figure.
struct TimeFigure {
  std::string name;
  std::string label;
  double CellResult::*time;
};

double MeanTime(const StudyRun& run, const SeriesSummary& series, double CellResult::*time) {
  double sum = 0.0;
  for (const std::size_t i : series.cells) sum += run.results[i].*time;
  return sum / static_cast<double>(series.cells.size());
}

std::size_t NumFeatures(const StudyRun& run, const SeriesSummary& series) {
  return run.results[series.cells.front()].num_features;
}

// A bar a series; what was measured once has no interval.
BarFigure TimeBars(const StudyRun& run, const StudySummary& summary, const TimeFigure& of) {
  BarFigure figure{.title = of.label, .y_label = of.label, .groups = {}, .series = {}};
  BarFigure::Series bars{.name = of.label, .bars = {}};
  for (const SeriesSummary& series : summary.series) {
    const double mean = MeanTime(run, series, of.time);
    bars.bars.push_back({mean, mean, mean});
    figure.groups.push_back(
        fmt::format("{} ({} features)", series.label, NumFeatures(run, series)));
  }
  figure.series.push_back(std::move(bars));
  return figure;
}

// What the methods of a line have in common: along it the window grows.
std::string LineNameOf(const Cell& cell) {
  const int num_filters = SpecOf(cell.settings).NumFilters();
  std::string name = fmt::format("{} {}", num_filters, num_filters == 1 ? "filter" : "filters");
  if (cell.settings.classifier == Classifier::kLda) name += ", LDA";
  if (cell.settings.region == TestRegion::kObject) name += ", region R";
  for (const Setting& factor : cell.factors) {
    const bool is_of_features =
        factor.key == "features" || factor.key == "window" || factor.key == "energy";
    if (!is_of_features) name += fmt::format(", {} = {}", factor.key, factor.value);
  }
  return name;
}

LineFigure TimeLines(const StudyRun& run, const StudySummary& summary, const TimeFigure& of) {
  LineFigure figure{.title = of.label + " against the number of features",
                    .x_label = "number of features",
                    .y_label = of.label,
                    .series = {}};
  for (const SeriesSummary& series : summary.series) {
    const std::string name = LineNameOf(run.cells[series.cells.front()]);
    auto line = std::find_if(figure.series.begin(), figure.series.end(), [&](const auto& other) {
      return other.name == name;
    });
    if (line == figure.series.end()) {
      line = figure.series.insert(line, LineFigure::Series{.name = name, .points = {}});
    }
    line->points.push_back({static_cast<double>(NumFeatures(run, series)),
                            MeanTime(run, series, of.time),
                            series.method});
  }
  for (LineFigure::Series& line : figure.series) {
    std::stable_sort(line.points.begin(), line.points.end(), [](const auto& a, const auto& b) {
      return a.x < b.x;
    });
  }
  return figure;
}

NamedFigure FigureOfTimes(const StudyRun& run, const StudySummary& summary, const TimeFigure& of) {
  const std::size_t first = NumFeatures(run, summary.series.front());
  const bool are_equal =
      std::all_of(summary.series.begin(), summary.series.end(), [&](const SeriesSummary& series) {
        return NumFeatures(run, series) == first;
      });
  if (are_equal) return {of.name, TimeBars(run, summary, of)};
  return {of.name, TimeLines(run, summary, of)};
}

}  // namespace

std::vector<NamedFigure> FiguresOf(const StudyRun& run, const StudySummary& summary) {
  const Study& study = run.study;
  BarFigure accuracy{.title = study.title,
                     .y_label = "best-pixel accuracy [%]",
                     .groups = summary.classes,
                     .series = {}};
  BarFigure difference{.title = fmt::format("Difference to {}, same images", study.baseline),
                       .y_label = "best-pixel accuracy [points]",
                       .groups = summary.classes,
                       .series = {}};
  for (const SeriesSummary& series : summary.series) {
    BarFigure::Series level{.name = series.label, .bars = {}};
    BarFigure::Series change{.name = series.label, .bars = {}, .colour = accuracy.series.size()};
    for (const ClassSummary& of_class : series.by_class) {
      level.bars.push_back(InPercent(of_class.figures.best_pixel_accuracy));
      if (!of_class.difference) continue;
      change.bars.push_back(InPercent(of_class.difference->best_pixel_accuracy));
    }
    if (!change.bars.empty()) difference.series.push_back(std::move(change));
    accuracy.series.push_back(std::move(level));
  }
  std::vector<NamedFigure> figures = {{"best_pixel_accuracy", std::move(accuracy)}};
  if (!difference.series.empty()) {
    figures.push_back({"difference_to_baseline", std::move(difference)});
  }
  figures.push_back(FigureOfTimes(
      run, summary, {"score_time", "time to score a picture [ms]", &CellResult::score_time_ms}));
  figures.push_back(FigureOfTimes(
      run, summary, {"training_time", "time to train [s]", &CellResult::training_time_s}));
  return figures;
}

}  // namespace handcraft::experiments
