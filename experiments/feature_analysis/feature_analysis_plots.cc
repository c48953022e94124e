// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_plots.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace handcraft::experiments {
namespace {

using features::Filter;

constexpr int kWideWidthPx = 900;
constexpr std::size_t kMaxEigenvalues = 100;
constexpr double kRounding = 1e-12;

Tone ToneOf(FeatureScaling scaling) {
  switch (scaling) {
    case FeatureScaling::kRaw:
      return Tone::kFirst;
    case FeatureScaling::kPrintedMasks:
      return Tone::kSecond;
    case FeatureScaling::kStandard:
      return Tone::kThird;
  }
  return Tone::kInk;
}

// Edge masks, Laws masks, what the dissertation added; colours are quiet.
Tone ToneOf(Filter filter) {
  if (filter <= Filter::kLawsSS) return Tone::kThird;
  if (filter <= Filter::kEdge150) return Tone::kFirst;
  return filter <= Filter::kLaplacian ? Tone::kSecond : Tone::kQuiet;
}

// log10 of the eigenvalues over the largest, as far as they are no rounding.
std::vector<PlotPoint> SpectrumPoints(const EnergySpectrum& spectrum) {
  std::vector<PlotPoint> points;
  for (std::size_t k = 0; k < std::min(kMaxEigenvalues, spectrum.eigenvalues.size()); ++k) {
    const double ratio = spectrum.eigenvalues[k] / spectrum.eigenvalues[0];
    if (ratio < kRounding) break;
    points.push_back({static_cast<double>(k + 1), std::log10(ratio)});
  }
  return points;
}

std::string FilterName(const FeatureAnalysis& analysis, std::size_t filter) {
  return std::string(features::NameOf(analysis.options.spec.filters[filter]));
}

}  // namespace

std::string TitleOf(FeatureScaling scaling) {
  switch (scaling) {
    case FeatureScaling::kRaw:
      return "raw features";
    case FeatureScaling::kPrintedMasks:
      return "edge masks as printed";
    case FeatureScaling::kStandard:
      return "standardised features";
  }
  return "";
}

std::vector<std::size_t> RanksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] > values[b];
  });
  std::vector<std::size_t> ranks(values.size());
  for (std::size_t place = 0; place < order.size(); ++place) ranks[order[place]] = place + 1;
  return ranks;
}

std::vector<std::size_t> UsefulnessRanks(const BackwardElimination& elimination) {
  const std::size_t count = elimination.order.size();
  std::vector<std::size_t> ranks(count);
  for (std::size_t place = 0; place < count; ++place) {
    ranks[elimination.order[place]] = count - place;
  }
  return ranks;
}

SvgFigure PlotEigenvalues(const std::vector<EnergySpectrum>& spectra) {
  double lowest = -1.0;
  double most = 2.0;
  for (const EnergySpectrum& spectrum : spectra) {
    for (const PlotPoint& point : SpectrumPoints(spectrum)) {
      lowest = std::min(lowest, std::floor(point.y));
      most = std::max(most, point.x);
    }
  }
  Axis y{.low = lowest, .high = 0.0, .label = "eigenvalue over the largest"};
  const double step = lowest < -6.0 ? 2.0 : 1.0;
  for (double power = 0.0; power >= lowest; power -= step) {
    y.ticks.push_back(power);
    y.tick_labels.push_back(power == 0.0 ? "1" : fmt::format("1e{:.0f}", power));
  }
  SvgFigure figure("Spectrum of the covariance (dissertation, Figure 3.2)",
                   {.low = 1.0, .high = most, .label = "component"},
                   y,
                   kWideWidthPx,
                   360);
  double height = 0.0;
  for (const EnergySpectrum& spectrum : spectra) {
    const std::vector<PlotPoint> points = SpectrumPoints(spectrum);
    figure.AddLine(points, ToneOf(spectrum.scaling));
    if (points.size() == 1) figure.AddMarker(points.front(), ToneOf(spectrum.scaling));
    height -= 0.06 * -lowest;
    figure.AddText(
        {most, height}, TitleOf(spectrum.scaling), ToneOf(spectrum.scaling), Anchor::kEnd);
  }
  return figure;
}

