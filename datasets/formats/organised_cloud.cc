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

// Points as the file has them, and beside each the number of its pixel where there is a field for
// it.
struct FilePoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<double> indices;
};

template <class T>
T NumberAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, &bytes[at], sizeof(value));
  return value;
}

double IndexAt(std::span<const std::uint8_t> bytes, std::size_t at, char type) {
  if (type == 'F') return static_cast<double>(NumberAt<float>(bytes, at));
  if (type == 'I') return static_cast<double>(NumberAt<std::int32_t>(bytes, at));
  return static_cast<double>(NumberAt<std::uint32_t>(bytes, at));
}

// The next word of a line, which loses it; empty at its end.
std::string_view TakeWord(std::string_view& line) {
  constexpr std::string_view kBlanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(word.size());
  return word;
}

template <class T>
T ParseNumber(const File& file, std::size_t line, std::string_view word, std::string_view due) {
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, code] = std::from_chars(word.data(), end, value);
  if (stop == end && code == std::errc()) return value;
  file.FailAtLine(line, fmt::format("'{}' where {} is due", word, due));
}

void ParsePoint(const File& file, std::size_t line, std::string_view text, FilePoints& read) {
  const PcdHeader& header = file.header;
  Eigen::Vector3f& point = read.points.emplace_back(Eigen::Vector3f::Constant(kNaN));
  std::size_t count = 0;
  for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text), ++count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (header.coordinates[axis].value != count) continue;
      point[static_cast<Eigen::Index>(axis)] = ParseNumber<float>(file, line, word, "a coordinate");
    }
    if (header.index && header.index->value == count) {
      read.indices.push_back(ParseNumber<double>(file, line, word, "an index"));
    }
  }
  if (count != header.point_values) {
    file.FailAtLine(line, fmt::format("{} values; {} are due", count, header.point_values));
  }
}

