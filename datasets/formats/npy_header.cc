// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy_header.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <system_error>
#include <utility>

#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

void CheckSignature(const NpyFile& file) {
  if (file.bytes.size() >= kNpyMagic.size() &&
      std::memcmp(file.bytes.data(), kNpyMagic.data(), kNpyMagic.size()) == 0) {
    return;
  }
  const bool is_zip = file.bytes.size() >= 2 && file.bytes[0] == 'P' && file.bytes[1] == 'K';
  file.Fail(0,
            "not an NPY file",
            is_zip ? "it is a zip archive (.npz): unpack it first" : "give what numpy.save writes");
}

// What stands behind 'key': in the header, a Python dictionary as text.
std::string_view ValueOf(const NpyFile& file, std::string_view dictionary, std::string_view key) {
  const std::string quoted = "'" + std::string(key) + "':";
  const std::size_t found = dictionary.find(quoted);
  if (found == std::string_view::npos) {
    file.Fail(kNpyMagic.size(), "an NPY header without " + quoted);
  }
  dictionary.remove_prefix(found + quoted.size());
  dictionary.remove_prefix(std::min(dictionary.find_first_not_of(' '), dictionary.size()));
  return dictionary;
}

// "(3, 4), …" → {3, 4}: digits, commas and blanks in brackets, as Python writes them.
std::vector<std::size_t> ParseShape(const NpyFile& file, std::string_view text) {
  const std::size_t close = text.find(')');
  if (!text.starts_with('(') || close == std::string_view::npos) {
    file.Fail(kNpyMagic.size(), "an NPY shape without brackets");
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
      file.Fail(kNpyMagic.size(), "an NPY shape beyond all bounds");
    }
    if (result.ec != std::errc())
      file.Fail(kNpyMagic.size(), "an NPY shape that is not of numbers");
    dimensions.push_back(value);
    at = static_cast<std::size_t>(result.ptr - text.data());
  }
  return dimensions;
}

std::size_t LittleEndian(const NpyFile& file, std::size_t at, std::size_t count) {
  if (file.bytes.size() < at + count) file.Fail(file.bytes.size(), "an NPY file cut off here");
  std::size_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | file.bytes[at + i];
  return value;
}

}  // namespace

void NpyFile::Fail(std::size_t byte, std::string reason, std::string remedy) const {
  throw Error({.path = path.string(),
               .byte = byte,
               .reason = std::move(reason),
               .remedy = std::move(remedy)});
}

NpyHeader ReadNpyHeader(const NpyFile& file) {
  CheckSignature(file);
  const std::size_t version = LittleEndian(file, kNpyMagic.size(), 1);
  if (version < 1 || version > 3) {
    file.Fail(kNpyMagic.size(), "NPY format " + std::to_string(version) + "; 1, 2 or 3 is due");
  }
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::size_t begin = kNpyMagic.size() + 2 + length_bytes;
  const std::size_t length = LittleEndian(file, kNpyMagic.size() + 2, length_bytes);
  if (file.bytes.size() - begin < length) file.Fail(file.bytes.size(), "an NPY file cut off here");
  const std::string_view dictionary(reinterpret_cast<const char*>(file.bytes.data()) + begin,
                                    length);

  NpyHeader header;
  const std::string_view type = ValueOf(file, dictionary, "descr");
  if (!type.starts_with('\'')) {
    file.Fail(begin, "an array of records", "save one array of plain numbers");
  }
  header.type = type.substr(1, type.find('\'', 1) - 1);
  header.fortran_order = ValueOf(file, dictionary, "fortran_order").starts_with("True");
  header.shape = ParseShape(file, ValueOf(file, dictionary, "shape"));
  header.data_begin = begin + length;
  return header;
}

std::string ShapeText(std::span<const std::size_t> shape) {
  std::string text;
  for (const std::size_t size : shape) text += (text.empty() ? "" : "x") + std::to_string(size);
  return text;
}

void RequireNpyLength(const NpyFile& file, const NpyHeader& header, std::size_t element_bytes) {
  const std::size_t there = file.bytes.size() - header.data_begin;
  std::size_t due = element_bytes;
  for (const std::size_t size : header.shape) {
    // Nothing longer than the file is due, so products that would wrap stop here.
    due = size != 0 && due > there / size ? there + 1 : due * size;
  }
  if (due == there) return;
  file.Fail(header.data_begin,
            std::to_string(there) + " bytes of data for " + ShapeText(header.shape) +
                " elements of " + std::to_string(element_bytes) + " bytes",
            "copy the file again");
}

}  // namespace handcraft::datasets
