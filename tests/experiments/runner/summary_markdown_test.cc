// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/summary_markdown.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/runner/small_run.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string TextOf(const StudyRun& run) { return SummaryMarkdown(run, SummariseStudy(run, 1)); }

TEST(SummaryMarkdown, TellsFiguresDifferencesAndInputs) {
  EXPECT_THAT(TextOf(testing::SmallRun()),
              AllOf(StartsWith("# Rough <or> smooth\n\nWhich filter?\n"),
                    HasSubstr("| all | 6 | 80.0 % [80.0, 80.0] | 70.0 % [70.0, 70.0] |"),
                    HasSubstr("| edge, ridge = 0.5 | -10.00 [-10.00, -10.00] | -10.00 [-10.00, "
                              "-10.00] | 6 of 6 |"),
                    HasSubstr("- seed = 1\n"),
                    HasSubstr("0123abcd"),
                    Not(HasSubstr("## Warnings"))));
}

TEST(SummaryMarkdown, KeepsNamesInsideTheirColumn) {
  EXPECT_THAT(TextOf(testing::SmallRun()), HasSubstr("| pen\\|cil | 3 |"));
}

TEST(SummaryMarkdown, ShowsWhatSearchSpaceReductionLeaves) {
  StudyRun run = testing::SmallRun();
  EXPECT_THAT(TextOf(run), Not(HasSubstr("## Search space")));
  for (CellResult& result : run.results) {
    if (result.id.find("edge,ridge=2") != 0) continue;
    result.search_space = {.num_images_without_region = 1,
                           .stages = {{.stage = "region", .num_pixels = 12.0, .time_ms = 0.5}}};
  }
  EXPECT_THAT(TextOf(run),
              AllOf(HasSubstr("| edge, ridge = 2 | region | 12 | 0.50 |"),
                    HasSubstr("| edge, ridge = 2 | pictures without a region | 2 |")));
}

TEST(SummaryMarkdown, ShowsConfusionMatricesWithIntervals) {
  EXPECT_THAT(TextOf(testing::SmallRun()),
              HasSubstr("| edge, ridge = 2 | 0.9 | 0, 100.0 % [61.0, 100.0] |"));
}

TEST(SummaryMarkdown, ShowsConfusionBesideTheDissertationsForDiscriminantAnalysis) {
  StudyRun run = testing::SmallRun();
  EXPECT_THAT(TextOf(run), Not(HasSubstr("beside the dissertation")));
  run.cells.front().settings.classifier = Classifier::kLda;
  StudySummary summary = SummariseStudy(run, 1);
  summary.series.front().label = "a|b";
  EXPECT_THAT(
      SummaryMarkdown(run, summary),
      AllOf(HasSubstr("| dissertation, discriminant analysis | 54.20 | 8.14 | 3.10 | 34.56 |"),
            HasSubstr("| a\\|b, at its class ratio | 62.34 [38.01, 62.34] |")));
}

TEST(SummaryMarkdown, ShowsWarnings) {
  StudyRun run = testing::SmallRun();
  run.results[0].termination = "separated";
  EXPECT_THAT(TextOf(run), HasSubstr("## Warnings\n\n- laplacian,ridge=0.5,repetition=1"));
}

TEST(SummaryMarkdown, LeavesOutIntervalsThatOnePictureDoesNotHave) {
  StudyRun run = testing::SmallRun();
  for (CellResult& result : run.results) result.images.resize(1);
  EXPECT_THAT(TextOf(run), AllOf(HasSubstr("## Difference to"), Not(HasSubstr("nan"))));
}

TEST(VerdictText, TellsNothingOfTooFewPictures) {
  Study study = testing::SmallStudy("data");
  study.claim = Claim{"here", 5.0};
  StudySummary summary;
  const double none = std::nan("");
  summary.verdict = ClaimVerdict{.worst = "b", .loss_points = {2.0, none, none}, .holds = true};
  EXPECT_THAT(VerdictText(study, summary),
              HasSubstr("2.00 points (b): too few pictures to tell whether this holds."));
}

TEST(VerdictText, SaysWhatTheIntervalLeavesOpen) {
  Study study = testing::SmallStudy("data");
  study.claim = Claim{"here", 5.0};
  StudySummary summary;
  summary.verdict = ClaimVerdict{.worst = "b", .loss_points = {2.0, -3.0, 9.0}, .holds = true};
  EXPECT_THAT(VerdictText(study, summary),
              HasSubstr("this holds on these data, but the interval reaches beyond"));
  summary.verdict = ClaimVerdict{.worst = "b", .loss_points = {8.0, 2.0, 9.0}, .holds = false};
  EXPECT_THAT(VerdictText(study, summary), HasSubstr("but the interval holds smaller losses too"));
  summary.verdict = ClaimVerdict{.worst = "b", .loss_points = {8.0, 6.0, 9.0}, .holds = false};
  EXPECT_THAT(VerdictText(study, summary), HasSubstr("this does not hold on these data."));
}

TEST(VerdictText, SaysWhetherTheClaimHolds) {
  StudyRun run = testing::SmallRun();
  const auto verdict = [&] { return VerdictText(run.study, SummariseStudy(run, 1)); };
  EXPECT_THAT(verdict(),
              AllOf(HasSubstr("Section 9 says: no method is more than 15 points below laplacian."),
                    HasSubstr("10.00 points [10.00, 10.00] (edge, ridge = 0.5)"),
                    HasSubstr("this holds on these data")));
  run.study.claim->worst_loss_points = 3.81;
  EXPECT_THAT(verdict(), HasSubstr("this does not hold on these data"));
  run.study.claim.reset();
  EXPECT_EQ(verdict(), "");
}

}  // namespace
}  // namespace handcraft::experiments
