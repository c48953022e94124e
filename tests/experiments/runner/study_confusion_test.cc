// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_confusion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/runner/small_run.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

TEST(ConfusionCountsTable, HasARowAThresholdWithIntervals) {
  StudySummary summary = SummariseStudy(testing::SmallRun(), 1);
  SeriesSummary& first = summary.series.front();
  first.by_class.back().figures.rates = {.true_positive_rate = {0.75, 0.5, 0.875},
                                         .true_negative_rate = {0.5, 0.25, 0.75}};
  first.confusion = {
      .true_positive = 3, .false_positive = 2, .true_negative = 2, .false_negative = 1};
  const ReportTable table = ConfusionCountsTable(summary);
  ASSERT_EQ(table.rows.size(), 2 * summary.series.size());
  EXPECT_THAT(table.rows[0],
              ElementsAre("laplacian, ridge = 0.5",
                          "0.5",
                          "2, 50.0 % [25.0, 75.0]",
                          "2, 50.0 % [25.0, 75.0]",
                          "1, 25.0 % [12.5, 50.0]",
                          "3, 75.0 % [50.0, 87.5]"));
  EXPECT_EQ(table.rows[1][1], "0.9");
}

TEST(LdaConfusionTable, StandsBesideTheDissertations) {
  StudyRun run = testing::SmallRun();
  EXPECT_TRUE(LdaConfusionTable(run, SummariseStudy(run, 1)).rows.empty());
  run.cells.front().settings.classifier = Classifier::kLda;
  StudySummary summary = SummariseStudy(run, 1);
  SeriesSummary& first = summary.series.front();
  first.by_class.back().figures.rates = {.true_positive_rate = {0.8, 0.7, 0.9},
                                         .true_negative_rate = {0.8, 0.75, 0.875}};
  first.confusion = {
      .true_positive = 40, .false_positive = 10, .true_negative = 40, .false_negative = 10};
  const ReportTable table = LdaConfusionTable(run, summary);
  EXPECT_THAT(table.rows[0],
              ElementsAre(StartsWith("dissertation"), "54.20", "8.14", "3.10", "34.56"));
  EXPECT_THAT(table.rows[1],
              ElementsAre("laplacian, ridge = 0.5, at its class ratio",
                          "49.87 [46.76, 54.55]",
                          "12.47 [7.79, 15.59]",
                          "7.53 [3.77, 11.30]",
                          "30.13 [26.36, 33.89]"));
  EXPECT_THAT(table.rows[2],
              ElementsAre("laplacian, ridge = 0.5, as measured",
                          "40.00 [37.50, 43.75]",
                          "10.00 [6.25, 12.50]",
                          "10.00 [5.00, 15.00]",
                          "40.00 [35.00, 45.00]"));
}

}  // namespace
}  // namespace handcraft::experiments
