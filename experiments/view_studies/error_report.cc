// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/error_report.h"

#include <utility>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "lib/core/fields.h"

namespace handcraft::experiments {
namespace {

constexpr double kMmPerM = 1e3;

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

}  // namespace handcraft::experiments
