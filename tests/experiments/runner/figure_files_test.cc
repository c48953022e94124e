// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/figure_files.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(WriteFigures, WritesProgramAndPictureOfEach) {
  const TemporaryDirectory folder;
  const BarFigure bars{.title = "One & two",
                       .y_label = "share",
                       .groups = {"a"},
                       .series = {{.name = "s", .bars = {{1.0, 0.5, 1.5}}}}};
  const std::array<NamedFigure, 1> figures = {NamedFigure{.name = "bars", .figure = bars}};
  const FigureFiles files = WriteFigures(folder / "figures", figures);
  ASSERT_EQ(files.figures.size(), 1U);
  EXPECT_EQ(files.figures[0].svg, ReadTextFile(folder / "figures/bars.svg"));
  EXPECT_EQ(ReadTextFile(folder / "figures/bars.gnuplot"), GnuplotProgram(bars, "bars"));
  EXPECT_EQ(std::filesystem::exists(folder / "figures/bars.pdf"), files.gnuplot.has_gnuplot);
  EXPECT_THAT(FigureCards(files.figures),
              AllOf(StartsWith("<figure"),
                    HasSubstr("One &amp; two"),
                    HasSubstr("data:image/svg+xml;base64,")));
}

TEST(WriteFigures, TellsOfTheFigureThatGnuplotFailsOn) {
  const TemporaryDirectory folder;
  const LineFigure empty{.title = "t", .x_label = "x", .y_label = "y", .series = {}};
  LineFigure good = empty;
  good.series = {{.name = "s", .points = {{1.0, 2.0, "p"}}}};
  const std::array figures = {NamedFigure{.name = "empty", .figure = empty},
                              NamedFigure{.name = "good", .figure = good}};
  WriteFileAtomically(folder / "empty.pdf", "of an earlier run");
  const FigureFiles files = WriteFigures(folder.path(), figures);
  EXPECT_EQ(files.figures[0].svg, PlotLines(empty).ToFileText());
  EXPECT_FALSE(std::filesystem::exists(folder / "empty.pdf"));
  if (!files.gnuplot.has_gnuplot) GTEST_SKIP() << "no gnuplot here";
  EXPECT_THAT(files.gnuplot.failed, ElementsAre("empty"));
  EXPECT_TRUE(std::filesystem::exists(folder / "good.pdf"));
}

}  // namespace
}  // namespace handcraft::experiments
