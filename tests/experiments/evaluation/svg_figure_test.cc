// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/svg_figure.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(NiceTicks, AreRoundNumbersByHand) {
  EXPECT_THAT(NiceTicks(0.0, 10.0, 6), ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
  EXPECT_THAT(NiceTicks(-3.0, 3.0, 4), ElementsAre(-2.0, 0.0, 2.0));
  EXPECT_EQ(NiceTicks(0.0, 1.0, 6).size(), 6U);
}

TEST(NiceTicks, StayInsideAndBelowTheWantedNumber) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const double low = 100.0 * rng.Normal();
    const double high = low + std::pow(10.0, 6.0 * rng.Uniform() - 3.0);
    const int max_count = 2 + static_cast<int>(rng.UniformInt(9));
    const std::vector<double> ticks = NiceTicks(low, high, max_count);
    EXPECT_LE(ticks.size(), static_cast<std::size_t>(max_count));
    EXPECT_GE(ticks.size(), 1U) << low << ' ' << high;
    for (const double tick : ticks) {
      EXPECT_GE(tick, low - 1e-6 * (high - low));
      EXPECT_LE(tick, high + 1e-6 * (high - low));
    }
  }
}

TEST(NiceTicks, RefuseAnEmptyRange) {
  EXPECT_THROWS_MESSAGE(NiceTicks(1.0, 1.0, 5), std::logic_error, HasSubstr("low < high"));
  EXPECT_THROWS_MESSAGE(NiceTicks(0.0, 1.0, 1), std::logic_error, HasSubstr("max_count"));
  EXPECT_THROWS_MESSAGE(NiceTicks(0.0, std::numeric_limits<double>::infinity(), 5),
                        std::logic_error,
                        HasSubstr("inf"));
}

// The frame of a 158 × 162 px figure runs from (58, 114) to (144, 14) px.
SvgFigure UnitFigure() { return {"Unit", {}, {}, 158, 162}; }

TEST(SvgFigure, MapsDataToPixelsByHand) {
  SvgFigure figure = UnitFigure();
  figure.AddMarker({0.5, 0.25}, Tone::kFirst);
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(R"(cx="101.0" cy="89.0")"));
  figure.AddLine(std::vector<PlotPoint>{{0.0, 0.0}, {1.0, 1.0}}, Tone::kSecond);
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(R"(d="M58.0 114.0 L144.0 14.0")"));
  figure.AddBar({0.0, 0.0}, {0.5, 1.0}, Tone::kThird);
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(R"(x="58.0" y="14.0" width="43.0" height="100.0")"));
  figure.AddInterval(0.5, 0.0, 0.5, Tone::kInk);
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(R"(d="M101.0 114.0 V64.0")"));
  figure.AddBand(std::vector<PlotPoint>{{0.0, 0.5}, {1.0, 0.5}},
                 std::vector<PlotPoint>{{0.0, 1.0}, {1.0, 0.75}},
                 Tone::kFirst);
  EXPECT_THAT(figure.ToInlineText(),
              HasSubstr(R"(d="M58.0 64.0 L144.0 64.0 L144.0 39.0 L58.0 14.0 Z")"));
}

TEST(SvgFigure, KeepsPointsInsideTheFrame) {
  SvgFigure figure = UnitFigure();
  figure.AddMarker({7.0, -3.0}, Tone::kFirst);
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(R"(cx="144.0" cy="114.0")"));
}

TEST(SvgFigure, LabelsTicks) {
  const SvgFigure figure("", {.high = 0.5, .as_percent = true}, {.ticks = {0.1, 0.2}});
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(">50 %</text>"));
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(">0.2</text>"));
  const SvgFigure named("", {.ticks = {0.0, 1.0}, .tick_labels = {"mug", "cup & saucer"}}, {});
  EXPECT_THAT(named.ToInlineText(), HasSubstr(">cup &amp; saucer</text>"));
}

TEST(SvgFigure, InlineTextRefersToNothingOutside) {
  SvgFigure figure = UnitFigure();
  figure.AddText({0.1, 0.1}, "note", Tone::kInk, Anchor::kEnd);
  EXPECT_THAT(figure.ToInlineText(), Not(HasSubstr("http")));
  EXPECT_THAT(figure.ToInlineText(), HasSubstr(R"(text-anchor="end")"));
  EXPECT_THAT(figure.ToFileText(), HasSubstr(R"(xmlns="http://www.w3.org/2000/svg")"));
}

TEST(SvgFigure, EscapesTexts) {
  SvgFigure figure("<b>", {.label = "a < b"}, {.label = "\"q\""});
  figure.AddText({0.5, 0.5}, "<script>", Tone::kInk);
  EXPECT_THAT(figure.ToInlineText(), HasSubstr("<title>&lt;b&gt;</title>"));
  EXPECT_THAT(figure.ToInlineText(), HasSubstr("a &lt; b"));
  EXPECT_THAT(figure.ToInlineText(), HasSubstr("&quot;q&quot;"));
  EXPECT_THAT(figure.ToInlineText(), Not(HasSubstr("<script>")));
}

TEST(SvgFigure, DrawsNothingForNoPoints) {
  SvgFigure figure = UnitFigure();
  const std::string before = figure.ToInlineText();
  figure.AddLine({}, Tone::kFirst);
  figure.AddBand({}, {}, Tone::kFirst);
  EXPECT_EQ(figure.ToInlineText(), before);
}

TEST(SvgFigure, RefusesWhatCannotBeDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SvgFigure figure = UnitFigure();
  EXPECT_THROWS_MESSAGE(figure.AddMarker({nan, 0.0}, Tone::kInk), std::logic_error, HasSubstr("x"));
  EXPECT_THROWS_MESSAGE(figure.AddMarker({0.0, nan}, Tone::kInk), std::logic_error, HasSubstr("y"));
  EXPECT_THROWS_MESSAGE(SvgFigure("", {.low = 2.0}, {}), std::logic_error, HasSubstr("2, 1"));
  EXPECT_THROWS_MESSAGE(
      SvgFigure("", {}, {}, 50, 50), std::logic_error, HasSubstr("width_px, height_px"));
  EXPECT_THROWS_MESSAGE(SvgFigure("", {.ticks = {0.0}, .tick_labels = {"a", "b"}}, {}),
                        std::logic_error,
                        HasSubstr("2, 1"));
}

}  // namespace
}  // namespace handcraft::experiments
