// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_figures.h"

#include <gtest/gtest.h>

#include "tests/experiments/runner/small_run.h"

namespace handcraft::experiments {
namespace {

TEST(FiguresOf, ShowsLevelsAndDifferencesInPercent) {
  const StudyRun run = testing::SmallRun();
  const std::vector<NamedFigure> figures = FiguresOf(run, SummariseStudy(run, 1));
  ASSERT_EQ(figures.size(), 4U);
  EXPECT_EQ(figures[0].name, "best_pixel_accuracy");
  const auto& accuracy = std::get<BarFigure>(figures[0].figure);
  ASSERT_EQ(accuracy.series.size(), 4U);
  ASSERT_EQ(accuracy.groups.size(), 3U);
  EXPECT_NEAR(accuracy.series[2].bars[2].value, 70.0, 1e-9);
  const auto& difference = std::get<BarFigure>(figures[1].figure);
  ASSERT_EQ(difference.series.size(), 2U);
  EXPECT_EQ(difference.series[0].name, "edge, ridge = 0.5");
  EXPECT_NEAR(difference.series[0].bars[0].value, -10.0, 1e-9);
  EXPECT_EQ(difference.series[0].colour, 2U) << "as in the other figure";
  EXPECT_EQ(accuracy.series[2].name, difference.series[0].name);
}

TEST(FiguresOf, ShowsMeanTimesAgainstTheNumberOfFeatures) {
  StudyRun run = testing::SmallRun();
  for (std::size_t i = 0; i < 4; ++i) run.results[i].num_features = 500;  // of "laplacian"
  run.results[0].score_time_ms = 4.0;
  run.results[1].score_time_ms = 8.0;
  const std::vector<NamedFigure> figures = FiguresOf(run, SummariseStudy(run, 1));
  const auto& lines = std::get<LineFigure>(figures[2].figure);
  EXPECT_EQ(lines.x_label, "number of features");
  ASSERT_EQ(lines.series.size(), 2U) << "one a ridge";
  EXPECT_EQ(lines.series[0].name, "1 filter, ridge = 0.5");
  ASSERT_EQ(lines.series[0].points.size(), 2U);
  EXPECT_EQ(lines.series[0].points[0].name, "edge") << "fewest features first";
  EXPECT_EQ(lines.series[0].points[1].x, 500.0);
  EXPECT_EQ(lines.series[0].points[1].y, 6.0);
}

TEST(FiguresOf, TellsClassifiersAndRegionsApart) {
  StudyRun run = testing::SmallRun();
  run.results[0].num_features = 500;
  for (std::size_t i = 4; i < 8; ++i) run.cells[i].settings.classifier = Classifier::kLda;
  for (std::size_t i = 2; i < 4; ++i) run.cells[i].settings.region = TestRegion::kObject;
  const std::vector<NamedFigure> figures = FiguresOf(run, SummariseStudy(run, 1));
  const auto& lines = std::get<LineFigure>(figures[3].figure);
  ASSERT_EQ(lines.series.size(), 4U);
  EXPECT_EQ(lines.series[1].name, "1 filter, region R, ridge = 2");
  EXPECT_EQ(lines.series[2].name, "1 filter, LDA, ridge = 0.5");
}

// All methods of the small run have one feature.
TEST(FiguresOf, ShowsMeanTimesAsBarsWithoutFeaturesToCompare) {
  StudyRun run = testing::SmallRun();
  run.results[0].score_time_ms = 4.0;
  run.results[1].score_time_ms = 8.0;
  run.results[7].training_time_s = 3.0;
  const std::vector<NamedFigure> figures = FiguresOf(run, SummariseStudy(run, 1));
  EXPECT_EQ(figures[2].name, "score_time");
  const auto& scoring = std::get<BarFigure>(figures[2].figure);
  EXPECT_EQ(scoring.groups[0], "laplacian, ridge = 0.5 (1 features)");
  EXPECT_EQ(scoring.series[0].bars[0].value, 6.0);
  EXPECT_EQ(std::get<BarFigure>(figures[3].figure).series[0].bars[3].value, 1.5);
}

TEST(FiguresOf, ShowsNoDifferencesOfOneMethod) {
  StudyRun run = testing::SmallRun();
  run.study.methods.resize(1);
  run.cells.resize(4);
  run.results.resize(4);
  EXPECT_EQ(FiguresOf(run, SummariseStudy(run, 1)).size(), 3U);
}

}  // namespace
}  // namespace handcraft::experiments
