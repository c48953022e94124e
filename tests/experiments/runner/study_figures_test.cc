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
  ASSERT_EQ(figures[0].figure.series.size(), 4U);
  ASSERT_EQ(figures[0].figure.groups.size(), 3U);
  EXPECT_NEAR(figures[0].figure.series[2].bars[2].value, 70.0, 1e-9);
  ASSERT_EQ(figures[1].figure.series.size(), 2U);
  EXPECT_EQ(figures[1].figure.series[0].name, "edge, ridge = 0.5");
  EXPECT_NEAR(figures[1].figure.series[0].bars[0].value, -10.0, 1e-9);
}

TEST(FiguresOf, ShowsMeanTimes) {
  StudyRun run = testing::SmallRun();
  run.results[0].score_time_ms = 4.0;
  run.results[1].score_time_ms = 8.0;
  run.results[7].training_time_s = 3.0;
  const std::vector<NamedFigure> figures = FiguresOf(run, SummariseStudy(run, 1));
  EXPECT_EQ(figures[2].name, "score_time");
  EXPECT_EQ(figures[2].figure.groups[0], "laplacian, ridge = 0.5 (1 features)");
  EXPECT_EQ(figures[2].figure.series[0].bars[0].value, 6.0);
  EXPECT_EQ(figures[3].figure.series[0].bars[3].value, 1.5);
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
