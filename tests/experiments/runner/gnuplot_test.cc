// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/gnuplot.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/runner/bar_figure.h"
#include "experiments/runner/line_figure.h"
#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(GnuplotText, EndsNeitherItselfNorTheLine) {
  EXPECT_EQ(GnuplotText("tea cup"), "\"tea cup\"");
  EXPECT_EQ(GnuplotText("x\"\nsystem `touch owned`\\"), "\"xsystem touch owned\"");
}

TEST(GnuplotNumber, WritesSixDigitsAndNoNumber) {
  EXPECT_EQ(GnuplotNumber(1.0 / 3.0), "0.333333");
  EXPECT_EQ(GnuplotNumber(std::numeric_limits<double>::quiet_NaN()), "NaN");
}

TEST(GnuplotColour, TellsSixSeriesApart) {
  EXPECT_EQ(GnuplotColour(0), "\"#14766f\"");
  EXPECT_NE(GnuplotColour(5), GnuplotColour(0));
  EXPECT_EQ(GnuplotColour(6), GnuplotColour(0));
}

TEST(RunGnuplot, TellsWhetherItWorked) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "bad.gnuplot", "plot nothing at all\n");
  EXPECT_FALSE(RunGnuplot(folder / "bad.gnuplot"));
  EXPECT_FALSE(RunGnuplot(folder / "missing.gnuplot"));
}

TEST(RunGnuplot, WritesSvgAndPdf) {
  const testing::TemporaryDirectory folder;
  const BarFigure bars{.title = "bars",
                       .y_label = "share",
                       .groups = {"tea_cup"},
                       .series = {{"all500", {{50, 40, 60}}}}};
  const LineFigure lines{
      .title = "lines", .x_label = "x", .y_label = "y", .series = {{"s", {{1, 2, "H1"}}}}};
  WriteFileAtomically(folder / "bars.gnuplot", GnuplotProgram(bars, "bars"));
  WriteFileAtomically(folder / "lines.gnuplot", GnuplotProgram(lines, "lines"));
  if (!RunGnuplot(folder / "bars.gnuplot")) GTEST_SKIP() << "no gnuplot here";
  ASSERT_TRUE(RunGnuplot(folder / "lines.gnuplot"));
  EXPECT_THAT(ReadTextFile(folder / "bars.svg"), HasSubstr("tea_cup"));
  EXPECT_THAT(ReadTextFile(folder / "lines.svg"), HasSubstr("H1"));
  EXPECT_THAT(ReadTextFile(folder / "lines.pdf"), StartsWith("%PDF"));
}

}  // namespace
}  // namespace handcraft::experiments
