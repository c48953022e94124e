// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/gnuplot.h"

#include <array>
#include <cstdlib>
#include <limits>
#include <string>

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

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(GnuplotText, EndsNeitherItselfNorTheLine) {
  EXPECT_EQ(GnuplotText("tea cup"), "\"tea cup\"");
  EXPECT_EQ(GnuplotText("x\"\nsystem `touch owned`\\"), "\"xsystem touch owned\"");
}

TEST(GnuplotNumber, WritesSixDigitsAndNoNumber) {
  EXPECT_EQ(GnuplotNumber(1.0 / 3.0), "0.333333");
  EXPECT_EQ(GnuplotNumber(kNaN), "NaN");
}

TEST(GnuplotColour, TellsEightSeriesApart) {
  EXPECT_EQ(GnuplotColour(0), "\"#14766f\"");
  EXPECT_NE(GnuplotColour(7), GnuplotColour(0));
  EXPECT_EQ(GnuplotColour(8), GnuplotColour(0));
}

TEST(RunGnuplot, TellsWhetherItWorked) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "bad.gnuplot", "plot nothing at all\n");
  EXPECT_NE(RunGnuplot(folder / "bad.gnuplot"), GnuplotOutcome::kDone);
  EXPECT_EQ(RunGnuplot(folder / "bad.gnuplot"), RunGnuplot(folder / "missing.gnuplot"));
  EXPECT_EQ(RunGnuplot(folder / "no folder" / "a.gnuplot"), GnuplotOutcome::kFailed);
}

TEST(RunGnuplot, TellsThatThereIsNone) {
  const testing::TemporaryDirectory folder;
  const std::string path = std::getenv("PATH");
  ASSERT_EQ(::setenv("PATH", folder.path().c_str(), 1), 0);
  const GnuplotOutcome outcome = RunGnuplot(folder / "bars.gnuplot");
  ASSERT_EQ(::setenv("PATH", path.c_str(), 1), 0);
  EXPECT_EQ(outcome, GnuplotOutcome::kNoGnuplot);
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
  if (RunGnuplot(folder / "bars.gnuplot") == GnuplotOutcome::kNoGnuplot) {
    GTEST_SKIP() << "no gnuplot here";
  }
  ASSERT_EQ(RunGnuplot(folder / "lines.gnuplot"), GnuplotOutcome::kDone);
  EXPECT_THAT(ReadTextFile(folder / "bars.svg"), HasSubstr("tea_cup"));
  EXPECT_THAT(ReadTextFile(folder / "lines.svg"), HasSubstr("H1"));
  EXPECT_THAT(ReadTextFile(folder / "lines.pdf"), StartsWith("%PDF"));
}

// What gnuplot 5.4 refuses, or crashes on, as it stands.
TEST(RunGnuplot, DrawsFiguresWhereNothingWasMeasured) {
  const testing::TemporaryDirectory folder;
  const Estimate none{kNaN, kNaN, kNaN};
  const Estimate bare{5.0, kNaN, kNaN};
  const auto bars = [](Estimate first, Estimate second) {
    return BarFigure{.title = "bars",
                     .y_label = "share",
                     .groups = {"tea_cup", "mug"},
                     .series = {{"one", {first, first}}, {"two", {second, second}}}};
  };
  const LineFigure lines{.title = "lines",
                         .x_label = "x",
                         .y_label = "y",
                         .series = {{"one", {{1, kNaN, "H1"}}}, {"two", {{1, 2, "H2"}}}}};
  const LineFigure empty{
      .title = "lines", .x_label = "x", .y_label = "y", .series = {{"one", {{1, kNaN, "H1"}}}}};
  const std::array programs = {GnuplotProgram(bars(none, bare), "f"),
                               GnuplotProgram(bars(bare, none), "f"),
                               GnuplotProgram(bars(none, none), "f"),
                               GnuplotProgram(lines, "f"),
                               GnuplotProgram(empty, "f")};
  for (const std::string& program : programs) {
    WriteFileAtomically(folder / "f.gnuplot", program);
    const GnuplotOutcome outcome = RunGnuplot(folder / "f.gnuplot");
    if (outcome == GnuplotOutcome::kNoGnuplot) GTEST_SKIP() << "no gnuplot here";
    EXPECT_EQ(outcome, GnuplotOutcome::kDone) << program;
    EXPECT_THAT(ReadTextFile(folder / "f.svg"), HasSubstr("one")) << program;
  }
}

}  // namespace
}  // namespace handcraft::experiments
