// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/labelled_shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

// Gives `value` to the pixels of row v whose middle lies in [begin, end). Returns whether there is
// one.
bool FillSpan(Image& mask, int v, double begin, double end, std::uint8_t value) {
  const auto first_at_or_after = [&](double x) {
    return static_cast<int>(std::ceil(std::clamp(x - 0.5, 0.0, static_cast<double>(mask.width()))));
  };
  const int u_begin = first_at_or_after(begin);
  const int u_end = first_at_or_after(end);
  if (u_begin >= u_end) return false;
  std::fill(mask.Row(v) + u_begin, mask.Row(v) + u_end, value);
  return true;
}

// Rows whose middle lies in [top, bottom].
std::array<int, 2> RowsWithin(const Image& mask, double top, double bottom) {
  const double last = mask.height() - 1.0;
  return {static_cast<int>(std::ceil(std::clamp(top - 0.5, 0.0, last + 1.0))),
          static_cast<int>(std::floor(std::clamp(bottom - 0.5, -1.0, last)))};
}

// Where the outline crosses the height y, in order.
std::vector<double> Crossings(const Polygon& polygon, double y) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [x0, y0] = polygon[i];
    const auto& [x1, y1] = polygon[(i + 1) % polygon.size()];
    if ((y0 <= y) != (y1 <= y)) crossings.push_back(x0 + (y - y0) / (y1 - y0) * (x1 - x0));
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

// Each fills what its shape covers and returns whether that is any pixel.
bool Fill(Image& mask, const Polygon& polygon, std::uint8_t value) {
  if (polygon.empty()) return false;
  bool has_filled = false;
  const auto [lowest, highest] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  const auto [first, last] = RowsWithin(mask, (*lowest)[1], (*highest)[1]);
  for (int v = first; v <= last; ++v) {
    const std::vector<double> crossings = Crossings(polygon, v + 0.5);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      has_filled = FillSpan(mask, v, crossings[i], crossings[i + 1], value) || has_filled;
    }
  }
  return has_filled;
}

bool Fill(Image& mask, const Circle& circle, std::uint8_t value) {
  bool has_filled = false;
  const auto [x, y] = circle.centre;
  const auto [first, last] = RowsWithin(mask, y - circle.radius, y + circle.radius);
  for (int v = first; v <= last; ++v) {
    const double dy = v + 0.5 - y;
    const double half = std::sqrt(std::max(circle.radius * circle.radius - dy * dy, 0.0));
    has_filled = FillSpan(mask, v, x - half, x + half, value) || has_filled;
  }
  return has_filled;
}

bool Fill(Image& mask, const PixelRuns& runs, std::uint8_t value) {
  const auto num_pixels =
      static_cast<std::uint64_t>(mask.width()) * static_cast<std::uint64_t>(mask.height());
  const std::uint64_t sum = std::accumulate(runs.begin(), runs.end(), std::uint64_t{0});
  HC_CHECK(sum == num_pixels, sum, num_pixels);
  const auto height = static_cast<std::uint64_t>(mask.height());
  std::uint64_t at = 0;
  bool has_filled = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::uint64_t end = at + runs[i];
    if (i % 2 == 0) at = end;
    has_filled = has_filled || at < end;
    for (; at < end; ++at) {
      mask.At(static_cast<int>(at / height), static_cast<int>(at % height)) = value;
    }
  }
  return has_filled;
}

bool Fill(Image& mask, const PixelSpans& spans, std::uint8_t value) {
  bool has_filled = false;
  for (const PixelSpan& span : spans) {
    has_filled = has_filled || span.begin < span.end;
    HC_CHECK(span.row >= 0 && span.row < mask.height(), span.row);
    HC_CHECK(0 <= span.begin && span.begin <= span.end && span.end <= mask.width(), span.begin);
    std::fill(mask.Row(span.row) + span.begin, mask.Row(span.row) + span.end, value);
  }
  return has_filled;
}

// Whether the point lies more than a pixel beyond the picture's edge: as far as rounding can bring
// it.
bool LiesOutside(const Image& mask, const std::array<double, 2>& point) {
  const auto& [x, y] = point;
  return x < -1.0 || y < -1.0 || x > mask.width() + 1.0 || y > mask.height() + 1.0;
}

bool ReachesOut(const Image& mask, const ShapeGeometry& geometry) {
  if (const auto* const polygon = std::get_if<Polygon>(&geometry)) {
    return std::any_of(polygon->begin(), polygon->end(), [&](const auto& corner) {
      return LiesOutside(mask, corner);
    });
  }
  const auto* const circle = std::get_if<Circle>(&geometry);
  return circle != nullptr && LiesOutside(mask, circle->centre);
}

// Returns whether the shape covers a pixel.
bool Draw(const std::filesystem::path& file, const LabelledShape& shape, Image& mask) {
  const bool has_filled = std::visit(
      [&](const auto& geometry) { return Fill(mask, geometry, shape.value); }, shape.geometry);
  if (has_filled || !ReachesOut(mask, shape.geometry)) return has_filled;
  throw Error({.path = file.string(),
               .reason = shape.where + ": the shape lies outside its picture of " +
                         std::to_string(mask.width()) + "x" + std::to_string(mask.height()) +
                         " pixels",
               .remedy = "draw it where the object is, or remove it"});
}

}  // namespace

Image DrawLabelledShapes(const std::filesystem::path& file,
                         int width,
                         int height,
                         const std::vector<LabelledShape>& shapes) {
  Image mask(width, height, 1, kMaskBad);
  for (const std::uint8_t value : {kMaskGood, kMaskBad, kMaskDontCare}) {
    for (const LabelledShape& shape : shapes) {
      if (shape.value == value) Draw(file, shape, mask);
    }
  }
  return mask;
}

std::vector<Fault> NotesOnShapes(const std::filesystem::path& file,
                                 int width,
                                 int height,
                                 const std::vector<LabelledShape>& shapes) {
  Image scratch(width, height);
  std::vector<Fault> notes;
  for (const LabelledShape& shape : shapes) {
    if (Draw(file, shape, scratch)) continue;
    notes.push_back({.path = file.string(),
                     .reason = shape.where + ": the shape covers no pixel, nothing is drawn of it",
                     .gravity = Gravity::kNote,
                     .remedy = "draw it larger, or remove it"});
  }
  return notes;
}

}  // namespace handcraft::datasets
