// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/html_text.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(BreakableHtml, BreaksAfterLowLinesAndCommas) {
  EXPECT_EQ(BreakableHtml("moved_copies,C=1"), "moved_<wbr>copies,<wbr>C=1");
  EXPECT_EQ(BreakableHtml("a<b_"), "a&lt;b_<wbr>");
}

TEST(EscapeHtml, WritesTheFiveSpecialCharactersAsEntities) {
  EXPECT_EQ(EscapeHtml(R"(<a href="x">R&D's</a>)"),
            "&lt;a href=&quot;x&quot;&gt;R&amp;D&#39;s&lt;/a&gt;");
  EXPECT_EQ(EscapeHtml("Grüße"), "Grüße");
  EXPECT_EQ(EscapeHtml(""), "");
}

// Test vectors of RFC 4648, section 10.
TEST(Base64, AgreesWithTheStandard) {
  const auto encode = [](std::string_view text) {
    return Base64(std::vector<std::uint8_t>(text.begin(), text.end()));
  };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foob"), "Zm9vYg==");
  EXPECT_EQ(encode("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Base64(std::vector<std::uint8_t>{0xFB, 0xFF, 0xBF}), "+/+/");
}

TEST(DataUri, NamesTheMediaType) {
  EXPECT_EQ(DataUri("image/png", std::vector<std::uint8_t>{'f'}), "data:image/png;base64,Zg==");
}

TEST(DecimalEstimateText, LeavesOutTheIntervalThatIsNot) {
  EXPECT_EQ(DecimalEstimateText({0.8612, 0.84, 0.88}, 3), "0.861 [0.840, 0.880]");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(DecimalEstimateText({0.5, nan, nan}, 3), "0.500");
}

TEST(NumberTexts, RoundAndMarkWhatIsUndefined) {
  EXPECT_EQ(PercentText(0.81251), "81.3 %");
  EXPECT_EQ(PercentText(kNaN), "–");
  EXPECT_EQ(PercentIntervalText({0.8, 0.72, 0.881}), "[72.0, 88.1]");
  EXPECT_EQ(PercentIntervalText({0.8, kNaN, 0.9}), "");
  EXPECT_EQ(DecimalText(0.95678, 3), "0.957");
  EXPECT_EQ(DecimalText(kNaN, 3), "–");
  EXPECT_EQ(DecimalIntervalText({0.9, 0.85, 0.95}, 2), "[0.85, 0.95]");
  EXPECT_EQ(DecimalIntervalText({0.9, 0.85, kNaN}, 2), "");
}

TEST(MakeHtmlPage, IsWholeAndNeedsNothingFromOutside) {
  const std::string page = MakeHtmlPage("a < b", "<p>text</p>\n");
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("<title>a &lt; b</title>"));
  EXPECT_THAT(page, HasSubstr("<p>text</p>"));
  for (const char* outside : {"http:", "https:", "<script", "<link", "@import", "url("}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
}

}  // namespace
}  // namespace handcraft::experiments
