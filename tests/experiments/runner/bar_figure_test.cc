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

TEST(PlotBars, DrawsBarsIntervalsAndNames) {
  const std::string text = PlotBars(TwoByTwo()).ToFileText();
  EXPECT_THAT(text, AllOf(HasSubstr("tea_cup"), HasSubstr("all500"), Not(HasSubstr("nan"))));
  EXPECT_EQ(PlotBars(TwoByTwo()).ToFileText(), text);
}

}  // namespace
}  // namespace handcraft::experiments
