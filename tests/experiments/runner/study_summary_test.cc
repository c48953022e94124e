// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_summary.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/runner/small_run.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(SummariseStudy, PutsRepetitionsTogether) {
  const StudySummary summary = SummariseStudy(testing::SmallRun(), 1);
  EXPECT_THAT(summary.classes, ElementsAre("mug <blue>", "pen|cil", "all"));
  ASSERT_EQ(summary.series.size(), 4U);
  EXPECT_EQ(summary.series[0].label, "laplacian, ridge = 0.5");
  EXPECT_EQ(summary.series[3].label, "edge, ridge = 2");
  EXPECT_THAT(summary.series[1].cells, ElementsAre(2, 3));
  EXPECT_EQ(summary.series[0].confusion.true_positive, 10U);
  EXPECT_DOUBLE_EQ(summary.series[0].auc.value, 0.75);
  EXPECT_EQ(summary.series[0].by_class[1].figures.num_images, 3U);
  EXPECT_NEAR(summary.series[3].by_class[2].figures.best_pixel_accuracy.value, 0.6, 1e-12);
}

TEST(SummariseStudy, AveragesIntervalsAndAddsUpMatrices) {
  StudyRun run = testing::SmallRun();
  run.results[0].groups.back().auc = {0.75, 0.7, 0.9};
  run.results[1].groups.back().auc = {0.85, 0.6, 1.0};
  run.results[0].groups.back().strict_confusion = {.true_positive = 2, .false_negative = 1};
  run.results[1].groups.back().strict_confusion = {.true_positive = 3};
  const SeriesSummary series = SummariseStudy(run, 1).series[0];
  EXPECT_DOUBLE_EQ(series.auc.value, 0.8);
  EXPECT_DOUBLE_EQ(series.auc.low, 0.65);
  EXPECT_DOUBLE_EQ(series.auc.high, 0.95);
  EXPECT_EQ(series.strict_confusion.true_positive, 5U);
  EXPECT_EQ(series.strict_confusion.false_negative, 1U);
  const PooledFigures& figures = series.by_class.back().figures;
  EXPECT_DOUBLE_EQ(figures.rates.true_positive_rate.value, 0.8);
  EXPECT_EQ(figures.rates.true_negative_rate.value, 1.0);
  EXPECT_DOUBLE_EQ(figures.strict_rates.true_positive_rate.value, 0.5);
}

TEST(SummariseStudy, ComparesWithTheBaselineOfTheSameFactors) {
  const StudySummary summary = SummariseStudy(testing::SmallRun(), 1);
  EXPECT_FALSE(summary.series[0].by_class[2].difference);
  EXPECT_FALSE(summary.series[1].by_class[2].difference);
  for (const std::size_t edge : {2U, 3U}) {
    const auto& difference = summary.series[edge].by_class[2].difference;
    ASSERT_TRUE(difference);
    EXPECT_NEAR(difference->best_pixel_accuracy.value, -0.1, 1e-12);
  }
}

TEST(SummariseStudy, JudgesTheClaim) {
  StudyRun run = testing::SmallRun();
  StudySummary summary = SummariseStudy(run, 1);
  ASSERT_TRUE(summary.verdict);
  EXPECT_NEAR(summary.verdict->loss_points.value, 10.0, 1e-9);
  EXPECT_TRUE(summary.verdict->holds);
  run.study.claim->worst_loss_points = 9.0;
  EXPECT_FALSE(SummariseStudy(run, 1).verdict->holds);
  run.study.claim.reset();
  EXPECT_FALSE(SummariseStudy(run, 1).verdict);
}

TEST(SummariseStudy, WarnsWhereALossCannotBeTold) {
  StudyRun run = testing::SmallRun();
  for (CellResult& result : run.results) {
    if (result.id.find("edge,ridge=2") != 0) continue;
    for (ImageFigures& image : result.images) image.best = {};
  }
  EXPECT_THAT(SummariseStudy(run, 1).warnings,
              ElementsAre(HasSubstr("edge, ridge = 2: no best pixel")));
}

TEST(SummariseStudy, WarnsOfTrainingWithoutOptimum) {
  StudyRun run = testing::SmallRun();
  EXPECT_TRUE(SummariseStudy(run, 1).warnings.empty());
  run.results[5].termination = "separated";
  EXPECT_THAT(SummariseStudy(run, 1).warnings, ElementsAre(HasSubstr("ended as separated")));
}

TEST(SummariseStudy, GivesTheSameForAnyNumberOfThreads) {
  StudyRun run = testing::SmallRun();
  run.results[4].images[2].best.good = 1;
  const StudySummary one = SummariseStudy(run, 1);
  const StudySummary three = SummariseStudy(run, 3);
  for (std::size_t i = 0; i < one.series.size(); ++i) {
    for (std::size_t k = 0; k < one.classes.size(); ++k) {
      const Estimate& ours = one.series[i].by_class[k].figures.best_pixel_accuracy;
      const Estimate& theirs = three.series[i].by_class[k].figures.best_pixel_accuracy;
      EXPECT_EQ(ours.low, theirs.low);
      EXPECT_EQ(ours.high, theirs.high);
    }
  }
}

}  // namespace
}  // namespace handcraft::experiments
