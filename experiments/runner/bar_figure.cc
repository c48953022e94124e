// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/bar_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "experiments/runner/gnuplot.h"

namespace handcraft::experiments {
namespace {

constexpr double kGroupWidth = 0.8;  // of the distance of two groups

struct Range {
  double low = 0.0;
  double high = 0.0;
};

Range RangeOf(const BarFigure& figure) {
  Range range;
  for (const BarFigure::Series& series : figure.series) {
    for (const Estimate& bar : series.bars) {
      for (const double end : {bar.value, bar.low, bar.high}) {
        if (std::isnan(end)) continue;
        range.low = std::min(range.low, end);
        range.high = std::max(range.high, end);
      }
    }
  }
  if (range.low == range.high) range.high = 1.0;
  const double margin = 0.05 * (range.high - range.low);
  if (range.low < 0.0) range.low -= margin;
  range.high += margin;
  return range;
}

std::size_t ColourOf(const BarFigure& figure, std::size_t i) {
  return figure.series[i].colour.value_or(i);
}

bool HasBars(const BarFigure::Series& series) {
  return std::any_of(series.bars.begin(), series.bars.end(), [](const Estimate& bar) {
    return !std::isnan(bar.value);
  });
}

// gnuplot leaves out a bar with an end that is NaN: a bar without an interval ends at its value.
std::string BarText(const Estimate& bar) {
  return fmt::format(" {} {} {}",
                     GnuplotNumber(bar.value),
                     GnuplotNumber(std::isnan(bar.low) ? bar.value : bar.low),
                     GnuplotNumber(std::isnan(bar.high) ? bar.value : bar.high));
}

std::string DataBlock(const BarFigure& figure) {
  std::string text = "$bars << END_OF_BARS\n";
  for (std::size_t k = 0; k < figure.groups.size(); ++k) {
    text += GnuplotText(figure.groups[k]);
    for (const BarFigure::Series& series : figure.series) {
      text += BarText(series.bars.at(k));
    }
    text += "\n";
  }
  return text + "END_OF_BARS\n";
}

// A histogram of NaN alone stops gnuplot: such a series is an entry of the key, and where there is
// no other, points without size bring the axis and the names of the groups.
std::string PlotCommand(const BarFigure& figure) {
  std::string text = "plot ";
  if (std::none_of(figure.series.begin(), figure.series.end(), HasBars)) {
    text += "$bars using 0:(0):xtic(1) with points pointsize 0 notitle";
  }
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const std::size_t column = 2 + 3 * i;
    if (text.back() != ' ') text += ", ";
    text += HasBars(figure.series[i])
                ? fmt::format("$bars using {}:{}:{}:xtic(1)", column, column + 1, column + 2)
                : "keyentry with boxes";
    text += fmt::format(" title {} linecolor rgb {}",
                        GnuplotText(figure.series[i].name),
                        GnuplotColour(ColourOf(figure, i)));
  }
  return text + "\n";
}

void AddBars(const BarFigure& figure, SvgFigure& plot) {
  constexpr std::array kTones = {
      Tone::kFirst, Tone::kSecond, Tone::kThird, Tone::kQuiet, Tone::kInk};
  const double width = kGroupWidth / static_cast<double>(figure.series.size());
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Tone tone = kTones[ColourOf(figure, i) % kTones.size()];
    for (std::size_t k = 0; k < figure.groups.size(); ++k) {
      const Estimate& bar = figure.series[i].bars.at(k);
      if (std::isnan(bar.value)) continue;
      const double left =
          static_cast<double>(k) - 0.5 * kGroupWidth + width * static_cast<double>(i);
      plot.AddBar(
          {left, std::min(0.0, bar.value)}, {left + 0.9 * width, std::max(0.0, bar.value)}, tone);
      if (std::isnan(bar.low) || std::isnan(bar.high)) continue;
      plot.AddInterval(left + 0.45 * width, bar.low, bar.high, Tone::kInk);
    }
    const double row = 0.97 - 0.05 * static_cast<double>(i);
    const Range range = RangeOf(figure);
    plot.AddText({-0.45, range.low + row * (range.high - range.low)}, figure.series[i].name, tone);
  }
}

}  // namespace

std::string GnuplotProgram(const BarFigure& figure, const std::string& name) {
  const Range range = RangeOf(figure);
  const std::string text =
      DataBlock(figure) +
      fmt::format(
          "set termoption noenhanced\n"
          "set title {} noenhanced\nset ylabel {} noenhanced\n"
          "set style data histograms\nset style histogram errorbars gap 1.5 linewidth 1\n"
          "set style fill solid 0.85 noborder\nset errorbars 0.4 front linewidth 1 linecolor rgb "
          "\"#23262b\"\n"
          "set yrange [{}:{}]\nset grid ytics linecolor rgb \"#dddddd\"\nset xzeroaxis\n"
          "set xtics rotate by -30 noenhanced\nset key outside right top noenhanced\n",
          GnuplotText(figure.title),
          GnuplotText(figure.y_label),
          GnuplotNumber(range.low),
          GnuplotNumber(range.high));
  return text + GnuplotOutputs(PlotCommand(figure), name);
}

SvgFigure PlotBars(const BarFigure& figure) {
  constexpr int kWidthPx = 900;
  constexpr int kHeightPx = 340;
  const Range range = RangeOf(figure);
  Axis x{.low = -0.5, .high = static_cast<double>(figure.groups.size()) - 0.5};
  for (std::size_t k = 0; k < figure.groups.size(); ++k) {
    x.ticks.push_back(static_cast<double>(k));
    x.tick_labels.push_back(figure.groups[k]);
  }
  SvgFigure plot(figure.title,
                 std::move(x),
                 {.low = range.low, .high = range.high, .label = figure.y_label},
                 kWidthPx,
                 kHeightPx);
  AddBars(figure, plot);
  return plot;
}

}  // namespace handcraft::experiments
