// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_plots.h"

#include <cmath>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/evaluation/hand_filled_evaluation.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t CountOf(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(PlotRoc, DrawsTheCurveAndTheDiagonal) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const std::string text = PlotRoc(hand.evaluation.curves).ToInlineText();
  EXPECT_EQ(CountOf(text, "class=\"line first\""), 1U);
  EXPECT_EQ(CountOf(text, "stroke-dasharray"), 1U);
  EXPECT_EQ(CountOf(text, "class=\"band first\""), 1U);
}

TEST(PlotRoc, IsAnEmptyFrameWithoutACurve) {
  EXPECT_THAT(PlotRoc({}).ToInlineText(), Not(HasSubstr("class=\"line first\"")));
}

TEST(PlotRoc, LeavesOutOfTheBandWhatNoResampleReached) {
  const double nan = std::nan("");
  const std::string text =
      PlotRoc({.bands = {.roc = {{0.0, nan, nan}, {0.5, 0.5, 0.75}, {1.0, 1.0, 1.0}}}})
          .ToInlineText();
  EXPECT_EQ(CountOf(text, "class=\"band first\""), 1U);
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(PlotPrecisionRecall, DrawsTheCurve) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const std::string text = PlotPrecisionRecall(hand.evaluation.curves).ToInlineText();
  EXPECT_EQ(CountOf(text, "class=\"line first\""), 1U);
  EXPECT_EQ(CountOf(text, "class=\"band first\""), 1U);
  EXPECT_THAT(PlotPrecisionRecall({}).ToInlineText(), Not(HasSubstr("class=\"line first\"")));
}

TEST(PlotReliability, MarksOnlyBinsThatHoldSomething) {
  const double nan = std::nan("");
  const std::vector<ReliabilityBin> bins = {
      {{0.0, 0.3, 1, 1, 0.1}, {0.5, 0.2, 0.9}},
      {{0.3, 0.6, 0, 0, nan}, {nan, nan, nan}},
      {{0.6, 1.0, 1, 0, 0.9}, {1.0, nan, nan}},
  };
  const std::string text = PlotReliability(bins).ToInlineText();
  EXPECT_EQ(CountOf(text, "<circle"), 2U);
  EXPECT_EQ(CountOf(text, "stroke-width=\"1.4\""), 1U) << "one of them has an interval";
}

TEST(PlotScoreHistogram, DrawsTwoBarsABin) {
  const std::vector<float> probabilities = {0.1F, 0.1F, 0.9F};
  const std::vector<std::uint8_t> labels = {0, 1, 1};
  const auto bins = BinProbabilities(probabilities, labels, 4);
  EXPECT_EQ(CountOf(PlotScoreHistogram(bins).ToInlineText(), "<rect"), 8U);
  EXPECT_EQ(CountOf(PlotScoreHistogram(BinProbabilities({}, {}, 4)).ToInlineText(), "<rect"), 8U);
}

TEST(PlotBestPixelAccuracy, DrawsABarAClassThatHasAnAccuracy) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const std::string text = PlotBestPixelAccuracy(hand.evaluation).ToInlineText();
  EXPECT_EQ(CountOf(text, "<rect"), 2U);  // cup and all; pen has none
  EXPECT_THAT(text, HasSubstr(">pen &lt;x&gt;</text>"));
  EXPECT_THAT(text, HasSubstr(">all</text>"));
}

}  // namespace
}  // namespace handcraft::experiments