FilePoints ReadAscii(const File& file) {
  std::string_view text(reinterpret_cast<const char*>(file.Data().data()), file.Data().size());
  const std::size_t num_points = file.header.num_points();
  FilePoints read;
  // A value and the blank behind it take two bytes: no header makes us reserve more than is there.
  read.points.reserve(std::min(num_points, text.size() / 2));
  std::size_t line = file.header.data_line;
  for (; !text.empty(); ++line) {
    const std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    if (row.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (read.points.size() == num_points) {
      file.FailAtLine(line, fmt::format("more than the {} points of the header", num_points));
    }
    ParsePoint(file, line, row, read);
  }
  if (read.points.size() != num_points) {
    file.FailAtLine(
        line, fmt::format("the file ends after {} of {} points", read.points.size(), num_points));
  }
  return read;
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

// The first point's value of a field stands at byte begin(field), the next ones `stride` bytes
// apart.
template <class Begin>
FilePoints Gather(const File& file,
                  std::span<const std::uint8_t> bytes,
                  std::size_t stride,
                  const Begin& begin) {
  FilePoints read{.points = std::vector<Eigen::Vector3f>(file.header.num_points()), .indices = {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t field = begin(file.header.coordinates[axis]);
    for (std::size_t i = 0; i < read.points.size(); ++i) {
      read.points[i][static_cast<Eigen::Index>(axis)] = NumberAt<float>(bytes, field + i * stride);
    }
  }
  if (!file.header.index) return read;
  const std::size_t field = begin(*file.header.index);
  read.indices.reserve(read.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    read.indices.push_back(IndexAt(bytes, field + i * stride, file.header.index->type));
  }
  return read;
}

FilePoints ReadBinary(const File& file) {
  CheckDataSize(file);
  return Gather(file, file.Data(), file.header.point_bytes, [](const PcdHeader::Coordinate& field) {
    return field.offset_bytes;
  });
}

// Two lengths, then an LZF stream of one field after the other.
FilePoints ReadCompressed(const File& file) {
  constexpr std::size_t kLengths = 8;
  const std::span<const std::uint8_t> data = file.Data();
  const std::size_t begin = file.header.data_begin;
  if (data.size() < kLengths) file.FailAtByte(begin, "the file ends before the two lengths");
  const std::size_t num_points = file.header.num_points();
  const std::size_t due = num_points * file.header.point_bytes;
  if (NumberAt<std::uint32_t>(data, 4) != due) {
    file.FailAtByte(
        begin + 4,
        fmt::format("{} bytes unpacked; {} are due", NumberAt<std::uint32_t>(data, 4), due));
  }
  const std::size_t packed = NumberAt<std::uint32_t>(data, 0);
  const std::size_t there = data.size() - kLengths;
  if (packed > there || there - packed > kMostBytesBehind) {
    file.FailAtByte(begin, fmt::format("{} packed bytes announced; {} are there", packed, there));
  }
  const auto unpacked = UnpackLzf(data.subspan(kLengths, packed), due);
  if (!unpacked) file.FailAtByte(begin + kLengths, "a damaged LZF stream");
  return Gather(file, *unpacked, sizeof(float), [=](const PcdHeader::Coordinate& field) {
    return field.offset_bytes * num_points;
  });
}

FilePoints ReadPoints(const File& file, float unit_m) {
  FilePoints read;
  switch (file.header.data) {
    case PcdData::kAscii:
      read = ReadAscii(file);
      break;
    case PcdData::kBinary:
      read = ReadBinary(file);
      break;
    case PcdData::kBinaryCompressed:
      read = ReadCompressed(file);
      break;
  }
  for (Eigen::Vector3f& point : read.points) {
    point *= unit_m;
    if (!IsMeasured(point)) point.setConstant(kNaN);
  }
  return read;
}

std::string SizeText(const PixelSize& size) {
  return fmt::format("{} × {} pixels", size[0], size[1]);
}

// The points where their indices say.
std::vector<Eigen::Vector3f> PutAtPixels(const File& file,
                                         const FilePoints& read,
                                         const PixelSize& picture_size) {
  const auto num_pixels = static_cast<std::size_t>(picture_size[0] * picture_size[1]);
  std::vector<Eigen::Vector3f> pixels(num_pixels, Eigen::Vector3f::Constant(kNaN));
  std::vector<bool> is_taken(num_pixels);
  const auto fail = [&](std::size_t i, const std::string& what) {
    throw Error(
        {.path = file.path.string(),
         .reason = fmt::format(
             "point {} of {}: index {} {}", i + 1, read.points.size(), read.indices[i], what),
         .remedy = "index is row · width + column of a point's pixel; give the picture that "
                   "the cloud belongs to"});
  };
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    const double index = read.indices[i];
    if (!(index >= 0.0 && index < static_cast<double>(num_pixels))) {
      fail(i, "is outside the picture of " + SizeText(picture_size));
    }
    const auto pixel = static_cast<std::size_t>(index);
    if (static_cast<double>(pixel) != index) fail(i, "is no whole number");
    if (is_taken[pixel]) fail(i, "is there twice");
    is_taken[pixel] = true;
    pixels[pixel] = read.points[i];
  }
  return pixels;
}

}  // namespace

OrganisedCloud ReadPcd(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const File file{path, bytes, ReadPcdHeader(path, bytes)};
  if (file.header.num_points() == 0) throw Error({.path = path.string(), .reason = "no points"});
  return {.width = file.header.width,
          .height = file.header.height,
          .points = ReadPoints(file, file.header.unit_m).points,
          .base_from_camera = file.header.viewpoint};
}

OrganisedCloud ReadCloudOfPicture(const std::filesystem::path& path,
                                  const PixelSize& picture_size,
                                  std::optional<float> unit_m) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const File file{path, bytes, ReadPcdHeader(path, bytes)};
  const PcdHeader& header = file.header;
  OrganisedCloud cloud{.width = static_cast<int>(picture_size[0]),
                       .height = static_cast<int>(picture_size[1]),
                       .points = {},
                       .base_from_camera = header.viewpoint};
  const PixelSize size = {header.width, header.height};
  const bool has_points = header.num_points() > 0;
  if (has_points && (header.height > 1 || size == picture_size)) {
    RequireSameSize(path, "the cloud", size, picture_size);
    if (!header.index) {
      cloud.points = ReadPoints(file, unit_m.value_or(header.unit_m)).points;
      return cloud;
    }
  }
  if (has_points && !header.index) {
    throw Error(
        {.path = path.string(),
         .reason = "an unorganised cloud (HEIGHT 1) without a field 'index' of four bytes: "
                   "nothing tells which pixel a point belongs to",
         .remedy = fmt::format("write the cloud organised, {}, or with an index, row · width "
                               "+ column, for each point",
                               SizeText(picture_size))});
  }
  cloud.points = PutAtPixels(file, ReadPoints(file, unit_m.value_or(header.unit_m)), picture_size);
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
