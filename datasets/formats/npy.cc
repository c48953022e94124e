// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
static_assert(std::endian::native == std::endian::little, "numbers are taken as memory holds them");

struct Header {
  std::string type;  // as in the file: byte order, kind, bytes an element
  bool fortran_order = false;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t data_begin = 0;  // byte
};

// The file with its name: fails with the place.
struct File {
  const std::filesystem::path& path;
  std::span<const std::uint8_t> bytes;

  [[noreturn]] void Fail(std::size_t byte, std::string reason, std::string remedy = {}) const {
    throw Error({.path = path.string(),
                 .byte = byte,
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)});
  }
};

// What stands behind 'key': in the header, a Python dictionary as text.
std::string_view ValueOf(const File& file, std::string_view dictionary, std::string_view key) {
  const std::string quoted = "'" + std::string(key) + "':";
  const std::size_t found = dictionary.find(quoted);
  if (found == std::string_view::npos) {
    file.Fail(kMagic.size(), "an NPY header without " + quoted);
  }
  dictionary.remove_prefix(found + quoted.size());
  dictionary.remove_prefix(std::min(dictionary.find_first_not_of(' '), dictionary.size()));
  return dictionary;
}

// "(3, 4), …" → {3, 4}: digits, commas and blanks in brackets, as Python writes them.
std::vector<std::size_t> ParseShape(const File& file, std::string_view text) {
  const std::size_t close = text.find(')');
  if (!text.starts_with('(') || close == std::string_view::npos) {
    file.Fail(kMagic.size(), "an NPY shape without brackets");
  }
  std::vector<std::size_t> dimensions;
  for (std::size_t at = 1; at < close;) {
    if (text[at] == ' ' || text[at] == ',') {
      ++at;
      continue;
    }
    std::size_t value = 0;
    const auto result = std::from_chars(text.data() + at, text.data() + close, value);
    if (result.ec == std::errc::result_out_of_range) {
      file.Fail(kMagic.size(), "an NPY shape beyond all bounds");
    }
    if (result.ec != std::errc()) file.Fail(kMagic.size(), "an NPY shape that is not of numbers");
    dimensions.push_back(value);
    at = static_cast<std::size_t>(result.ptr - text.data());
  }
  return dimensions;
}

std::size_t LittleEndian(const File& file, std::size_t at, std::size_t count) {
  if (file.bytes.size() < at + count) file.Fail(file.bytes.size(), "an NPY file cut off here");
  std::size_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | file.bytes[at + i];
  return value;
}

Header ReadHeader(const File& file) {
  const std::size_t version = LittleEndian(file, kMagic.size(), 1);
  if (version < 1 || version > 3) {
    file.Fail(kMagic.size(), "NPY format " + std::to_string(version) + "; 1, 2 or 3 is due");
  }
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::size_t begin = kMagic.size() + 2 + length_bytes;
  const std::size_t length = LittleEndian(file, kMagic.size() + 2, length_bytes);
  if (file.bytes.size() - begin < length) file.Fail(file.bytes.size(), "an NPY file cut off here");
  const std::string_view dictionary(reinterpret_cast<const char*>(file.bytes.data()) + begin,
                                    length);

  Header header;
  const std::string_view type = ValueOf(file, dictionary, "descr");
  if (!type.starts_with('\'')) {
    file.Fail(begin, "an array of records", "save one matrix of plain numbers");
  }
  header.type = type.substr(1, type.find('\'', 1) - 1);
  header.fortran_order = ValueOf(file, dictionary, "fortran_order").starts_with("True");
  const auto shape = ParseShape(file, ValueOf(file, dictionary, "shape"));
  if (shape.size() != 2) {
    file.Fail(begin,
              "an array of rank " + std::to_string(shape.size()) + "; rank 2 is due",
              "reshape it to rows and columns");
  }
  header.rows = shape[0];
  header.columns = shape[1];
  header.data_begin = begin + length;
  return header;
}

