// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

#include "datasets/formats/npy_header.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are taken as memory holds them");

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
void ReadElements(const NpyFile& file,
                  const NpyHeader& header,
                  bool swap_bytes,
                  NpyMatrix& matrix) {
  RequireNpyLength(file, header, sizeof(T));
  matrix.values.resize(matrix.rows * matrix.columns);
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    const std::size_t byte = header.data_begin + i * sizeof(T);
    const double value = ReadElement<T>(file.bytes.data() + byte, swap_bytes);
    if (!std::isfinite(value)) file.Fail(byte, "a NaN or an infinity", "remove the row");
    const std::size_t place =
        header.fortran_order ? (i % matrix.rows) * matrix.columns + i / matrix.rows : i;
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
  std::string bytes(kNpyMagic);
  bytes.append({'\x01', '\x00'});
  bytes.push_back(static_cast<char>(header.size() & 0xFFU));
  bytes.push_back(static_cast<char>(header.size() >> 8));
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(values), rows * columns * sizeof(T));
  WriteFileAtomically(path, bytes);
}

}  // namespace

bool IsNpy(const std::filesystem::path& path) {
  if (KindOf(path) != PathKind::kFile) return false;  // a pipe would be waited for
  std::array<char, kNpyMagic.size()> first{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(first.data(), first.size());
  return std::string_view(first.data(), first.size()) == kNpyMagic;
}

NpyMatrix ReadNpy(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const NpyFile file{path, bytes};
  const NpyHeader header = ReadNpyHeader(file);
  if (header.shape.size() != 2) {
    file.Fail(kNpyMagic.size(),
              "an array of rank " + std::to_string(header.shape.size()) + "; rank 2 is due",
              "reshape it to rows and columns");
  }
  const char order = header.type.empty() ? '?' : header.type.front();
  NpyMatrix matrix{.values = {}, .rows = header.shape[0], .columns = header.shape[1]};
  const bool known = (order == '<' || order == '>' || order == '|') &&
                     VisitType(std::string_view(header.type).substr(1), [&](auto element) {
                       ReadElements<decltype(element)>(file, header, order == '>', matrix);
                     });
  if (!known) {
    file.Fail(
        kNpyMagic.size(),
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
