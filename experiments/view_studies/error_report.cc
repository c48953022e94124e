// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/error_report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "lib/core/fields.h"

namespace handcraft::experiments {
namespace {

constexpr std::string_view kNeighbours = "neighbours";
constexpr double kMmPerM = 1e3;

double Percent(std::size_t part, std::size_t all) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

// The method and its factors but the number of neighbours.
std::string LineNameOf(const ViewCell& cell) {
  std::vector<Setting> others;
  for (const Setting& factor : cell.factors) {
    if (factor.key != kNeighbours) others.push_back(factor);
  }
  return CombinationId(cell.method, others);
}

// A figure of "all" against the number of neighbours.
LineFigure AgainstNeighbours(const ViewStudyRun& run,
                             const std::string& y_label,
                             double (*value)(const GroupErrors&)) {
  LineFigure figure{
      .title = run.study.title, .x_label = "neighbours averaged", .y_label = y_label, .series = {}};
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    const std::string name = LineNameOf(run.cells[i]);
    auto series = std::find_if(figure.series.begin(), figure.series.end(), [&](const auto& line) {
      return line.name == name;
    });
    if (series == figure.series.end()) {
      series = figure.series.insert(series, {.name = name, .points = {}});
    }
    series->points.push_back({.x = static_cast<double>(run.cells[i].settings.grasps.num_neighbours),
                              .y = value(run.results[i].errors.back()),
                              .name = ""});
  }
  for (LineFigure::Series& series : figure.series) {
    std::stable_sort(
        series.points.begin(),
        series.points.end(),
        [](const LineFigure::Point& a, const LineFigure::Point& b) { return a.x < b.x; });
  }
  return figure;
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
  return figure;
}

}  // namespace

ReportTable ErrorsTable(const ViewStudyRun& run) {
  ReportTable table{
      .head = {"cell", "kept", "position, median [mm]", "90 %", "rotation, median [°]", "90 % "}};
  for (const ViewCellResult& result : run.results) {
    if (result.errors.empty()) continue;
    const GroupErrors& all = result.errors.back();
    table.rows.push_back({result.id,
                          fmt::format("{} of {}", all.num_kept, all.num_asked),
                          DecimalText(kMmPerM * all.median_position_m, 1),
                          DecimalText(kMmPerM * all.high_position_m, 1),
                          DecimalText(all.median_rotation_deg, 1),
                          DecimalText(all.high_rotation_deg, 1)});
  }
  return table;
}

ReportTable AllErrors(const std::vector<ViewCellResult>& results) {
  ReportTable table{.head = {"cell",
                             "class",
                             "num_asked",
                             "num_kept",
                             "median_position_m",
                             "high_position_m",
                             "median_rotation_deg",
                             "high_rotation_deg"}};
  for (const ViewCellResult& result : results) {
    for (const GroupErrors& group : result.errors) {
      table.rows.push_back({result.id,
                            group.name,
                            NumberToText(group.num_asked),
                            NumberToText(group.num_kept),
                            NumberToText(group.median_position_m),
                            NumberToText(group.high_position_m),
                            NumberToText(group.median_rotation_deg),
                            NumberToText(group.high_rotation_deg)});
    }
  }
  return table;
}

ReportTable AllRejectionPoints(const std::vector<ViewCellResult>& results) {
  ReportTable table{.head = {"cell", "limit", "num_kept", "num_right"}};
  for (const ViewCellResult& result : results) {
    for (const RejectionPoint& point : result.rejection) {
      table.rows.push_back({result.id,
                            NumberToText(point.limit),
                            NumberToText(point.num_kept),
                            NumberToText(point.num_right)});
    }
  }
  return table;
}

std::vector<NamedFigure> ErrorFigures(const ViewStudyRun& run) {
  std::vector<NamedFigure> figures;
  const bool has_neighbours =
      std::any_of(run.study.factors.begin(), run.study.factors.end(), [](const Factor& factor) {
        return factor.key == kNeighbours;
      });
  if (has_neighbours && !run.results.front().errors.empty()) {
    figures.push_back(
        {"position_error",
         AgainstNeighbours(run, "position error, median [mm]", [](const GroupErrors& e) {
           return kMmPerM * e.median_position_m;
         })});
    figures.push_back(
        {"rotation_error",
         AgainstNeighbours(run, "rotation error, median [°]", [](const GroupErrors& e) {
           return e.median_rotation_deg;
         })});
  }
  if (!run.results.front().rejection.empty())
    figures.push_back({"rejection", RejectionFigure(run)});
  return figures;
}

}  // namespace handcraft::experiments
