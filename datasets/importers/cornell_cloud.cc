// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell_cloud.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

constexpr float kMillimetre_m = 0.001F;

// The lines of a file, one after the other.
class Lines {
 public:
  Lines(const std::filesystem::path& path, std::string_view text) : path_(path), rest_(text) {}

  // The next line without its end; nothing at the end of the file.
  [[nodiscard]] std::optional<std::string_view> Next() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
  }
  [[noreturn]] void Fail(const std::string& reason) const {
    throw Error({.path = path_.string(),
                 .line = std::max<std::size_t>(number_, 1),
                 .reason = reason,
                 .remedy = "take the file as the data has it"});
  }

 private:
  const std::filesystem::path& path_;
  std::string_view rest_;
  std::size_t number_ = 0;
};

template <class T>
std::optional<T> TakeNumber(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  T value{};
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
  if (error != std::errc()) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return value;
}

// The number of points that the header ends with.
std::size_t ReadHeader(Lines& lines) {
  constexpr std::string_view kFields = "FIELDS x y z rgb index";
  constexpr std::string_view kPoints = "POINTS ";
  bool has_fields = false;
  std::optional<std::size_t> num_points;
  while (const std::optional<std::string_view> line = lines.Next()) {
    if (line->starts_with("FIELDS")) has_fields = *line == kFields;
    if (line->starts_with(kPoints)) {
      std::string_view number = line->substr(kPoints.size());
      num_points = TakeNumber<std::size_t>(number);
    }
    if (!line->starts_with("DATA")) continue;
    if (*line != "DATA ascii")
      lines.Fail("'" + std::string(line->substr(0, 40)) + "'; text is due");
    if (!has_fields) lines.Fail("no line '" + std::string(kFields) + "' before the points");
    if (!num_points) lines.Fail("no line 'POINTS' with a number before the points");
    return *num_points;
  }
  lines.Fail("no line 'DATA ascii': not a cloud of the Cornell data");
}

// The point of a line, and its pixel.
std::pair<std::size_t, Eigen::Vector3f> ReadPoint(const Lines& lines, std::string_view line) {
  std::array<float, 4> numbers{};  // x, y, z, rgb
  std::string_view rest = line;
  for (float& number : numbers) {
    const std::optional<float> value = TakeNumber<float>(rest);
    if (!value)
      lines.Fail("'" + std::string(line.substr(0, 40)) + "' where x y z rgb index is due");
    number = *value;
  }
  const std::optional<std::size_t> pixel = TakeNumber<std::size_t>(rest);
  if (!pixel || !rest.empty()) {
    lines.Fail("'" + std::string(line.substr(0, 40)) + "' where x y z rgb index is due");
  }
  const Eigen::Vector3f point(numbers[0], numbers[1], numbers[2]);
  return {*pixel, point * kMillimetre_m};
}

}  // namespace

OrganisedCloud ReadCornellCloud(const std::filesystem::path& path, int width, int height) {
  const std::string text = ReadTextFile(path);
  Lines lines(path, text);
  const std::size_t num_points = ReadHeader(lines);
  const auto num_pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const Eigen::Vector3f nothing =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  OrganisedCloud cloud{.width = width,
                       .height = height,
                       .points = std::vector<Eigen::Vector3f>(num_pixels, nothing)};
  std::vector<bool> is_taken(num_pixels);
  std::size_t count = 0;
  while (const std::optional<std::string_view> line = lines.Next()) {
    if (line->empty()) continue;
    const auto [pixel, point] = ReadPoint(lines, *line);
    if (pixel >= num_pixels)
      lines.Fail("the pixel " + std::to_string(pixel) + " of a picture of " +
                 std::to_string(num_pixels));
    if (is_taken[pixel]) lines.Fail("the pixel " + std::to_string(pixel) + " is there twice");
    is_taken[pixel] = true;
    if (point.allFinite()) cloud.points[pixel] = point;
    ++count;
  }
  if (count != num_points) {
    lines.Fail(std::to_string(count) + " points; the header says " + std::to_string(num_points));
  }
  return cloud;
}

}  // namespace handcraft::datasets
