// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/mat_array.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

// Types of data elements and classes of arrays (tables 1-1 and 1-3 of the format's description).
constexpr std::uint32_t kInt8 = 1;
constexpr std::uint32_t kInt32 = 5;
constexpr std::uint32_t kUint32 = 6;
constexpr std::uint32_t kMatrix = 14;
constexpr std::uint32_t kCompressed = 15;
constexpr std::uint32_t kFirstNumericClass = 6;  // double
constexpr std::uint32_t kLastNumericClass = 15;  // unsigned, 64 bits
constexpr std::uint32_t kComplexFlag = 0x0800;

constexpr std::size_t kHeaderBytes = 128;
constexpr std::size_t kMaxValues = std::size_t{1} << 24;
constexpr std::size_t kMaxInflatedBytes = kMaxValues * sizeof(double) + 4096;

// Bytes of a file, or what some of them inflate to.
struct Source {
  const std::filesystem::path& path;
  std::span<const std::uint8_t> bytes;
  std::size_t file_begin = 0;      // where they stand in the file
  bool is_inflated = false;        // then all of them stand at file_begin
  bool is_of_other_order = false;  // big-endian

  [[noreturn]] void Fail(std::size_t at, std::string reason, std::string remedy = {}) const {
    throw Error({.path = path.string(),
                 .byte = file_begin + (is_inflated ? 0 : at),
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)});
  }
  [[noreturn]] void FailCutOff() const { Fail(bytes.size(), "a MAT-file cut off here"); }

  template <class T>
  [[nodiscard]] T At(std::size_t at) const {
    if (at > bytes.size() || bytes.size() - at < sizeof(T)) FailCutOff();
    std::array<std::uint8_t, sizeof(T)> raw{};
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), sizeof(T), raw.begin());
    if (is_of_other_order) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }
  [[nodiscard]] Source Part(std::size_t at, std::size_t size) const {
    Source part = *this;
    part.bytes = bytes.subspan(at, size);
    if (!is_inflated) part.file_begin += at;
    return part;
  }
  [[nodiscard]] Source Inflated(std::span<const std::uint8_t> inflated) const {
    Source source = *this;
    source.bytes = inflated;
    source.is_inflated = true;
    return source;
  }
};

struct Element {
  std::uint32_t type = 0;
  Source data;
  std::size_t end = 0;  // where the next one begins
};

// A tag of type and size, then the data, filled up to a multiple of eight; of up to four bytes both
// stand in one such eight.
Element ReadElement(const Source& source, std::size_t at) {
  const auto first = source.At<std::uint32_t>(at);
  const bool is_small = first >> 16 != 0;
  const std::size_t size = is_small ? first >> 16 : source.At<std::uint32_t>(at + 4);
  const std::uint32_t type = is_small ? first & 0xFFFF : first;
  const std::size_t begin = at + (is_small ? 4 : 8);
  if (is_small && size > 4) source.Fail(at, "a small data element of more than four bytes");
  if (begin > source.bytes.size() || source.bytes.size() - begin < size) source.FailCutOff();
  const std::size_t filled = type == kCompressed ? size : (size + 7) / 8 * 8;
  const std::size_t end = is_small ? at + 8 : begin + filled;
  return {type, source.Part(begin, size), std::min(end, source.bytes.size())};
}

// The bytes of a compressed element, of which there may not be more than any array has.
std::vector<std::uint8_t> Inflate(const Source& source) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) source.Fail(0, "cannot inflate: out of memory");
  stream.next_in = const_cast<Bytef*>(source.bytes.data());
  stream.avail_in = static_cast<uInt>(source.bytes.size());
  std::vector<std::uint8_t> inflated;
  int status = Z_OK;
  while (status == Z_OK && inflated.size() <= kMaxInflatedBytes) {
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    const std::size_t before = inflated.size();
    inflated.resize(before + kChunk);
    stream.next_out = inflated.data() + before;
    stream.avail_out = kChunk;
    status = inflate(&stream, Z_NO_FLUSH);
    inflated.resize(inflated.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status == Z_OK) source.Fail(0, "compressed data of more than 2^24 numbers");
  if (status != Z_STREAM_END) source.Fail(0, "compressed data that is damaged");
  return inflated;
}

// The numbers of an element, each of type T.
template <class T>
std::vector<double> ReadNumbers(const Source& data) {
  if (data.bytes.size() % sizeof(T) != 0) data.Fail(0, "a part of a number at the end");
  std::vector<double> numbers(data.bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = static_cast<double>(data.At<T>(i * sizeof(T)));
  }
  return numbers;
}

