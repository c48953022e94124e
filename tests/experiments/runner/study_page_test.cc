// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/runner/small_run.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string Page(const std::vector<Example>& examples) {
  const StudyRun run = testing::SmallRun();
  return MakeStudyPage(run, SummariseStudy(run, 1), {{"A figure", "<svg></svg>"}}, examples);
}

TEST(MakeStudyPage, HoldsTablesFiguresAndVerdict) {
  EXPECT_THAT(Page({}),
              AllOf(HasSubstr("Which filter?"),
                    HasSubstr("this holds on these data"),
                    HasSubstr("80.0 %<span class=\"range\">[80.0, 80.0]"),
                    HasSubstr("-10.00<span class=\"range\">[-10.00, -10.00]"),
                    HasSubstr("data:image/svg+xml;base64,"),
                    HasSubstr("<h2>edge, ridge = 2</h2>"),
                    HasSubstr("<h3>ROC curve, area 0.750 [0.000, 0.000]</h3>"),
                    HasSubstr("called good<br>(above 0.9)"),
                    HasSubstr("<h3>Reliability, Brier score"),
                    HasSubstr("<dt>split</dt><dd>instance</dd>")));
}

TEST(MakeStudyPage, LeavesOutIntervalsThatOnePictureDoesNotHave) {
  StudyRun run = testing::SmallRun();
  for (CellResult& result : run.results) result.images.resize(1);
  const std::string page = MakeStudyPage(run, SummariseStudy(run, 1), {}, {});
  EXPECT_THAT(page, HasSubstr("log-loss"));
  EXPECT_THAT(page, Not(HasSubstr("nan,")));
}

TEST(MakeStudyPage, ShowsWhatSearchSpaceReductionLeaves) {
  StudyRun run = testing::SmallRun();
  run.results[0].search_space = {.num_images_without_region = 3,
                                 .stages = {{.stage = "crop", .num_pixels = 80.0}}};
  EXPECT_THAT(MakeStudyPage(run, SummariseStudy(run, 1), {}, {}),
              AllOf(HasSubstr("<h2>Search space</h2>"),
                    HasSubstr("<td>crop</td><td class=\"number\">40</td>"),
                    HasSubstr("<td>pictures without a region</td><td class=\"number\">3</td>")));
  EXPECT_THAT(Page({}), Not(HasSubstr("<h2>Search space</h2>")));
}

TEST(MakeStudyPage, ShowsConfusionBesideTheDissertationsForDiscriminantAnalysis) {
  EXPECT_THAT(Page({}), Not(HasSubstr("beside the dissertation")));
  StudyRun run = testing::SmallRun();
  run.cells.front().settings.classifier = Classifier::kLda;
  EXPECT_THAT(MakeStudyPage(run, SummariseStudy(run, 1), {}, {}),
              AllOf(HasSubstr("<h2>Confusion matrices beside the dissertation</h2>"),
                    HasSubstr(">54.20</td>"),
                    HasSubstr("edge,<wbr> ridge = 2,<wbr> at its class ratio</th>")));
}

TEST(MakeStudyPage, LoadsNothingFromOutsideAndEscapesNames) {
  const std::string page = Page({{.image = "<p>",
                                  .object_class = "a&b",
                                  .labels_jpeg = {1},
                                  .overlays = {{.label = "x<y", .best = {2, 1}, .jpeg = {2}}}}});
  EXPECT_THAT(page,
              AllOf(HasSubstr("Rough &lt;or&gt; smooth"),
                    HasSubstr("mug &lt;blue&gt;"),
                    HasSubstr("&lt;p&gt;"),
                    HasSubstr("x&lt;y"),
                    HasSubstr("2 of 3 good"),
                    Not(HasSubstr("<script")),
                    Not(HasSubstr("src=\"http"))));
}

}  // namespace
}  // namespace handcraft::experiments
