// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/line_figure.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

LineFigure TwoLines() {
  return {.title = "Time",
          .x_label = "number of features",
          .y_label = "time [ms]",
          .series = {{"one", {{54, 1.5, "H3"}, {500, 8.0, "all\"500"}}},
                     {"two", {{54, std::numeric_limits<double>::quiet_NaN(), "H3"}}}}};
}

TEST(GnuplotProgram, DrawsLinesThroughNamedPoints) {
  EXPECT_THAT(GnuplotProgram(TwoLines(), "time"),
              AllOf(HasSubstr("$series0 << END_OF_SERIES\n54 1.5 \"H3\"\n500 8 \"all500\"\n"),
                    HasSubstr("$series1 << END_OF_SERIES\n54 NaN \"H3\"\n"),
                    HasSubstr("set xrange [0:560]\nset yrange [0:8.96]"),
                    HasSubstr("set xlabel \"number of features\""),
                    HasSubstr("title \"two\"\n"),
                    HasSubstr("set output \"time.pdf\"")));
}

TEST(GnuplotProgram, DrawsALineAtWhatWasAimedAt) {
  LineFigure figure = TwoLines();
  EXPECT_THAT(GnuplotProgram(figure, "time"), Not(HasSubstr("set arrow")));
  figure.target = 10.0;
  figure.target_name = "Table 4.5";
  EXPECT_THAT(GnuplotProgram(figure, "time"),
              AllOf(HasSubstr("set arrow from graph 0,first 10 to graph 1,first 10 nohead"),
                    HasSubstr("set yrange [0:11.2]"),
                    HasSubstr("title \"Table 4.5\"")));
  EXPECT_THAT(PlotLines(figure).ToFileText(),
              AllOf(HasSubstr("stroke-dasharray"), HasSubstr("Table 4.5")));
}

TEST(PlotLines, LeavesOutWhatWasNotMeasured) {
  const std::string text = PlotLines(TwoLines()).ToFileText();
  EXPECT_THAT(text, AllOf(HasSubstr("H3"), HasSubstr(">two<"), Not(HasSubstr("nan"))));
  EXPECT_EQ(PlotLines(TwoLines()).ToFileText(), text);
}

TEST(PlotLines, DrawsTheFrameOfNothing) {
  EXPECT_THAT(PlotLines({.title = "t", .x_label = "x", .y_label = "y", .series = {}}).ToFileText(),
              HasSubstr("<title>t</title>"));
}

}  // namespace
}  // namespace handcraft::experiments