std::vector<double> ReadNumbers(const Element& element) {
  switch (element.type) {
    case 1:
      return ReadNumbers<std::int8_t>(element.data);
    case 2:
      return ReadNumbers<std::uint8_t>(element.data);
    case 3:
      return ReadNumbers<std::int16_t>(element.data);
    case 4:
      return ReadNumbers<std::uint16_t>(element.data);
    case kInt32:
      return ReadNumbers<std::int32_t>(element.data);
    case kUint32:
      return ReadNumbers<std::uint32_t>(element.data);
    case 7:
      return ReadNumbers<float>(element.data);
    case 9:
      return ReadNumbers<double>(element.data);
    case 12:
      return ReadNumbers<std::int64_t>(element.data);
    case 13:
      return ReadNumbers<std::uint64_t>(element.data);
    default:
      element.data.Fail(0, "data of type " + std::to_string(element.type) + "; numbers are due");
  }
}

Element ReadElementOfType(const Source& source, std::size_t at, std::uint32_t type) {
  Element element = ReadElement(source, at);
  if (element.type != type) {
    source.Fail(at,
                "a data element of type " + std::to_string(element.type) + " where " +
                    std::to_string(type) + " is due");
  }
  return element;
}

std::vector<std::size_t> ReadDimensions(const Element& element) {
  std::vector<std::size_t> dimensions;
  std::size_t count = 1;
  for (const double number : ReadNumbers<std::int32_t>(element.data)) {
    if (number < 0) element.data.Fail(0, "a negative dimension");
    dimensions.push_back(static_cast<std::size_t>(number));
    if (dimensions.back() > kMaxValues / std::max<std::size_t>(count, 1)) {
      element.data.Fail(0, "an array of more than 2^24 numbers");
    }
    count *= dimensions.back();
  }
  if (dimensions.size() < 2) element.data.Fail(0, "an array without rows and columns");
  return dimensions;
}

// The array, if it has the name that is wanted; else its name is added to those that were found.
std::optional<MatArray> ReadMatrix(const Source& matrix,
                                   const std::string& wanted,
                                   std::vector<std::string>& found) {
  const Element flags = ReadElementOfType(matrix, 0, kUint32);
  const auto word = flags.data.At<std::uint32_t>(0);
  const Element dimensions = ReadElementOfType(matrix, flags.end, kInt32);
  const Element label = ReadElementOfType(matrix, dimensions.end, kInt8);
  const std::string name(label.data.bytes.begin(), label.data.bytes.end());
  if (name != wanted) {
    found.push_back(name);
    return std::nullopt;
  }
  const std::uint32_t array_class = word & 0xFF;
  if (array_class < kFirstNumericClass || array_class > kLastNumericClass ||
      (word & kComplexFlag) != 0) {
    matrix.Fail(0, "'" + name + "' is not a full array of real numbers");
  }
  MatArray array{.dimensions = ReadDimensions(dimensions), .values = {}};
  array.values = ReadNumbers(ReadElement(matrix, label.end));
  std::size_t count = 1;
  for (const std::size_t size : array.dimensions) count *= size;
  if (array.values.size() != count) {
    matrix.Fail(0,
                "'" + name + "' holds " + std::to_string(array.values.size()) +
                    " numbers; its dimensions ask for " + std::to_string(count));
  }
  return array;
}

void CheckHeader(Source& file) {
  const std::string_view start(reinterpret_cast<const char*>(file.bytes.data()),
                               std::min<std::size_t>(file.bytes.size(), 10));
  if (start.starts_with("\x89HDF") || start == "MATLAB 7.3") {
    file.Fail(0, "a MAT-file of version 7.3", "save it with -v7");
  }
  const std::string remedy = "save it with -v7";
  if (file.bytes.size() < kHeaderBytes) file.Fail(0, "not a MAT-file of level 5", remedy);
  const std::string_view mark(reinterpret_cast<const char*>(file.bytes.data()) + 126, 2);
  if (mark != "IM" && mark != "MI") file.Fail(126, "not a MAT-file of level 5", remedy);
  file.is_of_other_order = (mark == "IM") != (std::endian::native == std::endian::little);
  if (file.At<std::uint16_t>(124) != 0x0100) file.Fail(124, "another version of MAT-file", remedy);
}

}  // namespace

MatArray ReadMatArray(const std::filesystem::path& path, const std::string& name) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  Source file{.path = path, .bytes = bytes};
  CheckHeader(file);
  std::vector<std::string> found;
  for (std::size_t at = kHeaderBytes; at < bytes.size();) {
    const Element element = ReadElement(file, at);
    at = element.end;
    std::vector<std::uint8_t> inflated;
    if (element.type == kCompressed) inflated = Inflate(element.data);
    const Element matrix =
        element.type == kCompressed ? ReadElement(element.data.Inflated(inflated), 0) : element;
    if (matrix.type != kMatrix) continue;
    std::optional<MatArray> array = ReadMatrix(matrix.data, name, found);
    if (array) return std::move(*array);
  }
  std::string names;
  for (const std::string& other : found) names += (names.empty() ? "'" : ", '") + other + "'";
  throw Error(
      {.path = path.string(),
       .reason = "no array '" + name + "'; there are: " + (names.empty() ? "none" : names)});
}

}  // namespace handcraft::datasets
