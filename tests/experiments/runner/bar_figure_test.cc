// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/bar_figure.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

BarFigure TwoByTwo() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {.title = "A \"quoted\" title",
          .y_label = "share [%]",
          .groups = {"tea_cup", "mug"},
          .series = {{"all500", {{50, 40, 60}, {nan, nan, nan}}},
                     {"H1", {{-5, -8, 2}, {7, nan, nan}}}}};
}

TEST(GnuplotProgram, HoldsTheNumbersAndWritesBothFiles) {
  EXPECT_THAT(GnuplotProgram(TwoByTwo(), "figure"),
              AllOf(HasSubstr("\"tea_cup\" 50 40 60 -5 -8 2\n"),
                    HasSubstr("\"mug\" NaN NaN NaN 7 7 7\n"),
                    HasSubstr("set output \"figure.svg\""),
                    HasSubstr("set output \"figure.pdf\""),
                    HasSubstr("title \"H1\"")));
}

TEST(GnuplotProgram, KeepsTheNameOfASeriesWithoutBars) {
  BarFigure figure = TwoByTwo();
  figure.series[0].bars[0] = figure.series[0].bars[1];
  EXPECT_THAT(GnuplotProgram(figure, "figure"),
              HasSubstr("plot keyentry with boxes title \"all500\" linecolor rgb \"#14766f\", "
                        "$bars using 5:6:7:xtic(1) title \"H1\""));
}

TEST(GnuplotProgram, HasTheColourThatIsAskedFor) {
  BarFigure figure = TwoByTwo();
  const std::string drawn = PlotBars(figure).ToFileText();
  figure.series[1].colour = 1;
  EXPECT_EQ(PlotBars(figure).ToFileText(), drawn);
  figure.series[1].colour = 2;
  EXPECT_THAT(GnuplotProgram(figure, "figure"),
              HasSubstr("title \"H1\" linecolor rgb \"#5566a8\""));
  EXPECT_NE(PlotBars(figure).ToFileText(), drawn);
}

TEST(GnuplotProgram, LetsNoNameBecomeACommand) {
  BarFigure figure = TwoByTwo();
  figure.groups[0] = "x\"\nsystem `touch owned`";
  figure.series[0].name = "\\\"; !touch owned";
  EXPECT_THAT(
      GnuplotProgram(figure, "figure"),
      AllOf(HasSubstr("\"xsystem touch owned\" 50"), HasSubstr("title \"; !touch owned\"")));
}

TEST(GnuplotProgram, HasAnAxisWithZeroAndEveryInterval) {
  EXPECT_THAT(GnuplotProgram(TwoByTwo(), "figure"), HasSubstr("set yrange [-11.4:63.4]"));
}

TEST(GnuplotProgram, DrawsALineAcrossEachGroupThatHasATarget) {
  BarFigure figure = TwoByTwo();
  EXPECT_THAT(GnuplotProgram(figure, "figure"), Not(HasSubstr("set arrow")));
  figure.targets = {std::numeric_limits<double>::quiet_NaN(), 90.0};
  figure.target_name = "Table 4.2";
  const std::string program = GnuplotProgram(figure, "figure");
  EXPECT_THAT(program,
              AllOf(HasSubstr("set arrow from 0.6,90 to 1.4,90 nohead"),
                    HasSubstr("set yrange [-12.9:94.9]"),
                    HasSubstr("keyentry with lines linewidth 1.5 dashtype 2"),
                    HasSubstr("title \"Table 4.2\"")));
  EXPECT_THAT(program, Not(HasSubstr("set arrow from -0.4")));
  EXPECT_THAT(PlotBars(figure).ToFileText(),
              AllOf(HasSubstr("stroke-dasharray"), HasSubstr("Table 4.2")));
}

TEST(GnuplotProgram, HasPowersOfTenOnALogarithmicAxis) {
  const BarFigure figure{.title = "t",
                         .y_label = "time [ms]",
                         .groups = {"a", "b"},
                         .series = {{"one", {{0.01, 0.01, 0.01}, {1.0, 1.0, 1.0}}}},
                         .targets = {100.0, 10.0},
                         .target_name = "then",
                         .log_y = true};
  // From 10^-2 to 10^2, and a twentieth of these four decades beyond either end.
  EXPECT_THAT(GnuplotProgram(figure, "figure"),
              HasSubstr("set logscale y\nset yrange [0.00630957:158.489]"));
  const std::string text = PlotBars(figure).ToFileText();
  EXPECT_THAT(text, AllOf(HasSubstr(">0.01<"), HasSubstr(">100<"), Not(HasSubstr("nan"))));
}

TEST(PlotBars, DrawsBarsIntervalsAndNames) {
  const std::string text = PlotBars(TwoByTwo()).ToFileText();
  EXPECT_THAT(text, AllOf(HasSubstr("tea_cup"), HasSubstr("all500"), Not(HasSubstr("nan"))));
  EXPECT_EQ(PlotBars(TwoByTwo()).ToFileText(), text);
}

}  // namespace
}  // namespace handcraft::experiments
