// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_summary.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "lib/core/parallel.h"

namespace handcraft::experiments {
namespace {

constexpr const char* kAll = "all";
constexpr double kPointsPerShare = 100.0;

std::string LabelOf(const Cell& cell) {
  std::string label = cell.method;
  for (const Setting& factor : cell.factors) {
    label += fmt::format(", {} = {}", factor.key, factor.value);
  }
  return label;
}

// Repetitions of a cell follow each other.
std::vector<SeriesSummary> ListSeries(const StudyRun& run) {
  std::vector<SeriesSummary> series;
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    if (run.cells[i].repetition == 1) {
      series.push_back({.label = LabelOf(run.cells[i]), .method = run.cells[i].method});
    }
    series.back().cells.push_back(i);
  }
  return series;
}

std::vector<std::string> ListClasses(const StudyRun& run) {
  std::set<std::string> names;
  for (const CellResult& result : run.results) {
    for (const ImageFigures& image : result.images) names.insert(image.object_class);
  }
  std::vector<std::string> classes(names.begin(), names.end());
  classes.emplace_back(kAll);
  return classes;
}

std::vector<const CellResult*> ResultsOf(const StudyRun& run, const SeriesSummary& series) {
  std::vector<const CellResult*> results;
  results.reserve(series.cells.size());
  for (const std::size_t i : series.cells) results.push_back(&run.results[i]);
  return results;
}

// The series of the baseline method with the same factors.
const SeriesSummary& BaselineOf(const StudyRun& run,
                                const std::vector<SeriesSummary>& all,
                                const SeriesSummary& series) {
  const std::vector<Setting>& factors = run.cells[series.cells.front()].factors;
  for (const SeriesSummary& other : all) {
    if (other.method == run.study.baseline && run.cells[other.cells.front()].factors == factors) {
      return other;
    }
  }
  return series;
}

// The mean over cells of an estimate, end by end.
template <class EstimateOf>
Estimate MeanEstimate(const std::vector<const CellResult*>& cells, const EstimateOf& of) {
  Estimate mean;
  for (const CellResult* cell : cells) {
    const Estimate& estimate = of(*cell);
    mean.value += estimate.value;
    mean.low += estimate.low;
    mean.high += estimate.high;
  }
  const auto count = static_cast<double>(cells.size());
  return {mean.value / count, mean.low / count, mean.high / count};
}

void AddWholeFigures(const StudyRun& run, SeriesSummary& series) {
  std::vector<SearchSpaceFigures> search_spaces;
  for (const std::size_t i : series.cells) {
    const GroupFigures& all = run.results[i].groups.back();
    series.confusion += all.confusion;
    series.strict_confusion += all.strict_confusion;
    search_spaces.push_back(run.results[i].search_space);
  }
  series.search_space = Pooled(search_spaces);
  const std::vector<const CellResult*> cells = ResultsOf(run, series);
  series.auc = MeanEstimate(
      cells, [](const CellResult& cell) -> const Estimate& { return cell.groups.back().auc; });
  series.average_precision = MeanEstimate(cells, [](const CellResult& cell) -> const Estimate& {
    return cell.groups.back().average_precision;
  });
}

ClassSummary SummariseClass(const StudyRun& run,
                            const SeriesSummary& series,
                            const SeriesSummary& baseline,
                            const std::string& object_class) {
  const BootstrapOptions options{.resamples = run.study.bootstrap_resamples,
                                 .seed = run.study.seed};
  const std::string name = object_class == kAll ? "" : object_class;
  const std::vector<const CellResult*> ours = ResultsOf(run, series);
  ClassSummary summary{.figures = PoolFigures(ours, name, options)};
  if (&baseline != &series) {
    summary.difference = CompareFigures(ours, ResultsOf(run, baseline), name, options);
  }
  return summary;
}

std::optional<ClaimVerdict> Judge(const Study& study, const std::vector<SeriesSummary>& all) {
  if (!study.claim) return std::nullopt;
  std::optional<ClaimVerdict> verdict;
  for (const SeriesSummary& series : all) {
    const std::optional<Difference>& difference = series.by_class.back().difference;
    if (!difference || std::isnan(difference->best_pixel_accuracy.value)) continue;
    const Estimate& gain = difference->best_pixel_accuracy;
    const Estimate loss = {
        -kPointsPerShare * gain.value, -kPointsPerShare * gain.high, -kPointsPerShare * gain.low};
    if (verdict && verdict->loss_points.value >= loss.value) continue;
    verdict = {.worst = series.label,
               .loss_points = loss,
               .holds = loss.value <= study.claim->worst_loss_points};
  }
  return verdict;
}

std::vector<std::string> ListWarnings(const StudyRun& run, const std::vector<SeriesSummary>& all) {
  std::vector<std::string> warnings;
  for (const CellResult& result : run.results) {
    if (result.termination == "converged" || result.termination == "solved") continue;
    warnings.push_back(fmt::format("{}: training ended as {}", result.id, result.termination));
  }
  for (const SeriesSummary& series : all) {
    const std::optional<Difference>& difference = series.by_class.back().difference;
    if (!difference || !std::isnan(difference->best_pixel_accuracy.value)) continue;
    warnings.push_back(fmt::format(
        "{}: no best pixel on labelled ground, so what it loses cannot be told", series.label));
  }
  return warnings;
}

}  // namespace

StudySummary SummariseStudy(const StudyRun& run, int num_threads) {
  StudySummary summary{.classes = ListClasses(run), .series = ListSeries(run)};
  const std::size_t num_classes = summary.classes.size();
  for (SeriesSummary& series : summary.series) {
    AddWholeFigures(run, series);
    series.by_class.resize(num_classes);
  }
  ParallelFor(summary.series.size() * num_classes, num_threads, [&](std::size_t task) {
    SeriesSummary& series = summary.series[task / num_classes];
    const std::size_t k = task % num_classes;
    series.by_class[k] =
        SummariseClass(run, series, BaselineOf(run, summary.series, series), summary.classes[k]);
  });
  summary.verdict = Judge(run.study, summary.series);
  summary.warnings = ListWarnings(run, summary.series);
  return summary;
}

}  // namespace handcraft::experiments
