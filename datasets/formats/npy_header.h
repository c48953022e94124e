// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handcraft::datasets {

/// How every NPY file begins.
inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// The bytes of a file that should be NPY, with its name; both must outlive it.
struct NpyFile {
  const std::filesystem::path& path;
  std::span<const std::uint8_t> bytes;

  /// Throws Error naming file and byte.
  [[noreturn]] void Fail(std::size_t byte, std::string reason, std::string remedy = {}) const;
};

/// What the header of an NPY file tells of its array.
struct NpyHeader {
  std::string type;  ///< as in the file: byte order, kind, bytes an element ("<f4"); may be empty
  bool fortran_order = false;
  std::vector<std::size_t> shape;
  std::size_t data_begin = 0;  ///< byte; within the file
};

/// Reads a header of format 1, 2 or 3. Throws Error with the byte for another file, a header that
/// is cut off or lacks a key, an array of records, and a shape that is none. The numbers of the
/// shape are not compared with the length of the file.
/// Source: numpy.lib.format, "NPY format".
[[nodiscard]] NpyHeader ReadNpyHeader(const NpyFile& file);

/// "2x3"
[[nodiscard]] std::string ShapeText(std::span<const std::size_t> shape);

/// Throws Error that says both lengths unless an array of this shape just fills the file behind the
/// header.
void RequireNpyLength(const NpyFile& file, const NpyHeader& header, std::size_t element_bytes);

}  // namespace handcraft::datasets
