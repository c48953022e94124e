// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "lib/core/file.h"

namespace handcraft::testing {

/// Writes a JPEG that is stored `width` wide, left half white and right half black, with this Exif
/// orientation behind the start of the image. By 6 it is turned by 90° clockwise: `height` wide,
/// its upper half white.
inline void WriteTurnedJpeg(const std::filesystem::path& path,
                            int width,
                            int height,
                            std::uint16_t orientation = 6) {
  cv::Mat pixels(height, width, CV_8UC1, cv::Scalar(0));
  pixels.colRange(0, width / 2).setTo(255);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", pixels, bytes);
  const auto high = static_cast<std::uint8_t>(orientation >> 8);
  const auto low = static_cast<std::uint8_t>(orientation & 0xFF);
  const auto exif = std::to_array<std::uint8_t>(
      {0xFF, 0xE1, 0x00, 0x22, 'E', 'x', 'i', 'f', 0, 0, 'M',  'M', 0, 42, 0, 0, 0, 8,
       0,    1,    1,    0x12, 0,   3,   0,   0,   0, 1, high, low, 0, 0,  0, 0, 0, 0});
  bytes.insert(bytes.begin() + 2, exif.begin(), exif.end());
  WriteFileAtomically(path, bytes);
}

}  // namespace handcraft::testing
