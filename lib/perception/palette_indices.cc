// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/palette_indices.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "lib/core/error.h"
#include "lib/perception/png_crc.h"

namespace handcraft::perception {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kSignatureSize = 8;
constexpr std::size_t kHeaderChunkEnd = 33;  // of a PNG: signature, length, IHDR, 13 bytes, CRC
constexpr std::size_t kColourTypeAt = 25;
constexpr std::uint8_t kIndexed = 3;
constexpr std::uint8_t kGray = 0;

[[noreturn]] void Refuse(const std::filesystem::path& path,
                         std::string_view format,
                         const std::array<int, 3>& pixel_and_index,
                         std::size_t num_colours) {
  const auto& [u, v, index] = pixel_and_index;
  throw Error({.path = path.string(),
               .reason = "damaged " + std::string(format) + ": pixel (" + std::to_string(u) + ", " +
                         std::to_string(v) + ") has palette index " + std::to_string(index) +
                         ", but the palette has " + std::to_string(num_colours) +
                         (num_colours == 1 ? " colour" : " colours"),
               .remedy = "save it again from its source"});
}

std::uint32_t BigEndian(Bytes bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[at + i];
  return value;
}

// The chunks of a PNG of this type, length, type and CRC included, one behind the other.
std::vector<std::uint8_t> ChunksOf(Bytes bytes, std::string_view wanted) {
  std::vector<std::uint8_t> chunks;
  std::string_view type;
  for (std::size_t at = kSignatureSize; type != "IEND";) {
    const std::size_t size = std::size_t{12} + BigEndian(bytes, at);
    type = {reinterpret_cast<const char*>(&bytes[at + 4]), 4};
    const Bytes chunk = bytes.subspan(at, size);
    if (type == wanted) chunks.insert(chunks.end(), chunk.begin(), chunk.end());
    at += size;
  }
  return chunks;
}

// The same PNG with its indices for gray values, so that a decoder gives them away: without a
// palette, and of another colour type.
std::vector<std::uint8_t> AsGray(Bytes bytes) {
  std::vector<std::uint8_t> gray(bytes.begin(), bytes.begin() + kHeaderChunkEnd);
  gray[kColourTypeAt] = kGray;
  const std::uint32_t crc = PngCrc(Bytes(gray).subspan(kSignatureSize + 4, 17));
  for (std::size_t i = 0; i < 4; ++i) {
    gray[kHeaderChunkEnd - 4 + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
  }
  for (const std::string_view type : {"IDAT", "IEND"}) {
    const std::vector<std::uint8_t> chunks = ChunksOf(bytes, type);
    gray.insert(gray.end(), chunks.begin(), chunks.end());
  }
  return gray;
}

void CheckPng(const std::filesystem::path& path, Bytes bytes) {
  const int bits = bytes[kColourTypeAt - 1];
  if (bytes[kColourTypeAt] != kIndexed || bits > 8) return;
  const std::size_t palette_size = ChunksOf(bytes, "PLTE").size();
  const std::size_t num_colours = palette_size < 12 ? 0 : (palette_size - 12) / 3;
  const int greatest = (1 << bits) - 1;
  if (num_colours == 0 || num_colours > static_cast<std::size_t>(greatest)) return;
  const cv::Mat values = cv::imdecode(AsGray(bytes), cv::IMREAD_GRAYSCALE);
  for (int v = 0; v < values.rows; ++v) {
    for (int u = 0; u < values.cols; ++u) {
      const int index =
          values.at<std::uint8_t>(v, u) * greatest / 255;  // 1, 2 and 4 bits are spread
      if (static_cast<std::size_t>(index) < num_colours) continue;
      Refuse(path, "PNG", {u, v, index}, num_colours);
    }
  }
}

std::uint32_t LittleEndian(Bytes bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | bytes[at + i];
  return value;
}

void CheckBmp(const std::filesystem::path& path, Bytes bytes) {
  constexpr std::size_t kNumIndices = 256;
  const std::size_t num_colours = LittleEndian(bytes, 46);
  if (bytes[28] != 8 || num_colours == 0 || num_colours >= kNumIndices) return;
  const auto width = static_cast<int>(LittleEndian(bytes, 18));
  const auto stored_height = static_cast<std::int32_t>(LittleEndian(bytes, 22));
  const int height = std::abs(stored_height);  // < 0: top row first
  const std::size_t row_bytes = (static_cast<std::size_t>(width) + 3) / 4 * 4;
  const std::size_t start = LittleEndian(bytes, 10);
  for (int v = 0; v < height; ++v) {
    const auto row = static_cast<std::size_t>(stored_height < 0 ? v : height - 1 - v);
    for (int u = 0; u < width; ++u) {
      const int index = bytes[start + row * row_bytes + static_cast<std::size_t>(u)];
      if (static_cast<std::size_t>(index) < num_colours) continue;
      Refuse(path, "BMP", {u, v, index}, num_colours);
    }
  }
}

}  // namespace

void CheckPaletteIndices(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  if (bytes[0] == 0x89) CheckPng(path, bytes);
  if (bytes[0] == 'B') CheckBmp(path, bytes);
}

}  // namespace handcraft::perception
