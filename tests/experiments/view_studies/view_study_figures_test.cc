// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_figures.h"

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
  run.study.task = ViewTask::kNearestDemonstration;
  run.study.methods = {{"near", {}}, {"far", {{"max_distance_m", "0.1"}}}};
  run.study.factors = {{"neighbours", {"2", "1"}}};
  run.study.claim_source = "Table 1";
  run.study.claims = {{"all", 84.0}};
  run.cells = MakeViewCells(run.study);
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    const double part = static_cast<double>(i + 1);
    ViewCellResult result{.id = run.cells[i].id,
                          .answers = {.row_title = "object", .rows = {"can"}, .counts = {}}};
    result.groups = {
        {.name = "can", .num_views = 4, .num_right = 2, .share = {0.5, 0.2, 0.8}},
        {.name = "all", .num_views = 4, .num_right = 2, .share = {0.1 * part, 0.0, 1.0}}};
    result.errors = {
        {.name = "all", .median_position_m = 0.001 * part, .median_rotation_deg = 10.0 * part}};
    result.rejection = {{.limit = 0.01, .num_kept = 4, .num_right = 3},
                        {.limit = 0.02, .num_kept = 8, .num_right = 4 + i / 2}};
    result.times = {{"training_s", part}};
    run.results.push_back(std::move(result));
  }
  return run;
}

std::vector<std::string> NamesOf(const std::vector<NamedFigure>& figures) {
  std::vector<std::string> names;
  names.reserve(figures.size());
  for (const NamedFigure& figure : figures) names.push_back(figure.name);
  return names;
}

TEST(ViewStudyFigures, DrawsWhatNumbersDoAndWhatIsKept) {
  const std::vector<NamedFigure> figures = ViewStudyFigures(SomeRun());
  ASSERT_THAT(NamesOf(figures),
              ElementsAre("right_answers",
                          "right_by_neighbours",
                          "position_error_by_neighbours",
                          "rotation_error_by_neighbours",
                          "training_s_by_neighbours",
                          "rejection"));
  const auto& right = std::get<LineFigure>(figures[1].figure);
  EXPECT_EQ(right.target, 84.0);
  EXPECT_EQ(right.target_name, "Table 1");
  EXPECT_DOUBLE_EQ(right.series[1].points[0].y, 40.0);
  const auto& rotation = std::get<LineFigure>(figures[3].figure);
  ASSERT_EQ(rotation.series.size(), 2U);
  EXPECT_FALSE(rotation.target.has_value());
  EXPECT_EQ(rotation.series[0].name, "near");
  EXPECT_EQ(rotation.series[0].points[0].x, 1.0);
  EXPECT_EQ(rotation.series[0].points[0].y, 20.0);
  EXPECT_EQ(rotation.series[0].points[1].y, 10.0);
  EXPECT_EQ(std::get<LineFigure>(figures[4].figure).y_label, "training [s]");
  // A curve that another cell has already is drawn once.
  const auto& rejection = std::get<LineFigure>(figures[5].figure);
  ASSERT_EQ(rejection.series.size(), 2U);
  EXPECT_EQ(rejection.target, 84.0);
  EXPECT_EQ(rejection.series[0].points[0].x, 50.0);
  EXPECT_EQ(rejection.series[0].points[0].y, 75.0);
  EXPECT_EQ(rejection.series[1].points[1].y, 62.5);
}

TEST(ViewStudyFigures, HasALineAcrossTheGroupsThatWerePublished) {
  ViewStudyRun run = SomeRun();
  const auto figures = ViewStudyFigures(run);
  const auto& bars = std::get<BarFigure>(figures[0].figure);
  EXPECT_THAT(bars.groups, ElementsAre("can", "all"));
  ASSERT_EQ(bars.targets.size(), 2U);
  EXPECT_TRUE(std::isnan(bars.targets[0]));
  EXPECT_EQ(bars.targets[1], 84.0);
}

TEST(ViewStudyFigures, LeavesOutBarsThatNobodyCouldTellApart) {
  ViewStudyRun run = SomeRun();
  for (ViewCellResult& result : run.results) {
    const GroupShare all = result.groups.back();
    result.groups.pop_back();
    for (int row = 0; row < 50; ++row) {
      result.answers.rows.push_back("can " + std::to_string(row));
      result.groups.push_back({.name = result.answers.rows.back()});
    }
    result.groups.push_back(all);
  }
  const auto figures = ViewStudyFigures(run);
  EXPECT_THAT(std::get<BarFigure>(figures[0].figure).groups, ElementsAre("all"));
}

TEST(ViewStudyFigures, DrawsNothingAgainstWords) {
  ViewStudyRun run = SomeRun();
  run.study.factors = {{"neighbours", {"2", "none"}}};
  EXPECT_THAT(NamesOf(ViewStudyFigures(run)), ElementsAre("right_answers", "rejection"));
}

// Figure 4.7: one histogram for objects without symmetry, one for those that half a turn brings
// back.
TEST(ViewStudyFigures, HasAHistogramOfEachKindOfSymmetry) {
  ViewStudyRun run;
  run.study.title = "Turns";
  run.study.task = ViewTask::kObjectRotation;
  run.results.push_back({.id = "one",
                         .answers = {.row_title = "object",
                                     .rows = {"drill", "can", "mug"},
                                     .columns = {"0°", "10°"},
                                     .counts = {{0, 3}, {7, 0}, {1, 2}},
                                     .kinds = {"asymmetric", "half_turn", "asymmetric"}}});
  const auto figures = ViewStudyFigures(run);
  ASSERT_THAT(
      NamesOf(figures),
      ElementsAre(
          "right_answers", "rotation_histogram_asymmetric", "rotation_histogram_half_turn"));
  const auto& asymmetric = std::get<BarFigure>(figures[1].figure);
  EXPECT_EQ(asymmetric.title, "Turns: asymmetric");
  EXPECT_EQ(asymmetric.series[0].bars[0].value, 1.0);
  EXPECT_EQ(asymmetric.series[0].bars[1].value, 5.0);
  EXPECT_EQ(std::get<BarFigure>(figures[2].figure).series[0].bars[0].value, 7.0);
}

}  // namespace
}  // namespace handcraft::experiments
