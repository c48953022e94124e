// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/svg_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "lib/core/check.h"

namespace handcraft::experiments {
namespace {

// Space around the frame for tick labels and axis labels [px].
constexpr int kLeftPx = 58;
constexpr int kRightPx = 14;
constexpr int kTopPx = 14;
constexpr int kBottomPx = 48;
constexpr int kMaxTicks = 6;

struct ToneStyle {
  std::string_view name;
  std::string_view colour;
};

ToneStyle StyleOf(Tone tone) {
  switch (tone) {
    case Tone::kInk:
      return {"ink", "#23262b"};
    case Tone::kQuiet:
      return {"quiet", "#8b919b"};
    case Tone::kFirst:
      return {"first", "#14766f"};
    case Tone::kSecond:
      return {"second", "#c25a24"};
    case Tone::kThird:
      return {"third", "#5566a8"};
  }
  return {};
}

std::string_view NameOf(Anchor anchor) {
  switch (anchor) {
    case Anchor::kStart:
      return "start";
    case Anchor::kMiddle:
      return "middle";
    case Anchor::kEnd:
      return "end";
  }
  return {};
}

// Line-like elements take the tone as stroke, the others as fill.
std::string LineStyle(Tone tone) {
  const ToneStyle style = StyleOf(tone);
  return fmt::format(R"(class="line {}" fill="none" stroke="{}")", style.name, style.colour);
}

std::string FillStyle(std::string_view kind, Tone tone) {
  const ToneStyle style = StyleOf(tone);
  return fmt::format(R"(class="{} {}" fill="{}")", kind, style.name, style.colour);
}

std::string TickText(std::size_t index, const Axis& axis) {
  if (!axis.tick_labels.empty()) return EscapeHtml(axis.tick_labels[index]);
  const double tick = axis.ticks[index];
  // −0 and rounding dust such as 1e−17 read as 0.
  const double value = std::abs(tick) < 1e-9 * (axis.high - axis.low) ? 0.0 : tick;
  if (axis.as_percent) return fmt::format("{:g} %", 100.0 * value);
  return fmt::format("{:g}", value);
}

void CheckAxis(const Axis& axis) {
  HC_CHECK(std::isfinite(axis.low) && std::isfinite(axis.high) && axis.low < axis.high,
           axis.low,
           axis.high);
  HC_CHECK(axis.tick_labels.empty() || axis.tick_labels.size() == axis.ticks.size(),
           axis.tick_labels.size(),
           axis.ticks.size());
}

}  // namespace

std::vector<double> NiceTicks(double low, double high, int max_count) {
  HC_CHECK(std::isfinite(low) && std::isfinite(high) && low < high, low, high);
  HC_CHECK(max_count >= 2, max_count);
  double power = std::pow(10.0, std::floor(std::log10((high - low) / max_count)));
  while (true) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      const double slack = 1e-9 * step;
      const double first = std::ceil((low - slack) / step);
      const double last = std::floor((high + slack) / step);
      if (last - first + 1.0 > max_count) continue;
      std::vector<double> ticks;
      for (double k = first; k <= last; k += 1.0) ticks.push_back(k * step);
      return ticks;
    }
    power *= 10.0;
  }
}

SvgFigure::SvgFigure(std::string title, Axis x, Axis y, int width_px, int height_px)
    : title_(std::move(title)),
      x_(std::move(x)),
      y_(std::move(y)),
      width_px_(width_px),
      height_px_(height_px) {
  CheckAxis(x_);
  CheckAxis(y_);
  HC_CHECK(width_px > kLeftPx + kRightPx && height_px > kTopPx + kBottomPx, width_px, height_px);
  if (x_.ticks.empty()) x_.ticks = NiceTicks(x_.low, x_.high, kMaxTicks);
  if (y_.ticks.empty()) y_.ticks = NiceTicks(y_.low, y_.high, kMaxTicks);
}

double SvgFigure::XPx(double x) const {
  HC_CHECK(std::isfinite(x), x);
  const double share = std::clamp((x - x_.low) / (x_.high - x_.low), 0.0, 1.0);
  return kLeftPx + share * (width_px_ - kLeftPx - kRightPx);
}

double SvgFigure::YPx(double y) const {
  HC_CHECK(std::isfinite(y), y);
  const double share = std::clamp((y - y_.low) / (y_.high - y_.low), 0.0, 1.0);
  return height_px_ - kBottomPx - share * (height_px_ - kTopPx - kBottomPx);
}

std::string SvgFigure::PathOf(std::span<const PlotPoint> points) const {
  std::string path;
  for (const PlotPoint& point : points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", XPx(point.x), YPx(point.y));
  }
  return path;
}

