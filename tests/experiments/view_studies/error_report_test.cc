// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/error_report.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;

// Two methods, each with one and two neighbours; the errors rise from cell to cell.
ViewStudyRun SomeRun() {
  ViewStudyRun run;
  run.study.title = "Held";
  run.study.methods = {{"near", {}}, {"far", {{"max_distance_m", "0.1"}}}};
  run.study.factors = {{"neighbours", {"2", "1"}}};
  run.cells = MakeViewCells(run.study);
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    const double part = static_cast<double>(i + 1);
    run.results.push_back({.id = run.cells[i].id,
                           .answers = {},
                           .errors = {{.name = "can", .num_asked = 1},
                                      {.name = "all",
                                       .num_asked = 9,
                                       .num_kept = 8,
                                       .median_position_m = 0.001 * part,
                                       .high_position_m = 0.002 * part,
                                       .median_rotation_deg = 10.0 * part,
                                       .high_rotation_deg = 20.0 * part}},
                           .rejection = {{.limit = 0.01, .num_kept = 4, .num_right = 3},
                                         {.limit = 0.02, .num_kept = 8, .num_right = 4 + i / 2}}});
  }
  return run;
}

TEST(ErrorReport, TellsTheErrorsOfAllGroups) {
  const ViewStudyRun run = SomeRun();
  const ReportTable table = ErrorsTable(run);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_THAT(table.rows[1],
              ElementsAre("near,neighbours=1", "8 of 9", "2.0", "4.0", "20.0", "40.0"));
  EXPECT_EQ(AllErrors(run.results).rows.size(), 8U);
  EXPECT_THAT(AllRejectionPoints(run.results).rows[0],
              ElementsAre("near,neighbours=2", "0.01", "4", "3"));
}

TEST(ErrorReport, HasNothingToTellOfClasses) {
  ViewStudyRun run;
  run.results.push_back({.id = "a", .answers = {}});
  EXPECT_TRUE(ErrorsTable(run).rows.empty());
  EXPECT_TRUE(AllErrors(run.results).rows.empty());
}

}  // namespace
}  // namespace handcraft::experiments
