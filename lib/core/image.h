// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/core/check.h"

namespace handcraft {

/// A read-only picture somewhere in memory: rows of `width` pixels with `channels` interleaved
/// values, the first pixel of row y at data + y * stride (stride counted in values, not bytes).
/// u points right, v down; (0, 0) is the centre of the top-left pixel.
template <class T>
struct ImageView {
  const T* data = nullptr;
  int width = 0;   ///< [px]
  int height = 0;  ///< [px]
  int channels = 1;
  std::ptrdiff_t stride = 0;  ///< Values from one row to the next.

  [[nodiscard]] const T* Row(int y) const noexcept { return data + y * stride; }
  [[nodiscard]] const T& At(int x, int y, int channel = 0) const noexcept {
    return data[y * stride + static_cast<std::ptrdiff_t>(x) * channels + channel];
  }
};

/// A picture that owns its pixels, rows packed without gaps.
template <class T>
class BasicImage {
 public:
  BasicImage() = default;
  BasicImage(int width, int height, int channels = 1, T fill = T{})
      : width_(width), height_(height), channels_(channels) {
    HC_CHECK(width >= 0 && height >= 0 && channels >= 1, width, height, channels);
    values_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                       static_cast<std::size_t>(channels),
                   fill);
  }

  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }
  [[nodiscard]] int channels() const noexcept { return channels_; }
  [[nodiscard]] bool empty() const noexcept { return values_.empty(); }
  [[nodiscard]] const std::vector<T>& values() const noexcept { return values_; }
  [[nodiscard]] T* Row(int y) noexcept { return values_.data() + y * Stride(); }
  [[nodiscard]] const T* Row(int y) const noexcept { return values_.data() + y * Stride(); }
  [[nodiscard]] T& At(int x, int y, int channel = 0) noexcept {
    return Row(y)[static_cast<std::ptrdiff_t>(x) * channels_ + channel];
  }
  [[nodiscard]] const T& At(int x, int y, int channel = 0) const noexcept {
    return Row(y)[static_cast<std::ptrdiff_t>(x) * channels_ + channel];
  }
  [[nodiscard]] ImageView<T> View() const noexcept {
    return {values_.data(), width_, height_, channels_, Stride()};
  }

 private:
  [[nodiscard]] std::ptrdiff_t Stride() const noexcept {
    return static_cast<std::ptrdiff_t>(width_) * channels_;
  }

  int width_ = 0;
  int height_ = 0;
  int channels_ = 1;
  std::vector<T> values_;
};

/// 8-bit picture: 1 channel is gray, 3 channels are blue, green, red (OpenCV's order).
using Image = BasicImage<std::uint8_t>;
using FloatImage = BasicImage<float>;

}  // namespace handcraft
