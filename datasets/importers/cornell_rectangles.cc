// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell_rectangles.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

constexpr std::string_view kBlanks = " \t\r";

// Takes one number off the front of `line`.
std::optional<double> TakeNumber(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  double value = 0.0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
  if (error != std::errc()) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return value;
}

std::array<double, 2> ParseCorner(const std::filesystem::path& path,
                                  std::size_t line_number,
                                  std::string_view line) {
  constexpr double kFarthest_px = 1e6;
  std::string_view rest = line;
  const std::optional<double> x = TakeNumber(rest);
  const std::optional<double> y = TakeNumber(rest);
  const auto is_absurd = [](double value) { return std::abs(value) > kFarthest_px; };
  const bool ends = rest.find_first_not_of(kBlanks) == std::string_view::npos;
  if (!x || !y || !ends || is_absurd(*x) || is_absurd(*y)) {
    throw Error({.path = path.string(),
                 .line = line_number,
                 .reason = "'" + std::string(line.substr(0, 40)) +
                           "' where a corner \"x y\" in pixels is due"});
  }
  return {*x, *y};
}

bool IsUsable(const GraspRectangle& corners) {
  constexpr double kSmallest_px2 = 1.0;
  return RectangleArea(corners) >= kSmallest_px2;  // false for NaN
}

}  // namespace

std::vector<GraspRectangle> ReadCornellRectangles(const std::filesystem::path& path) {
  const std::string text = ReadTextFile(path);
  std::vector<GraspRectangle> rectangles;
  GraspRectangle corners{};
  std::size_t num_corners = 0;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size(); ++line_number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    if (line.find_first_not_of(kBlanks) == std::string_view::npos) continue;
    corners[num_corners % 4] = ParseCorner(path, line_number + 1, line);
    ++num_corners;
    if (num_corners % 4 == 0 && IsUsable(corners)) rectangles.push_back(corners);
  }
  if (num_corners % 4 != 0) {
    throw Error({.path = path.string(),
                 .line = line_number,
                 .reason = std::to_string(num_corners) +
                           " corners; a rectangle has four, so a multiple of four is due"});
  }
  return rectangles;
}

}  // namespace handcraft::datasets
