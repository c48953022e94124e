// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace handcraft::experiments {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kMmPerM = 1e3;
constexpr const char* kAll = "all";

double Percent(std::size_t part, std::size_t all) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

// The published values of these, NaN for the others.
std::vector<double> TargetsOf(const std::vector<std::string>& names,
                              const std::map<std::string, double>& published) {
  std::vector<double> targets;
  targets.reserve(names.size());
  for (const std::string& name : names) {
    const auto found = published.find(name);
    targets.push_back(found == published.end() ? kNaN : found->second);
  }
  return targets;
}

// Of all groups, or without those of one row where they would be too many to be told apart.
std::vector<std::string> ShownGroups(const ViewStudyRun& run) {
  constexpr std::size_t kMostBars = 100;
  std::vector<std::string> groups = GroupNames(run.results);
  if (groups.size() * run.results.size() <= kMostBars) return groups;
  std::vector<std::string> rows;
  for (const ViewCellResult& result : run.results) {
    rows.insert(rows.end(), result.answers.rows.begin(), result.answers.rows.end());
  }
  std::erase_if(groups, [&](const std::string& name) {
    return std::find(rows.begin(), rows.end(), name) != rows.end();
  });
  return groups;
}

BarFigure SharesFigure(const ViewStudyRun& run) {
  BarFigure figure{.title = run.study.title,
                   .y_label = "right [%]",
                   .groups = ShownGroups(run),
                   .series = {},
                   .target_name = run.study.claim_source};
  figure.targets = TargetsOf(figure.groups, run.study.claims);
  for (const ViewCellResult& result : run.results) {
    BarFigure::Series series{.name = result.id, .bars = {}};
    for (const std::string& name : figure.groups) {
      Estimate bar{kNaN, kNaN, kNaN};
      if (const GroupShare* const group = FindGroup(result, name)) {
        bar = {100.0 * group->share.value, 100.0 * group->share.low, 100.0 * group->share.high};
      }
      series.bars.push_back(bar);
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
}

BarFigure TimesFigure(const ViewStudyRun& run) {
  BarFigure figure{.title = run.study.title,
                   .y_label = "time [ms]",
                   .groups = {},
                   .series = {},
                   .target_name = run.study.claim_source,
                   .log_y = true};
  for (const ViewCellResult& result : run.results) {
    BarFigure::Series series{.name = result.id, .bars = {}};
    figure.groups.clear();
    for (const TimeFigure& time : result.times) {
      if (!run.study.claimed_ms.contains(time.name) || time.name == "all_ms") continue;
      figure.groups.push_back(time.name);
      series.bars.push_back({time.value, time.value, time.value});
    }
    figure.series.push_back(std::move(series));
  }
  figure.targets = TargetsOf(figure.groups, run.study.claimed_ms);
  return figure;
}

// How many views of the rows that are counted have each answer.
BarFigure::Series HistogramOf(const ViewCellResult& result,
                              const std::function<bool(std::size_t row)>& is_counted) {
  const AnswerCounts& answers = result.answers;
  BarFigure::Series series{.name = result.id, .bars = {}};
  for (std::size_t column = 0; column < answers.columns.size(); ++column) {
    double sum = 0.0;
    for (std::size_t row = 0; row < answers.rows.size(); ++row) {
      if (is_counted(row)) sum += static_cast<double>(answers.counts[row][column]);
    }
    series.bars.push_back({sum, sum, sum});
  }
  return series;
}

BarFigure HistogramFigure(const ViewStudyRun& run, const std::string& kind) {
  BarFigure figure{.title = fmt::format("{}: {}", run.study.title, kind),
                   .y_label = "views",
                   .groups = {},
                   .series = {},
                   .x_label = "most similar view, from the actual turn"};
  constexpr std::size_t kNamedBins = 3;  // all names would lie over each other
  const std::vector<std::string>& bins = run.results.front().answers.columns;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    figure.groups.push_back(bin % kNamedBins == 0 ? bins[bin] : "");
  }
  for (const ViewCellResult& result : run.results) {
    figure.series.push_back(
        HistogramOf(result, [&](std::size_t row) { return result.answers.kinds[row] == kind; }));
  }
  return figure;
}

BarFigure OutcomesFigure(const ViewStudyRun& run) {
  BarFigure figure{.title = run.study.title,
                   .y_label = "views",
                   .groups = run.results.front().answers.columns,
                   .series = {}};
  for (const ViewCellResult& result : run.results) {
    figure.series.push_back(HistogramOf(result, [](std::size_t) { return true; }));
  }
  return figure;
}

void AddHistograms(const ViewStudyRun& run, std::vector<NamedFigure>& figures) {
  std::vector<std::string> kinds = run.results.front().answers.kinds;
  std::sort(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  for (const std::string& kind : kinds) {
    std::string name = "rotation_histogram_" + kind;
    std::replace(name.begin(), name.end(), ' ', '_');
    figures.push_back({std::move(name), HistogramFigure(run, kind)});
  }
}

// The method and its factors but one.
std::string LineNameOf(const ViewCell& cell, const std::string& factor) {
  std::vector<Setting> others;
  for (const Setting& setting : cell.factors) {
    if (setting.key != factor) others.push_back(setting);
  }
  return CombinationId(cell.method, others);
}

// NaN for a text that is no number.
double NumberOf(const std::string& text) {
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last ? value : kNaN;
}

double ValueOf(const ViewCell& cell, const std::string& factor) {
  const auto found = std::find_if(cell.factors.begin(),
                                  cell.factors.end(),
                                  [&](const Setting& setting) { return setting.key == factor; });
  return found == cell.factors.end() ? kNaN : NumberOf(found->value);
}

// Something about a cell against the values of a factor.
LineFigure FigureAgainst(const ViewStudyRun& run,
                         const std::string& factor,
                         const std::string& y_label,
                         const std::function<double(const ViewCellResult&)>& value) {
  LineFigure figure{.title = run.study.title, .x_label = factor, .y_label = y_label, .series = {}};
  std::replace(figure.x_label.begin(), figure.x_label.end(), '_', ' ');
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    const std::string name = LineNameOf(run.cells[i], factor);
    auto series = std::find_if(figure.series.begin(), figure.series.end(), [&](const auto& line) {
      return line.name == name;
    });
    if (series == figure.series.end()) {
      series = figure.series.insert(series, {.name = name, .points = {}});
    }
    series->points.push_back(
        {.x = ValueOf(run.cells[i], factor), .y = value(run.results[i]), .name = ""});
  }
  for (LineFigure::Series& series : figure.series) {
    std::stable_sort(
        series.points.begin(),
        series.points.end(),
        [](const LineFigure::Point& a, const LineFigure::Point& b) { return a.x < b.x; });
  }
  return figure;
}

// "training_s" as a label: "training [s]".
std::string LabelOf(const std::string& time) {
  const std::size_t unit = time.rfind('_');
  std::string label = fmt::format("{} [{}]", time.substr(0, unit), time.substr(unit + 1));
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

double TimeNamed(const ViewCellResult& result, const std::string& name) {
  const auto found = std::find_if(result.times.begin(),
                                  result.times.end(),
                                  [&](const TimeFigure& time) { return time.name == name; });
  return found == result.times.end() ? kNaN : found->value;
}

// A line where a publication has a value for all groups together.
void AimAtAll(const ViewStudy& study, LineFigure& figure) {
  const auto found = study.claims.find(kAll);
  if (found == study.claims.end()) return;
  figure.target = found->second;
  figure.target_name = study.claim_source;
}

void AddFiguresAgainst(const ViewStudyRun& run,
                       const std::string& factor,
                       std::vector<NamedFigure>& figures) {
  const auto add = [&](const std::string& name,
                       const std::string& y_label,
                       const std::function<double(const ViewCellResult&)>& value) -> LineFigure& {
    figures.push_back({name + "_by_" + factor, FigureAgainst(run, factor, y_label, value)});
    return std::get<LineFigure>(figures.back().figure);
  };
  const ViewCellResult& first = run.results.front();
  if (FindGroup(first, kAll) != nullptr) {
    AimAtAll(run.study, add("right", "right [%]", [](const ViewCellResult& result) {
               const GroupShare* const all = FindGroup(result, kAll);
               return all == nullptr ? kNaN : 100.0 * all->share.value;
             }));
  }
  if (!first.errors.empty()) {
    add("position_error", "position error, median [mm]", [](const ViewCellResult& result) {
      return kMmPerM * result.errors.back().median_position_m;
    });
    add("rotation_error", "rotation error, median [°]", [](const ViewCellResult& result) {
      return result.errors.back().median_rotation_deg;
    });
  }
  for (const TimeFigure& time : first.times) {
    add(time.name, LabelOf(time.name), [&](const ViewCellResult& result) {
      return TimeNamed(result, time.name);
    });
  }
}

LineFigure RejectionFigure(const ViewStudyRun& run) {
  LineFigure figure{.title = run.study.title,
                    .x_label = "answers kept [%]",
                    .y_label = "right of those kept [%]",
                    .series = {}};
  for (std::size_t i = 0; i < run.results.size(); ++i) {
    const ViewCellResult& result = run.results[i];
    const auto is_same = [&](const ViewCellResult& other) {
      return other.rejection == result.rejection;
    };
    const auto earlier = run.results.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(run.results.begin(), earlier, is_same)) continue;
    LineFigure::Series series{.name = result.id, .points = {}};
    for (const RejectionPoint& point : result.rejection) {
      series.points.push_back({.x = Percent(point.num_kept, result.rejection.back().num_kept),
                               .y = Percent(point.num_right, point.num_kept),
                               .name = ""});
    }
    figure.series.push_back(std::move(series));
  }
  AimAtAll(run.study, figure);
  return figure;
}

bool HasNumbers(const Factor& factor) {
  return std::all_of(factor.values.begin(), factor.values.end(), [](const std::string& value) {
    return !std::isnan(NumberOf(value));
  });
}

}  // namespace

std::vector<NamedFigure> ViewStudyFigures(const ViewStudyRun& run) {
  std::vector<NamedFigure> figures = {{"right_answers", SharesFigure(run)}};
  if (run.study.task == ViewTask::kObjectRotation) AddHistograms(run, figures);
  if (IsOfPlans(run.study.task)) figures.push_back({"outcomes", OutcomesFigure(run)});
  if (!run.study.claimed_ms.empty()) figures.push_back({"layer_times", TimesFigure(run)});
  for (const Factor& factor : run.study.factors) {
    if (HasNumbers(factor)) AddFiguresAgainst(run, factor.key, figures);
  }
  if (!run.results.front().rejection.empty()) {
    figures.push_back({"rejection", RejectionFigure(run)});
  }
  return figures;
}

}  // namespace handcraft::experiments
