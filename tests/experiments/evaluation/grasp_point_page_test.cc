// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/evaluation/hand_filled_evaluation.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ReportContents MakeContents() {
  ReportContents contents{.model_name = "edges54 <b>",
                          .data_name = "cups & pens",
                          .model_facts = {{"Licence", "BSD & <i>free</i>"}}};
  contents.pictures = {{"cup/1.png", "cup", {2, 1, 0}, {'f'}, {'o'}, {'x'}},
                       {"<script>", "pen", {0, 0, 1}, {'f'}, {'o'}, {'x'}},
                       {"none.png", "pen", {0, 0, 0}, {'f'}, {'o'}, {}}};
  return contents;
}

TEST(MakeGraspPointPage, ShowsFiguresAndPictures) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const std::string page = MakeGraspPointPage(hand.evaluation, MakeContents());
  EXPECT_THAT(page, HasSubstr("Of the 3 best pixels on labelled ground, 2 lie where"));
  EXPECT_THAT(page, HasSubstr("1 more on don’t-care ground is not counted."));
  EXPECT_THAT(page, HasSubstr("66.7 %"));  // best pixels
  EXPECT_THAT(page, HasSubstr("57.1 %"));  // pixels
  EXPECT_THAT(page, HasSubstr("<h3>ROC curve, area 0.750"));
  EXPECT_THAT(page, HasSubstr("<span class=\"count\">1</span><span class=\"share\">33.3 %"));
  EXPECT_THAT(page, HasSubstr("2 of 3 good"));
  EXPECT_THAT(page, HasSubstr("1 on don’t-care ground"));
  EXPECT_THAT(page, HasSubstr("no pixel above 0.9"));
  EXPECT_THAT(page, HasSubstr("src=\"data:image/jpeg;base64,Zg==\""));
  EXPECT_THAT(page, HasSubstr("Close-up of the best pixels of cup/1.png"));
  EXPECT_THAT(page, Not(HasSubstr("Close-up of the best pixels of none.png")));
  EXPECT_THAT(page, Not(HasSubstr("Shown are")));
}

TEST(MakeGraspPointPage, EscapesWhatComesFromData) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const std::string page = MakeGraspPointPage(hand.evaluation, MakeContents());
  EXPECT_THAT(page, HasSubstr("edges54 &lt;b&gt;"));
  EXPECT_THAT(page, HasSubstr("cups &amp; pens"));
  EXPECT_THAT(page, HasSubstr("BSD &amp; &lt;i&gt;free"));
  EXPECT_THAT(page, HasSubstr("pen &lt;x&gt;"));
  for (const char* raw : {"<script", "edges54 <b>", "pen <x>", "<i>free"}) {
    EXPECT_THAT(page, Not(HasSubstr(raw)));
  }
}

TEST(MakeGraspPointPage, NeedsNothingFromOutside) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const std::string page = MakeGraspPointPage(hand.evaluation, MakeContents());
  for (const char* outside : {"http", "<link", "@import", "url(", "file:"}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
}

TEST(MakeGraspPointPage, SaysWhenNotAllImagesAreShown) {
  const auto hand = testing::MakeHandFilledEvaluation();
  ReportContents contents = MakeContents();
  contents.pictures.pop_back();
  EXPECT_THAT(MakeGraspPointPage(hand.evaluation, contents), HasSubstr("Shown are 2 of 3 images"));
}

TEST(MakeGraspPointPage, StandsWithoutAnyFigure) {
  GraspPointEvaluation nothing;
  FormFigures({}, nothing);
  const std::string page = MakeGraspPointPage(nothing, {.model_name = "m", .data_name = "d"});
  EXPECT_THAT(page, HasSubstr("No best pixel lies on labelled ground."));
  EXPECT_THAT(page, HasSubstr("–"));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace handcraft::experiments
