// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_plots.h"

#include <algorithm>
#include <cmath>

namespace handcraft::experiments {
namespace {

const std::vector<PlotPoint> kDiagonal = {{0.0, 0.0}, {1.0, 1.0}};

double ShareOf(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

// Places that no resample has reached are left out.
void AddBand(std::span<const BandPoint> band, SvgFigure& figure) {
  std::vector<PlotPoint> low;
  std::vector<PlotPoint> high;
  for (const BandPoint& point : band) {
    if (std::isnan(point.low)) continue;
    low.push_back({point.x, point.low});
    high.push_back({point.x, point.high});
  }
  figure.AddBand(low, high, Tone::kFirst);
}

}  // namespace

SvgFigure PlotRoc(const PixelCurves& curves) {
  SvgFigure figure(
      "ROC curve", {.label = "bad pixels called good"}, {.label = "good pixels found"});
  std::vector<PlotPoint> points;
  for (const RocPoint& point : curves.roc) {
    points.push_back({point.false_positive_rate, point.true_positive_rate});
  }
  figure.AddLine(kDiagonal, Tone::kQuiet, Stroke::kDashed);
  AddBand(curves.bands.roc, figure);
  figure.AddLine(points, Tone::kFirst);
  return figure;
}

SvgFigure PlotPrecisionRecall(const PixelCurves& curves) {
  SvgFigure figure("Precision-recall curve",
                   {.label = "good pixels found (recall)"},
                   {.label = "called good that are good (precision)"});
  std::vector<PlotPoint> points;
  for (const PrecisionRecallPoint& point : curves.precision_recall) {
    points.push_back({point.recall, point.precision});
  }
  AddBand(curves.bands.precision_recall, figure);
  figure.AddLine(points, Tone::kFirst);
  return figure;
}

SvgFigure PlotReliability(std::span<const ReliabilityBin> reliability) {
  SvgFigure figure("Reliability diagram",
                   {.label = "predicted probability"},
                   {.label = "share of pixels that are good"});
  figure.AddLine(kDiagonal, Tone::kQuiet, Stroke::kDashed);
  std::vector<PlotPoint> points;
  for (const ReliabilityBin& entry : reliability) {
    if (entry.bin.Total() == 0) continue;
    const Estimate& share = entry.good_share;
    points.push_back({entry.bin.mean_probability, share.value});
    if (std::isnan(share.low)) continue;
    figure.AddInterval(entry.bin.mean_probability, share.low, share.high, Tone::kThird);
  }
  figure.AddLine(points, Tone::kThird);
  for (const PlotPoint& point : points) figure.AddMarker(point, Tone::kThird);
  return figure;
}

SvgFigure PlotScoreHistogram(std::span<const ProbabilityBin> bins) {
  std::size_t num_good = 0;
  std::size_t num_bad = 0;
  for (const ProbabilityBin& bin : bins) {
    num_good += bin.num_good;
    num_bad += bin.num_bad;
  }
  double highest = 0.05;
  for (const ProbabilityBin& bin : bins) {
    highest = std::max({highest, ShareOf(bin.num_good, num_good), ShareOf(bin.num_bad, num_bad)});
  }
  SvgFigure figure(
      "Histogram of the probabilities of good and bad pixels",
      {.label = "predicted probability"},
      {.high = std::min(1.0, 1.08 * highest), .label = "share of the class", .as_percent = true});
  for (const ProbabilityBin& bin : bins) {
    const double middle = 0.5 * (bin.low + bin.high);
    const double gap = 0.08 * (bin.high - bin.low);
    figure.AddBar({bin.low + gap, 0.0}, {middle, ShareOf(bin.num_good, num_good)}, Tone::kFirst);
    figure.AddBar({middle, 0.0}, {bin.high - gap, ShareOf(bin.num_bad, num_bad)}, Tone::kSecond);
  }
  return figure;
}

SvgFigure PlotBestPixelAccuracy(const GraspPointEvaluation& evaluation) {
  constexpr int kWidthPx = 900;
  constexpr int kHeightPx = 300;
  constexpr double kHalfBar = 0.28;
  std::vector<const GroupFigures*> groups;
  for (const GroupFigures& figures : evaluation.classes) groups.push_back(&figures);
  groups.push_back(&evaluation.all);
  Axis x{.low = -0.5, .high = static_cast<double>(groups.size()) - 0.5, .label = "class"};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    x.ticks.push_back(static_cast<double>(i));
    x.tick_labels.push_back(groups[i]->name);
  }
  SvgFigure figure("Best-pixel accuracy by class",
                   std::move(x),
                   {.label = "best-pixel accuracy", .as_percent = true},
                   kWidthPx,
                   kHeightPx);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Estimate& accuracy = groups[i]->best_pixel_accuracy;
    if (std::isnan(accuracy.value)) continue;
    const auto centre = static_cast<double>(i);
    const Tone tone = i + 1 == groups.size() ? Tone::kThird : Tone::kFirst;
    figure.AddBar({centre - kHalfBar, 0.0}, {centre + kHalfBar, accuracy.value}, tone);
    if (std::isnan(accuracy.low)) continue;
    figure.AddInterval(centre, accuracy.low, accuracy.high, Tone::kInk);
  }
  return figure;
}

}  // namespace handcraft::experiments
