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

/// Writes a JPEG that is stored `width` wide, left half white and right half black, with Exif
/// orientation 6 behind the start of the image: turned by 90° clockwise, it is `height` wide and
/// its upper half is white.
inline void WriteTurnedJpeg(const std::filesystem::path& path, int width, int height) {
  cv::Mat pixels(height, width, CV_8UC1, cv::Scalar(0));
  pixels.colRange(0, width / 2).setTo(255);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", pixels, bytes);
  constexpr auto kExif = std::to_array<std::uint8_t>(
      {0xFF, 0xE1, 0x00, 0x22, 'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8,
       0,    1,    1,    0x12, 0,   3,   0,   0,   0, 1, 0,   6,   0, 0,  0, 0, 0, 0});
  bytes.insert(bytes.begin() + 2, kExif.begin(), kExif.end());
  WriteFileAtomically(path, bytes);
}

}  // namespace handcraft::testing
