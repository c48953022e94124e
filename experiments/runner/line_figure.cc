// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/line_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "experiments/runner/gnuplot.h"

namespace handcraft::experiments {
namespace {

constexpr double kHeadroom = 1.12;  // for the names of the points

struct Extent {
  double x = 0.0;
  double y = 0.0;
};

Extent ExtentOf(const LineFigure& figure) {
  Extent extent;
  for (const LineFigure::Series& series : figure.series) {
    for (const LineFigure::Point& point : series.points) {
      extent.x = std::max(extent.x, point.x);
      if (!std::isnan(point.y)) extent.y = std::max(extent.y, point.y);
    }
  }
  extent.y = std::max(extent.y, figure.target.value_or(0.0));
  return {extent.x > 0.0 ? kHeadroom * extent.x : 1.0, extent.y > 0.0 ? kHeadroom * extent.y : 1.0};
}

std::string DataBlocks(const LineFigure& figure) {
  std::string text;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    text += fmt::format("$series{} << END_OF_SERIES\n", i);
    for (const LineFigure::Point& point : figure.series[i].points) {
      text += fmt::format(
          "{} {} {}\n", GnuplotNumber(point.x), GnuplotNumber(point.y), GnuplotText(point.name));
    }
    text += "END_OF_SERIES\n";
  }
  return text;
}

// gnuplot crashes on labels of which none has a place.
std::string NamesOfPoints(const LineFigure::Series& series, std::size_t i) {
  const bool has_points =
      std::any_of(series.points.begin(), series.points.end(), [](const LineFigure::Point& point) {
        return !std::isnan(point.y);
      });
  if (!has_points) return {};
  return fmt::format(
      ", $series{} using 1:2:3 with labels left offset 0.6,-0.6 font \",10\" textcolor rgb {} "
      "notitle",
      i,
      GnuplotColour(i));
}

std::string PlotCommand(const LineFigure& figure) {
  std::string text = "plot ";
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    text += fmt::format(
        "{0}$series{1} using 1:2 with linespoints pointtype 7 pointsize 0.7 linewidth 2 linecolor "
        "rgb {2} title {3}{4}",
        i == 0 ? "" : ", ",
        i,
        GnuplotColour(i),
        GnuplotText(figure.series[i].name),
        NamesOfPoints(figure.series[i], i));
  }
  if (figure.target) {
    text += fmt::format("{}keyentry with lines {} title {}",
                        text.back() == ' ' ? "" : ", ",
                        kGnuplotTargetLine,
                        GnuplotText(figure.target_name));
  }
  return text + "\n";
}

std::string TargetArrow(const LineFigure& figure) {
  if (!figure.target) return {};
  return fmt::format("set arrow from graph 0,first {0} to graph 1,first {0} nohead front {1}\n",
                     GnuplotNumber(*figure.target),
                     kGnuplotTargetLine);
}

}  // namespace

std::string GnuplotProgram(const LineFigure& figure, const std::string& name) {
  const Extent extent = ExtentOf(figure);
  return DataBlocks(figure) +
         fmt::format(
             "set termoption noenhanced\n"
             "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n"
             "set xrange [0:{}]\nset yrange [0:{}]\nset grid xtics ytics linecolor rgb "
             "\"#dddddd\"\nset key outside right top noenhanced\n",
             GnuplotText(figure.title),
             GnuplotText(figure.x_label),
             GnuplotText(figure.y_label),
             GnuplotNumber(extent.x),
             GnuplotNumber(extent.y)) +
         TargetArrow(figure) + GnuplotOutputs(PlotCommand(figure), name);
}

SvgFigure PlotLines(const LineFigure& figure) {
  constexpr int kWidthPx = 900;
  constexpr int kHeightPx = 340;
  constexpr std::array kTones = {
      Tone::kFirst, Tone::kSecond, Tone::kThird, Tone::kQuiet, Tone::kInk};
  const Extent extent = ExtentOf(figure);
  SvgFigure plot(figure.title,
                 {.high = extent.x, .label = figure.x_label},
                 {.high = extent.y, .label = figure.y_label},
                 kWidthPx,
                 kHeightPx);
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Tone tone = kTones[i % kTones.size()];
    std::vector<PlotPoint> line;
    for (const LineFigure::Point& point : figure.series[i].points) {
      if (std::isnan(point.y)) continue;
      line.push_back({point.x, point.y});
      plot.AddMarker(line.back(), tone);
      plot.AddText({point.x + 0.006 * extent.x, point.y - 0.05 * extent.y}, point.name, tone);
    }
    plot.AddLine(line, tone);
    const double row = 0.95 - 0.06 * static_cast<double>(i);
    plot.AddText({0.01 * extent.x, row * extent.y}, figure.series[i].name, tone);
  }
  if (figure.target) {
    plot.AddLine(std::array{PlotPoint{0.0, *figure.target}, PlotPoint{extent.x, *figure.target}},
                 Tone::kInk,
                 Stroke::kDashed);
    plot.AddText(
        {extent.x, *figure.target + 0.01 * extent.y}, figure.target_name, Tone::kInk, Anchor::kEnd);
  }
  return plot;
}

}  // namespace handcraft::experiments