// Calls visit(T{}) with the element type; false when it is none we read.
template <class Visitor>
bool VisitType(std::string_view type, Visitor&& visit) {
  if (type == "f4") return visit(float{}), true;
  if (type == "f8") return visit(double{}), true;
  if (type == "i1") return visit(std::int8_t{}), true;
  if (type == "i2") return visit(std::int16_t{}), true;
  if (type == "i4") return visit(std::int32_t{}), true;
  if (type == "i8") return visit(std::int64_t{}), true;
  if (type == "u1" || type == "b1") return visit(std::uint8_t{}), true;
  if (type == "u2") return visit(std::uint16_t{}), true;
  if (type == "u4") return visit(std::uint32_t{}), true;
  if (type == "u8") return visit(std::uint64_t{}), true;
  return false;
}

template <class T>
double ReadElement(const std::uint8_t* from, bool swap_bytes) {
  std::array<std::uint8_t, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swap_bytes) std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<T>(bytes));
}

template <class T>
void ReadElements(const File& file, const Header& header, bool swap_bytes, NpyMatrix& matrix) {
  const std::size_t available = (file.bytes.size() - header.data_begin) / sizeof(T);
  const bool fits = header.columns == 0 || header.rows <= available / header.columns;
  if (!fits || header.data_begin + header.rows * header.columns * sizeof(T) != file.bytes.size()) {
    file.Fail(header.data_begin,
              std::to_string(file.bytes.size() - header.data_begin) + " bytes of data for " +
                  std::to_string(header.rows) + "x" + std::to_string(header.columns) +
                  " elements of " + std::to_string(sizeof(T)) + " bytes",
              "copy the file again");
  }
  matrix.values.resize(header.rows * header.columns);
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    const std::size_t byte = header.data_begin + i * sizeof(T);
    const double value = ReadElement<T>(file.bytes.data() + byte, swap_bytes);
    if (!std::isfinite(value)) file.Fail(byte, "a NaN or an infinity", "remove the row");
    const std::size_t place =
        header.fortran_order ? (i % header.rows) * header.columns + i / header.rows : i;
    matrix.values[place] = value;
  }
}

template <class T>
void WriteMatrix(const std::filesystem::path& path,
                 const T* values,
                 std::size_t rows,
                 std::size_t columns) {
  std::string header = "{'descr': '<f" + std::to_string(sizeof(T)) +
                       "', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
                       std::to_string(columns) + "), }";
  // The data begin at a multiple of 64 bytes; the header ends with a line end.
  constexpr std::size_t kPrefix = 10;
  header.append(63 - (kPrefix + header.size()) % 64, ' ').append("\n");
  std::string bytes(kMagic);
  bytes.append({'\x01', '\x00'});
  bytes.push_back(static_cast<char>(header.size() & 0xFFU));
  bytes.push_back(static_cast<char>(header.size() >> 8));
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(values), rows * columns * sizeof(T));
  WriteFileAtomically(path, bytes);
}

}  // namespace

bool IsNpy(const std::filesystem::path& path) {
  std::array<char, kMagic.size()> first{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(first.data(), first.size());
  return std::string_view(first.data(), first.size()) == kMagic;
}

NpyMatrix ReadNpy(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const File file{path, bytes};
  if (bytes.size() < kMagic.size() ||
      std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0) {
    const bool is_zip = bytes.size() >= 2 && bytes[0] == 'P' && bytes[1] == 'K';
    file.Fail(0, "not an NPY file", is_zip ? "it is a zip archive (.npz): unpack it first" : "");
  }
  const Header header = ReadHeader(file);
  const char order = header.type.empty() ? '?' : header.type.front();
  NpyMatrix matrix{.values = {}, .rows = header.rows, .columns = header.columns};
  const bool known = (order == '<' || order == '>' || order == '|') &&
                     VisitType(std::string_view(header.type).substr(1), [&](auto element) {
                       ReadElements<decltype(element)>(file, header, order == '>', matrix);
                     });
  if (!known) {
    file.Fail(
        kMagic.size(),
        "elements of type '" + header.type + "'; float32, float64, integers or booleans are due",
        "convert them, for example by .astype('float32')");
  }
  return matrix;
}

void WriteNpy(const std::filesystem::path& path,
              const float* values,
              std::size_t rows,
              std::size_t columns) {
  WriteMatrix(path, values, rows, columns);
}

void WriteNpy(const std::filesystem::path& path,
              const double* values,
              std::size_t rows,
              std::size_t columns) {
  WriteMatrix(path, values, rows, columns);
}

}  // namespace handcraft::datasets
