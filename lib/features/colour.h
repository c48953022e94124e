// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

namespace handcraft::features {

/// How the bytes of a pixel are to be read. The numbers are part of the C interface.
enum class PixelFormat : std::uint8_t { kGray8 = 0, kBgr8 = 1, kRgb8 = 2 };

[[nodiscard]] constexpr int NumChannels(PixelFormat format) noexcept {
  return format == PixelFormat::kGray8 ? 1 : 3;
}

/// An 8-bit picture in the caller's memory; row v starts at data + v · stride_bytes.
struct RawImage {
  const std::uint8_t* data = nullptr;
  int width = 0;   ///< [px]
  int height = 0;  ///< [px]
  std::ptrdiff_t stride_bytes = 0;
  PixelFormat format = PixelFormat::kGray8;
};

/// Y'CbCr of one pixel in ITU-R BT.601 full range, rounded to 8 bits exactly as OpenCV's
/// COLOR_BGR2YCrCb does it (14-bit fixed point):
///   Y = 0.299 R + 0.587 G + 0.114 B,  Cr = 0.713 (R − Y) + 128,  Cb = 0.564 (B − Y) + 128.
struct Ycbcr {
  std::uint8_t y, cb, cr;
};
[[nodiscard]] Ycbcr ToYcbcr(std::uint8_t r, std::uint8_t g, std::uint8_t b) noexcept;

}  // namespace handcraft::features
