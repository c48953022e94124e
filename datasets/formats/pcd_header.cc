// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/pcd_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

constexpr std::size_t kMaxFields = 64;
constexpr std::size_t kMaxPointBytes = 65536;
constexpr std::size_t kMaxPoints = std::size_t{1} << 28;
constexpr std::array<std::string_view, 10> kKeys = {
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

struct Entry {
  std::vector<std::string_view> values;
  std::size_t line = 0;
};

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::vector<std::string_view> SplitWords(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

bool IsNumber(std::string_view type) { return type == "U" || type == "I" || type == "F"; }

class HeaderReader {
 public:
  HeaderReader(const std::filesystem::path& path, std::span<const std::uint8_t> bytes)
      : path_(path), text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  PcdHeader Read() {
    while (entries_.count("DATA") == 0) TakeLine();
    PcdHeader header;
    if (IsOfCornell()) {
      header.unit_m = 0.001F;
    } else {
      CheckVersion();
    }
    ReadFields(header);
    header.width = ReadSide("WIDTH");
    header.height = ReadSide("HEIGHT");
    CheckNumPoints(header);
    header.viewpoint = ReadViewpoint();
    header.data = ReadDataKind();
    header.data_begin = at_;
    header.data_line = line_ + 1;
    return header;
  }

 private:
  [[noreturn]] void Fail(std::size_t line, std::string reason, std::string remedy = {}) const {
    throw Error({.path = path_.string(),
                 .line = line,
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)});
  }

  void TakeLine() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) {
      Fail(line_ + 1, "the PCD header ends before a line DATA", "copy the file again");
    }
    const auto words = SplitWords(text_.substr(at_, end - at_));
    ++line_;
    at_ = end + 1;
    if (words.empty() || words[0].starts_with('#')) return;
    if (std::find(kKeys.begin(), kKeys.end(), words[0]) == kKeys.end()) {
      Fail(line_, "no line of a PCD header: it begins with none of VERSION, FIELDS, … DATA");
    }
    const Entry entry{.values = {words.begin() + 1, words.end()}, .line = line_};
    if (!entries_.emplace(words[0], entry).second) {
      Fail(line_, Quoted(words[0]) + " appears twice");
    }
  }

  [[nodiscard]] const Entry& Need(std::string_view key, std::optional<std::size_t> count) const {
    const auto found = entries_.find(key);
    if (found == entries_.end()) Fail(line_, "a PCD header without " + Quoted(key));
    const Entry& entry = found->second;
    if (count && entry.values.size() != *count) {
      Fail(entry.line,
           std::string(key) + " has " + std::to_string(entry.values.size()) + " values; " +
               std::to_string(*count) + " are due");
    }
    return entry;
  }

  [[nodiscard]] bool IsOfCornell() const {
    constexpr std::array<std::string_view, 5> kCornellFields = {"x", "y", "z", "rgb", "index"};
    const auto& fields = Need("FIELDS", std::nullopt).values;
    return entries_.count("VERSION") == 0 &&
           std::equal(fields.begin(), fields.end(), kCornellFields.begin(), kCornellFields.end());
  }

  void CheckVersion() const {
    const Entry& entry = Need("VERSION", 1);
    if (entry.values[0] == "0.7" || entry.values[0] == ".7") return;
    Fail(entry.line,
         "PCD version " + std::string(entry.values[0]) + "; 0.7 is due",
         "convert it with a program of the Point Cloud Library");
  }

  // A whole number from `least` to `most`.
  [[nodiscard]] std::size_t ReadCount(const Entry& entry,
                                      std::size_t index,
                                      std::string_view what,
                                      std::size_t most,
                                      std::size_t least = 1) const {
    const std::string_view text = entry.values[index];
    std::size_t value = 0;
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || stop != text.data() + text.size() || value < least || value > most) {
      Fail(entry.line,
           fmt::format("{} {}; a number from {} to {} is due", what, text, least, most));
    }
    return value;
  }

  [[nodiscard]] int ReadSide(std::string_view key) const {
    return static_cast<int>(ReadCount(Need(key, 1), 0, key, kMaxPoints, 0));
  }

  void ReadFields(PcdHeader& header) const {
    const Entry& fields = Need("FIELDS", std::nullopt);
    const std::size_t num_fields = fields.values.size();
    if (num_fields > kMaxFields) Fail(fields.line, std::to_string(num_fields) + " fields");
    const Entry& sizes = Need("SIZE", num_fields);
    const Entry& types = Need("TYPE", num_fields);
    const bool has_counts = entries_.count("COUNT") > 0;
    std::array<bool, 3> found{};
    for (std::size_t i = 0; i < num_fields; ++i) {
      const std::size_t size = ReadCount(sizes, i, "SIZE", 8);
      const std::size_t count =
          has_counts ? ReadCount(Need("COUNT", num_fields), i, "COUNT", kMaxPointBytes) : 1;
      const std::string_view name = fields.values[i];
      if (name == "x" || name == "y" || name == "z") {
        const auto axis = static_cast<std::size_t>(name[0] - 'x');
        if (found[axis]) Fail(fields.line, "field " + Quoted(name) + " appears twice");
        if (size != 4 || types.values[i] != "F" || count != 1) {
          Fail(fields.line, "field " + Quoted(name) + " is not a single float of four bytes");
        }
        found[axis] = true;
        header.coordinates[axis] = {header.point_bytes, header.point_values};
      } else if (name == "index" && size == 4 && count == 1 && IsNumber(types.values[i])) {
        if (header.index) Fail(fields.line, "field 'index' appears twice");
        header.index = {{header.point_bytes, header.point_values}, types.values[i][0]};
      }
      header.point_bytes += size * count;
      header.point_values += count;
    }
    if (header.point_bytes > kMaxPointBytes) Fail(sizes.line, "more than 65536 bytes a point");
    if (!found[0] || !found[1] || !found[2]) Fail(fields.line, "no fields x, y and z");
  }

  void CheckNumPoints(const PcdHeader& header) const {
    if (header.num_points() > kMaxPoints) {
      Fail(Need("HEIGHT", 1).line, "more than " + std::to_string(kMaxPoints) + " points");
    }
    const Entry& points = Need("POINTS", 1);
    if (ReadCount(points, 0, "POINTS", kMaxPoints, 0) != header.num_points()) {
      Fail(points.line,
           "POINTS " + std::string(points.values[0]) + "; WIDTH times HEIGHT is " +
               std::to_string(header.num_points()));
    }
  }

  // Translation and quaternion w x y z; at the origin when the line is missing.
  [[nodiscard]] Eigen::Isometry3f ReadViewpoint() const {
    if (entries_.count("VIEWPOINT") == 0) return Eigen::Isometry3f::Identity();
    const Entry& entry = Need("VIEWPOINT", 7);
    std::array<float, 7> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::string_view text = entry.values[i];
      const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
      if (code != std::errc() || stop != text.data() + text.size() || !std::isfinite(numbers[i]))
        Fail(entry.line, "VIEWPOINT with " + Quoted(text) + ", which is no finite number");
    }
    const Eigen::Quaternionf rotation(numbers[3], numbers[4], numbers[5], numbers[6]);
    constexpr float kTolerance = 1e-3F;  // three printed digits
    if (std::abs(rotation.norm() - 1.0F) > kTolerance) {
      Fail(entry.line, "VIEWPOINT with a quaternion that is not of length 1");
    }
    return Eigen::Translation3f(numbers[0], numbers[1], numbers[2]) *
           Eigen::Isometry3f(rotation.normalized());
  }

  [[nodiscard]] PcdData ReadDataKind() const {
    const Entry& entry = Need("DATA", 1);
    if (entry.values[0] == "ascii") return PcdData::kAscii;
    if (entry.values[0] == "binary") return PcdData::kBinary;
    if (entry.values[0] == "binary_compressed") return PcdData::kBinaryCompressed;
    Fail(entry.line,
         "DATA " + Quoted(entry.values[0]) + "; ascii, binary or binary_compressed is due");
  }

  const std::filesystem::path& path_;
  std::string_view text_;
  std::map<std::string_view, Entry> entries_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
};

}  // namespace

PcdHeader ReadPcdHeader(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  return HeaderReader(path, bytes).Read();
}

}  // namespace handcraft::datasets
