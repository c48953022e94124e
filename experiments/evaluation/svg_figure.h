// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handcraft::experiments {

/// A point in the units of the axes.
struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A straight axis from low to high > low.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::string label = {};
  std::vector<double> ticks = {};             ///< empty: NiceTicks
  std::vector<std::string> tick_labels = {};  ///< one a tick; empty: the numbers
  bool as_percent = false;                    ///< write 0.2 as "20 %"
};

/// Round numbers (1, 2 or 5 times a power of ten apart) in [low, high], at most max_count ≥ 2 of
/// them. Throws std::logic_error unless low < high and both are finite.
[[nodiscard]] std::vector<double> NiceTicks(double low, double high, int max_count);

/// The colours of a figure. They are written as attributes (light background) and as class names,
/// so that a page's style sheet may change them for a dark one.
enum class Tone { kInk, kQuiet, kFirst, kSecond, kThird };
enum class Stroke { kSolid, kDashed };
enum class Anchor { kStart, kMiddle, kEnd };

/// A figure with two axes as SVG text: no script, no font file, no reference to anything outside.
///
/// Things are drawn in the order they are added; coordinates beyond the axes are moved to the
/// edge of the frame. Every Add function throws std::logic_error on coordinates that are not
/// finite. Same calls, same bytes.
class SvgFigure {
 public:
  /// `title` is read out by screen readers and shown by browsers under the pointer.
  SvgFigure(std::string title, Axis x, Axis y, int width_px = 420, int height_px = 330);

  void AddLine(std::span<const PlotPoint> points, Tone tone, Stroke stroke = Stroke::kSolid);
  /// Fills between two lines, such as the ends of intervals.
  void AddBand(std::span<const PlotPoint> low, std::span<const PlotPoint> high, Tone tone);
  /// A bar between two corners.
  void AddBar(PlotPoint low, PlotPoint high, Tone tone);
  void AddMarker(PlotPoint point, Tone tone);
  /// A vertical bar from y_low to y_high, for an interval.
  void AddInterval(double x, double y_low, double y_high, Tone tone);
  void AddText(PlotPoint point, std::string_view text, Tone tone, Anchor anchor = Anchor::kStart);

  /// For a page: the element alone, which a page may style.
  [[nodiscard]] std::string ToInlineText() const;
  /// For a file of its own, with the XML name space.
  [[nodiscard]] std::string ToFileText() const;

 private:
  [[nodiscard]] double XPx(double x) const;
  [[nodiscard]] double YPx(double y) const;
  [[nodiscard]] std::string PathOf(std::span<const PlotPoint> points) const;
  [[nodiscard]] std::string FrameText() const;
  [[nodiscard]] std::string ElementText(std::string_view attributes) const;

  std::string title_;
  Axis x_;
  Axis y_;
  int width_px_;
  int height_px_;
  std::string content_;
};

}  // namespace handcraft::experiments
