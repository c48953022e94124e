// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/grasp_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::datasets {
namespace {

struct Vector {
  double x = 0.0;
  double y = 0.0;
};

Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
double Cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

double SquaredDistanceToSegment(Vector p, Vector from, Vector to) {
  const Vector edge = to - from;
  const double along = std::clamp(Dot(p - from, edge) / Dot(edge, edge), 0.0, 1.0);
  const Vector gap = p - Vector{from.x + along * edge.x, from.y + along * edge.y};
  return Dot(gap, gap);
}

// A rectangle as p = centre + s · opening + t · closing, −1 ≤ s, t ≤ 1 (half edges).
struct Shape {
  Vector centre, opening, closing;

  explicit Shape(const GraspRectangle& corners) {
    const auto corner = [&](std::size_t i) { return Vector{corners[i][0], corners[i][1]}; };
    const Vector p0 = corner(0);
    const Vector p1 = corner(1);
    const Vector p2 = corner(2);
    const Vector p3 = corner(3);
    centre = {(p0.x + p1.x + p2.x + p3.x) / 4, (p0.y + p1.y + p2.y + p3.y) / 4};
    opening = {(p1.x - p0.x + p2.x - p3.x) / 4, (p1.y - p0.y + p2.y - p3.y) / 4};
    closing = {(p2.x - p1.x + p3.x - p0.x) / 4, (p2.y - p1.y + p3.y - p0.y) / 4};
  }

  [[nodiscard]] double Area_px2() const { return 4 * std::abs(Cross(opening, closing)); }

  [[nodiscard]] Vector Corner(double s, double t) const {
    return {centre.x + s * opening.x + t * closing.x, centre.y + s * opening.y + t * closing.y};
  }

  // Inside the central share of the opening and the whole of the other edge.
  [[nodiscard]] bool Contains(Vector p, double share) const {
    const double determinant = Cross(opening, closing);
    const double s = Cross(p - centre, closing) / determinant;
    const double t = Cross(opening, p - centre) / determinant;
    // Corners come with two decimals: a pixel on the very edge is inside.
    constexpr double kRounding = 1e-9;
    return std::abs(s) <= share + kRounding && std::abs(t) <= 1.0 + kRounding;
  }

  [[nodiscard]] bool IsNearer(Vector p, double distance) const {
    if (Contains(p, 1.0)) return distance > 0.0;
    double nearest = SquaredDistanceToSegment(p, Corner(-1, -1), Corner(1, -1));
    nearest = std::min(nearest, SquaredDistanceToSegment(p, Corner(1, -1), Corner(1, 1)));
    nearest = std::min(nearest, SquaredDistanceToSegment(p, Corner(1, 1), Corner(-1, 1)));
    nearest = std::min(nearest, SquaredDistanceToSegment(p, Corner(-1, 1), Corner(-1, -1)));
    return nearest < distance * distance;
  }
};

// Gives `value` to the pixels that `covers`, none of them farther than `reach` from the shape.
template <class Predicate>
void Paint(Image& mask, const Shape& shape, double reach, std::uint8_t value, Predicate covers) {
  const double half_width = std::abs(shape.opening.x) + std::abs(shape.closing.x) + reach;
  const double half_height = std::abs(shape.opening.y) + std::abs(shape.closing.y) + reach;
  const auto first = [](double x) { return static_cast<int>(std::ceil(std::max(x, 0.0))); };
  const auto last = [](double x, int size) {
    return static_cast<int>(std::floor(std::clamp(x, -1.0, size - 1.0)));
  };
  const int u_end = last(shape.centre.x + half_width, mask.width());
  const int v_end = last(shape.centre.y + half_height, mask.height());
  for (int v = first(shape.centre.y - half_height); v <= v_end; ++v) {
    for (int u = first(shape.centre.x - half_width); u <= u_end; ++u) {
      if (covers(Vector{static_cast<double>(u), static_cast<double>(v)})) mask.At(u, v) = value;
    }
  }
}

std::vector<Shape> ToShapes(const std::vector<GraspRectangle>& rectangles) {
  std::vector<Shape> shapes(rectangles.begin(), rectangles.end());
  for (const Shape& shape : shapes) HC_CHECK(shape.Area_px2() > 0.0, shape.Area_px2());
  return shapes;
}

}  // namespace

double RectangleArea(const GraspRectangle& rectangle) { return Shape(rectangle).Area_px2(); }

void RequireWithinPicture(const std::filesystem::path& file,
                          const std::vector<GraspRectangle>& rectangles,
                          int width,
                          int height) {
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const auto lies_beyond = [&](const auto& is_beyond) {
      return std::all_of(rectangles[i].begin(), rectangles[i].end(), is_beyond);
    };
    const bool is_outside = lies_beyond([](const auto& at) { return at[0] < 0.0; }) ||
                            lies_beyond([](const auto& at) { return at[1] < 0.0; }) ||
                            lies_beyond([&](const auto& at) { return at[0] > width; }) ||
                            lies_beyond([&](const auto& at) { return at[1] > height; });
    if (!is_outside) continue;
    throw Error({.path = file.string(),
                 .reason = "rectangle " + std::to_string(i + 1) + " lies outside its picture of " +
                           std::to_string(width) + "x" + std::to_string(height) + " pixels",
                 .remedy = "remove it"});
  }
}

void GraspMaskOptions::Validate() const {
  RequireOption(good_share > 0.0 && good_share <= 1.0,
                "GraspMaskOptions.good_share",
                good_share,
                "in (0, 1]");
  RequireOption(dont_care_margin_px >= 0,
                "GraspMaskOptions.dont_care_margin_px",
                dont_care_margin_px,
                "0 or more");
}

Image MakeGraspMask(int width,
                    int height,
                    const std::vector<GraspRectangle>& positive,
                    const std::vector<GraspRectangle>& negative,
                    const GraspMaskOptions& options) {
  Image mask(width, height, 1, kMaskBad);
  const std::vector<Shape> grasps = ToShapes(positive);
  const double margin = options.dont_care_margin_px;
  for (const Shape& grasp : grasps) {
    Paint(mask, grasp, margin, kMaskDontCare, [&](Vector p) { return grasp.IsNearer(p, margin); });
  }
  for (const Shape& refused : ToShapes(negative)) {
    Paint(mask, refused, 0.0, kMaskBad, [&](Vector p) { return refused.Contains(p, 1.0); });
  }
  for (const Shape& grasp : grasps) {
    Paint(mask, grasp, 0.0, kMaskDontCare, [&](Vector p) { return grasp.Contains(p, 1.0); });
  }
  for (const Shape& grasp : grasps) {
    Paint(mask, grasp, 0.0, kMaskGood, [&](Vector p) {
      return grasp.Contains(p, options.good_share);
    });
  }
  return mask;
}

}  // namespace handcraft::datasets