SvgFigure PlotFirstComponent(const EnergySpectrum& spectrum, const features::FeatureSpec& spec) {
  const std::vector<double>& component = spectrum.first_component;
  double largest = 0.0;
  double lowest = 0.0;
  for (const double entry : component) largest = std::max(largest, std::abs(entry));
  for (const double entry : component) lowest = std::min(lowest, entry / largest);
  Axis x{.low = 0.0,
         .high = static_cast<double>(component.size()),
         .label = fmt::format("feature (a grid line every {}: the filters at one pixel)",
                              spec.filters.size())};
  const std::size_t num_positions = component.size() / spec.filters.size();
  for (std::size_t position = 0; position <= num_positions; ++position) {
    const std::size_t feature = position * spec.filters.size();
    x.ticks.push_back(static_cast<double>(feature));
    x.tick_labels.push_back(position % 5 == 0 || num_positions <= 10 ? std::to_string(feature)
                                                                     : "");
  }
  SvgFigure figure(
      fmt::format("First eigenvector, {} (dissertation, Figure 3.3)", TitleOf(spectrum.scaling)),
      x,
      {.low = lowest < -0.02 ? -1.0 : 0.0, .high = 1.0, .label = "entry over the largest"},
      kWideWidthPx,
      280);
  for (std::size_t j = 0; j < component.size(); ++j) {
    const double entry = component[j] / largest;
    const auto left = static_cast<double>(j);
    figure.AddBar({left + 0.1, std::min(0.0, entry)},
                  {left + 0.9, std::max(0.0, entry)},
                  ToneOf(spec.filters[j % spec.filters.size()]));
  }
  return figure;
}

SvgFigure PlotRankings(const FeatureAnalysis& analysis) {
  const std::size_t num_filters = analysis.options.spec.filters.size();
  std::vector<std::vector<std::size_t>> columns;
  Axis x{.low = -0.75, .high = 0.75, .label = "left: energy; right: what the classifier loses"};
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    x.tick_labels.push_back(TitleOf(spectrum.scaling));
    columns.push_back(RanksOf(spectrum.filter_shares));
  }
  x.tick_labels.emplace_back("usefulness");
  columns.push_back(UsefulnessRanks(analysis.elimination));
  x.high += static_cast<double>(columns.size() - 1);
  for (std::size_t c = 0; c < columns.size(); ++c) x.ticks.push_back(static_cast<double>(c));
  Axis y{.low = -static_cast<double>(num_filters) - 0.6, .high = -0.4, .label = "rank"};
  for (std::size_t rank = 1; rank <= num_filters; ++rank) {
    y.ticks.push_back(-static_cast<double>(rank));
    y.tick_labels.push_back(std::to_string(rank));
  }
  SvgFigure figure("Filters ranked by energy and by usefulness",
                   x,
                   y,
                   kWideWidthPx,
                   90 + 22 * static_cast<int>(num_filters));
  for (std::size_t f = 0; f < num_filters; ++f) {
    const Tone tone = ToneOf(analysis.options.spec.filters[f]);
    std::vector<PlotPoint> points;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      points.push_back({static_cast<double>(c), -static_cast<double>(columns[c][f])});
    }
    figure.AddLine(points, tone);
    for (const PlotPoint& point : points) figure.AddMarker(point, tone);
    const std::string name = FilterName(analysis, f);
    figure.AddText({points.front().x - 0.06, points.front().y - 0.15}, name, tone, Anchor::kEnd);
    figure.AddText({points.back().x + 0.06, points.back().y - 0.15}, name, tone, Anchor::kStart);
  }
  return figure;
}

SvgFigure PlotElimination(const FeatureAnalysis& analysis) {
  const BackwardElimination& elimination = analysis.elimination;
  const auto num_filters = static_cast<double>(elimination.order.size());
  const double all = elimination.all.log_loss;
  double low = all;
  double high = all;
  std::vector<PlotPoint> points = {{num_filters, all}};
  for (const EliminationStep& step : elimination.steps) {
    points.push_back({points.back().x - 1.0, step.log_loss});
    for (const double bound : {step.increase.low, step.increase.high}) {
      if (std::isnan(bound)) continue;
      low = std::min(low, all + bound);
      high = std::max(high, all + bound);
    }
    low = std::min(low, step.log_loss);
    high = std::max(high, step.log_loss);
  }
  const double margin = 0.05 * (high - low) + 1e-6;
  low = std::max(low, margin);  // a paired interval may reach below 0, the log-loss cannot
  SvgFigure figure("Held-out log-loss as filters go",
                   {.low = 0.5, .high = num_filters + 0.5, .label = "filters left"},
                   {.low = low - margin, .high = high + margin, .label = "held-out log-loss"},
                   kWideWidthPx,
                   320);
  const std::vector<PlotPoint> level = {{0.5, all}, {num_filters + 0.5, all}};
  figure.AddLine(level, Tone::kQuiet, Stroke::kDashed);
  figure.AddLine(points, Tone::kFirst);
  figure.AddMarker(points.front(), Tone::kFirst);
  for (std::size_t s = 0; s < elimination.steps.size(); ++s) {
    const Estimate& increase = elimination.steps[s].increase;
    if (!std::isnan(increase.low) && !std::isnan(increase.high)) {
      figure.AddInterval(points[s + 1].x, all + increase.low, all + increase.high, Tone::kFirst);
    }
    figure.AddMarker(points[s + 1], Tone::kFirst);
  }
  return figure;
}

}  // namespace handcraft::experiments
