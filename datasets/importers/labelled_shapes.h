// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "datasets/formats/fault.h"
#include "lib/core/image.h"

/// Shapes of annotation tools. Their coordinates [px] begin at the corner of the picture, so that
/// the middle of the pixel (u, v) is at (u + ½, v + ½); a pixel counts by its middle.
namespace handcraft::datasets {

/// Coordinates farther out than this [px] belong to no picture; with them sums could overflow.
inline constexpr double kFarthest_px = 1e6;

/// Three corners or more; what the outline goes round an odd number of times is inside.
using Polygon = std::vector<std::array<double, 2>>;

struct Circle {
  std::array<double, 2> centre{};
  double radius = 0.0;
};

/// Pixels column after column, each from the top: as many outside as the first number says, then
/// inside, outside, and so on. The numbers add up to all pixels of the picture.
using PixelRuns = std::vector<std::uint32_t>;

/// Pixels of a row, from column `begin` to the one before `end`.
struct PixelSpan {
  int row = 0;
  int begin = 0;
  int end = 0;
};
using PixelSpans = std::vector<PixelSpan>;

using ShapeGeometry = std::variant<Polygon, Circle, PixelRuns, PixelSpans>;

struct LabelledShape {
  ShapeGeometry geometry;
  std::uint8_t value = 0;  ///< of the mask
  std::string where = {};  ///< in its file, for messages
};

/// The mask of one picture: bad everywhere, then the good shapes, then the bad ones, then what is
/// don't care, each overruling those before it, whatever their order in the list. Throws Error that
/// names `file` and the shape when a polygon or circle reaches no pixel because it lies outside the
/// picture, and std::logic_error when runs do not add up to the pixels, or spans leave the picture.
[[nodiscard]] Image DrawLabelledShapes(const std::filesystem::path& file,
                                       int width,
                                       int height,
                                       const std::vector<LabelledShape>& shapes);

/// Of those shapes a note each that covers the middle of no pixel, so that nothing is drawn of it:
/// a line, a circle of radius 0, runs without an inside. Throws as DrawLabelledShapes does.
[[nodiscard]] std::vector<Fault> NotesOnShapes(const std::filesystem::path& file,
                                               int width,
                                               int height,
                                               const std::vector<LabelledShape>& shapes);

}  // namespace handcraft::datasets
