// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/bar_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "experiments/runner/gnuplot.h"

namespace handcraft::experiments {
namespace {

constexpr double kGroupWidth = 0.8;  // of the distance of two groups

struct Range {
  double low = 0.0;
  double high = 0.0;
};

// A value in units of the axis.
double OnAxis(const BarFigure& figure, double value) {
  return figure.log_y ? std::log10(value) : value;
}

// Of the axis, in its units.
Range RangeOf(const BarFigure& figure) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Range range = figure.log_y ? Range{.low = kInfinity, .high = -kInfinity} : Range{};
  const auto hold = [&](double value) {
    const double end = OnAxis(figure, value);
    if (!std::isfinite(end)) return;
    range.low = std::min(range.low, end);
    range.high = std::max(range.high, end);
  };
  for (const BarFigure::Series& series : figure.series) {
    for (const Estimate& bar : series.bars) {
      for (const double end : {bar.value, bar.low, bar.high}) hold(end);
    }
  }
  for (const double target : figure.targets) hold(target);
  if (!std::isfinite(range.low)) range = {};
  if (range.low == range.high) range.high = range.low + 1.0;
  const double margin = 0.05 * (range.high - range.low);
  if (range.low < 0.0 || figure.log_y) range.low -= margin;
  range.high += margin;
  return range;
}

std::size_t ColourOf(const BarFigure& figure, std::size_t i) {
  return figure.series[i].colour.value_or(i);
}

bool HasTargets(const BarFigure& figure) {
  return std::any_of(figure.targets.begin(), figure.targets.end(), [](double target) {
    return !std::isnan(target);
  });
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
  if (HasTargets(figure)) {
    text += fmt::format(
        ", keyentry with lines {} title {}", kGnuplotTargetLine, GnuplotText(figure.target_name));
  }
  return text + "\n";
}

// A line across each group that has one. gnuplot counts groups from 0.
std::string TargetArrows(const BarFigure& figure) {
  std::string text;
  for (std::size_t k = 0; k < figure.targets.size(); ++k) {
    if (std::isnan(figure.targets[k])) continue;
    const double middle = static_cast<double>(k);
    text += fmt::format("set arrow from {0},{2} to {1},{2} nohead front {3}\n",
                        GnuplotNumber(middle - 0.5 * kGroupWidth),
                        GnuplotNumber(middle + 0.5 * kGroupWidth),
                        GnuplotNumber(figure.targets[k]),
                        kGnuplotTargetLine);
  }
  return text;
}

Tone ToneOf(std::size_t colour) {
  constexpr std::array kTones = {
      Tone::kFirst, Tone::kSecond, Tone::kThird, Tone::kQuiet, Tone::kInk};
  return kTones[colour % kTones.size()];
}

void AddBars(const BarFigure& figure, const Range& range, SvgFigure& plot) {
  const double width = kGroupWidth / static_cast<double>(figure.series.size());
  const double foot = figure.log_y ? range.low : 0.0;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Tone tone = ToneOf(ColourOf(figure, i));
    for (std::size_t k = 0; k < figure.groups.size(); ++k) {
      const Estimate& bar = figure.series[i].bars.at(k);
      const double top = OnAxis(figure, bar.value);
      if (!std::isfinite(top)) continue;
      const double left =
          static_cast<double>(k) - 0.5 * kGroupWidth + width * static_cast<double>(i);
      plot.AddBar({left, std::min(foot, top)}, {left + 0.9 * width, std::max(foot, top)}, tone);
      const double low = OnAxis(figure, bar.low);
      const double high = OnAxis(figure, bar.high);
      if (!std::isfinite(low) || !std::isfinite(high)) continue;
      plot.AddInterval(left + 0.45 * width, low, high, Tone::kInk);
    }
  }
}

void AddTargets(const BarFigure& figure, SvgFigure& plot) {
  for (std::size_t k = 0; k < figure.targets.size(); ++k) {
    if (std::isnan(figure.targets[k])) continue;
    const double height = OnAxis(figure, figure.targets[k]);
    const double middle = static_cast<double>(k);
    plot.AddLine(std::array{PlotPoint{middle - 0.5 * kGroupWidth, height},
                            PlotPoint{middle + 0.5 * kGroupWidth, height}},
                 Tone::kInk,
                 Stroke::kDashed);
  }
}

// The names of the series, and of the dashed lines, one below the other.
void AddNames(const BarFigure& figure, const Range& range, SvgFigure& plot) {
  double row = 0.97;
  const auto add = [&](const std::string& name, Tone tone) {
    plot.AddText({-0.45, range.low + row * (range.high - range.low)}, name, tone);
    row -= 0.05;
  };
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    add(figure.series[i].name, ToneOf(ColourOf(figure, i)));
  }
  if (HasTargets(figure)) add("- - " + figure.target_name, Tone::kInk);
}

// The powers of ten in the range of a logarithmic axis.
Axis VerticalAxis(const BarFigure& figure, const Range& range) {
  Axis axis{.low = range.low, .high = range.high, .label = figure.y_label};
  if (!figure.log_y) return axis;
  for (double power = std::ceil(range.low); power <= range.high; power += 1.0) {
    axis.ticks.push_back(power);
    axis.tick_labels.push_back(fmt::format("{:g}", std::pow(10.0, power)));
  }
  return axis;
}

}  // namespace

std::string GnuplotProgram(const BarFigure& figure, const std::string& name) {
  const Range range = RangeOf(figure);
  const auto end = [&](double value) { return figure.log_y ? std::pow(10.0, value) : value; };
  const std::string text =
      DataBlock(figure) +
      fmt::format(
          "set termoption noenhanced\n"
          "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n"
          "set style data histograms\nset style histogram errorbars gap 1.5 linewidth 1\n"
          "set style fill solid 0.85 noborder\nset errorbars 0.4 front linewidth 1 linecolor rgb "
          "\"#23262b\"\n"
          "{}set yrange [{}:{}]\nset grid ytics linecolor rgb \"#dddddd\"\nset xzeroaxis\n"
          "set xtics rotate by -30 noenhanced\nset key outside right top noenhanced\n",
          GnuplotText(figure.title),
          GnuplotText(figure.x_label),
          GnuplotText(figure.y_label),
          figure.log_y ? "set logscale y\n" : "",
          GnuplotNumber(end(range.low)),
          GnuplotNumber(end(range.high)));
  return text + TargetArrows(figure) + GnuplotOutputs(PlotCommand(figure), name);
}

SvgFigure PlotBars(const BarFigure& figure) {
  constexpr int kWidthPx = 900;
  constexpr int kHeightPx = 340;
  const Range range = RangeOf(figure);
  Axis x{.low = -0.5,
         .high = static_cast<double>(figure.groups.size()) - 0.5,
         .label = figure.x_label};
  for (std::size_t k = 0; k < figure.groups.size(); ++k) {
    x.ticks.push_back(static_cast<double>(k));
    x.tick_labels.push_back(figure.groups[k]);
  }
  SvgFigure plot(figure.title, std::move(x), VerticalAxis(figure, range), kWidthPx, kHeightPx);
  AddBars(figure, range, plot);
  AddTargets(figure, plot);
  AddNames(figure, range, plot);
  return plot;
}

}  // namespace handcraft::experiments
