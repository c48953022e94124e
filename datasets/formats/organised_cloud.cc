// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/organised_cloud.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "datasets/formats/lzf.h"
#include "datasets/formats/pcd_header.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are taken as memory holds them");
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

constexpr std::size_t kMostBytesBehind = 65536;  // the largest memory page
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct File {
  const std::filesystem::path& path;
  std::span<const std::uint8_t> bytes;
  PcdHeader header;

  [[nodiscard]] std::span<const std::uint8_t> Data() const {
    return bytes.subspan(header.data_begin);
  }
  [[noreturn]] void FailAtByte(std::size_t byte, std::string reason) const {
    throw Error({.path = path.string(),
                 .byte = byte,
                 .reason = std::move(reason),
                 .remedy = "copy the file again"});
  }
  [[noreturn]] void FailAtLine(std::size_t line, std::string reason) const {
    throw Error({.path = path.string(), .line = line, .reason = std::move(reason)});
  }
};

float FloatAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  float value = 0.0F;
  std::memcpy(&value, &bytes[at], sizeof(value));
  return value;
}

std::size_t SizeAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, &bytes[at], sizeof(value));
  return value;
}

// The next word of a line, which loses it; empty at its end.
std::string_view TakeWord(std::string_view& line) {
  constexpr std::string_view kBlanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(word.size());
  return word;
}

float ParseCoordinate(const File& file, std::size_t line, std::string_view word) {
  float value = 0.0F;
  const char* const end = word.data() + word.size();
  const auto [stop, code] = std::from_chars(word.data(), end, value);
  if (stop == end && code == std::errc()) return value;
  file.FailAtLine(line, "'" + std::string(word) + "' where a coordinate is due");
}

Eigen::Vector3f ParsePoint(const File& file, std::size_t line, std::string_view text) {
  Eigen::Vector3f point = Eigen::Vector3f::Constant(kNaN);
  std::size_t count = 0;
  for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text), ++count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (file.header.coordinates[axis].value != count) continue;
      point[static_cast<Eigen::Index>(axis)] = ParseCoordinate(file, line, word);
    }
  }
  if (count != file.header.point_values) {
    file.FailAtLine(line, fmt::format("{} values; {} are due", count, file.header.point_values));
  }
  return point;
}

std::vector<Eigen::Vector3f> ReadAscii(const File& file) {
  std::string_view text(reinterpret_cast<const char*>(file.Data().data()), file.Data().size());
  const std::size_t num_points = file.header.num_points();
  std::vector<Eigen::Vector3f> points;
  // A value and the blank behind it take two bytes: no header makes us reserve more than is there.
  points.reserve(std::min(num_points, text.size() / 2));
  std::size_t line = file.header.data_line;
  for (; !text.empty(); ++line) {
    const std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    if (row.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (points.size() == num_points) {
      file.FailAtLine(line, fmt::format("more than the {} points of the header", num_points));
    }
    points.push_back(ParsePoint(file, line, row));
  }
  if (points.size() != num_points) {
    file.FailAtLine(line,
                    fmt::format("the file ends after {} of {} points", points.size(), num_points));
  }
  return points;
}

void CheckDataSize(const File& file) {
  const std::size_t due = file.header.num_points() * file.header.point_bytes;
  const std::size_t size = file.Data().size();
  if (size >= due && size - due <= kMostBytesBehind) return;
  file.FailAtByte(file.header.data_begin,
                  fmt::format("{} bytes of data; {} points of {} bytes are due",
                              size,
                              file.header.num_points(),
                              file.header.point_bytes));
}

std::vector<Eigen::Vector3f> ReadBinary(const File& file) {
  CheckDataSize(file);
  const std::span<const std::uint8_t> data = file.Data();
  std::vector<Eigen::Vector3f> points(file.header.num_points());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[i][static_cast<Eigen::Index>(axis)] =
          FloatAt(data, i * file.header.point_bytes + file.header.coordinates[axis].offset_bytes);
    }
  }
  return points;
}

// Two lengths, then an LZF stream of one field after the other.
std::vector<Eigen::Vector3f> ReadCompressed(const File& file) {
  constexpr std::size_t kLengths = 8;
  const std::span<const std::uint8_t> data = file.Data();
  const std::size_t begin = file.header.data_begin;
  if (data.size() < kLengths) file.FailAtByte(begin, "the file ends before the two lengths");
  const std::size_t num_points = file.header.num_points();
  const std::size_t due = num_points * file.header.point_bytes;
  if (SizeAt(data, 4) != due) {
    file.FailAtByte(begin + 4, fmt::format("{} bytes unpacked; {} are due", SizeAt(data, 4), due));
  }
  const std::size_t packed = SizeAt(data, 0);
  const std::size_t there = data.size() - kLengths;
  if (packed > there || there - packed > kMostBytesBehind) {
    file.FailAtByte(begin, fmt::format("{} packed bytes announced; {} are there", packed, there));
  }
  const auto unpacked = UnpackLzf(data.subspan(kLengths, packed), due);
  if (!unpacked) file.FailAtByte(begin + kLengths, "a damaged LZF stream");
  std::vector<Eigen::Vector3f> points(num_points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t field = file.header.coordinates[axis].offset_bytes * num_points;
    for (std::size_t i = 0; i < num_points; ++i) {
      points[i][static_cast<Eigen::Index>(axis)] = FloatAt(*unpacked, field + i * sizeof(float));
    }
  }
  return points;
}

}  // namespace

OrganisedCloud ReadPcd(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const File file{path, bytes, ReadPcdHeader(path, bytes)};
  OrganisedCloud cloud{.width = file.header.width,
                       .height = file.header.height,
                       .points = {},
                       .base_from_camera = file.header.viewpoint};
  switch (file.header.data) {
    case PcdData::kAscii:
      cloud.points = ReadAscii(file);
      break;
    case PcdData::kBinary:
      cloud.points = ReadBinary(file);
      break;
    case PcdData::kBinaryCompressed:
      cloud.points = ReadCompressed(file);
      break;
  }
  for (Eigen::Vector3f& point : cloud.points) {
    if (!IsMeasured(point)) point.setConstant(kNaN);
  }
  return cloud;
}

void WritePcd(const std::filesystem::path& path, const OrganisedCloud& cloud) {
  HC_CHECK(cloud.width >= 1 && cloud.height >= 1, cloud.width, cloud.height);
  const std::size_t num_points =
      static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height);
  HC_CHECK(cloud.points.size() == num_points, cloud.points.size(), num_points);
  const Eigen::Vector3f p = cloud.base_from_camera.translation();
  const Eigen::Quaternionf q(cloud.base_from_camera.linear());
  std::string bytes = fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
      "TYPE F F F\nCOUNT 1 1 1\nWIDTH {}\nHEIGHT {}\nVIEWPOINT {} {} {} {} {} {} {}\n"
      "POINTS {}\nDATA binary\n",
      cloud.width,
      cloud.height,
      p.x(),
      p.y(),
      p.z(),
      q.w(),
      q.x(),
      q.y(),
      q.z(),
      num_points);
  bytes.append(reinterpret_cast<const char*>(cloud.points.data()),
               num_points * sizeof(Eigen::Vector3f));
  WriteFileAtomically(path, bytes);
}

}  // namespace handcraft::datasets