void SvgFigure::AddLine(std::span<const PlotPoint> points, Tone tone, Stroke stroke) {
  if (points.empty()) return;
  content_ += fmt::format("<path {} stroke-width=\"{}\" stroke-linejoin=\"round\"{} d=\"{}\"/>\n",
                          LineStyle(tone),
                          stroke == Stroke::kSolid ? "2" : "1.2",
                          stroke == Stroke::kSolid ? "" : " stroke-dasharray=\"4 4\"",
                          PathOf(points));
}

void SvgFigure::AddBand(std::span<const PlotPoint> low,
                        std::span<const PlotPoint> high,
                        Tone tone) {
  if (low.empty() || high.empty()) return;
  std::vector<PlotPoint> outline(low.begin(), low.end());
  outline.insert(outline.end(), high.rbegin(), high.rend());
  content_ += fmt::format(
      "<path {} fill-opacity=\"0.2\" d=\"{} Z\"/>\n", FillStyle("band", tone), PathOf(outline));
}

void SvgFigure::AddBar(PlotPoint low, PlotPoint high, Tone tone) {
  const double left = XPx(low.x);
  const double top = YPx(high.y);
  content_ += fmt::format(
      "<rect {} fill-opacity=\"0.75\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
      "height=\"{:.1f}\"/>\n",
      FillStyle("bar", tone),
      left,
      top,
      XPx(high.x) - left,
      YPx(low.y) - top);
}

void SvgFigure::AddMarker(PlotPoint point, Tone tone) {
  content_ += fmt::format("<circle {} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\"/>\n",
                          FillStyle("marker", tone),
                          XPx(point.x),
                          YPx(point.y));
}

void SvgFigure::AddInterval(double x, double y_low, double y_high, Tone tone) {
  const double x_px = XPx(x);
  content_ += fmt::format("<path {} stroke-width=\"1.4\" d=\"M{:.1f} {:.1f} V{:.1f}\"/>\n",
                          LineStyle(tone),
                          x_px,
                          YPx(y_low),
                          YPx(y_high));
}

void SvgFigure::AddText(PlotPoint point, std::string_view text, Tone tone, Anchor anchor) {
  content_ += fmt::format("<text {} text-anchor=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                          FillStyle("note", tone),
                          NameOf(anchor),
                          XPx(point.x),
                          YPx(point.y),
                          EscapeHtml(text));
}

std::string SvgFigure::FrameText() const {
  const double left = kLeftPx;
  const double right = width_px_ - kRightPx;
  const double top = kTopPx;
  const double bottom = height_px_ - kBottomPx;
  std::string text;
  const std::string grid =
      R"(class="grid" fill="none" stroke="#8b919b" stroke-opacity="0.25" stroke-width="1")";
  const std::string label = FillStyle("tick", Tone::kQuiet);
  for (std::size_t i = 0; i < x_.ticks.size(); ++i) {
    const double x = XPx(x_.ticks[i]);
    text += fmt::format("<path {} d=\"M{:.1f} {:.1f} V{:.1f}\"/>\n", grid, x, top, bottom);
    text += fmt::format("<text {} text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                        label,
                        x,
                        bottom + 16.0,
                        TickText(i, x_));
  }
  for (std::size_t i = 0; i < y_.ticks.size(); ++i) {
    const double y = YPx(y_.ticks[i]);
    text += fmt::format("<path {} d=\"M{:.1f} {:.1f} H{:.1f}\"/>\n", grid, left, y, right);
    text += fmt::format("<text {} text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                        label,
                        left - 7.0,
                        y + 4.0,
                        TickText(i, y_));
  }
  const std::string axis_label = FillStyle("axis-label", Tone::kInk);
  text += fmt::format("<text {} text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                      axis_label,
                      0.5 * (left + right),
                      height_px_ - 10.0,
                      EscapeHtml(x_.label));
  text += fmt::format(
      "<text {} text-anchor=\"middle\" transform=\"translate(13 {:.1f}) rotate(-90)\">{}</text>\n",
      axis_label,
      0.5 * (top + bottom),
      EscapeHtml(y_.label));
  return text;
}

std::string SvgFigure::ElementText(std::string_view attributes) const {
  return fmt::format(
      "<svg{} class=\"figure\" viewBox=\"0 0 {} {}\" role=\"img\" font-family=\"system-ui, "
      "sans-serif\" font-size=\"12\">\n<title>{}</title>\n{}{}</svg>\n",
      attributes,
      width_px_,
      height_px_,
      EscapeHtml(title_),
      FrameText(),
      content_);
}

std::string SvgFigure::ToInlineText() const { return ElementText(""); }

std::string SvgFigure::ToFileText() const {
  return ElementText(fmt::format(
      R"( xmlns="http://www.w3.org/2000/svg" width="{}" height="{}")", width_px_, height_px_));
}

}  // namespace handcraft::experiments
