// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "lib/core/image.h"

namespace handcraft::datasets {

/// A value that a mask may hold, and what it stands for.
struct MaskValue {
  std::uint8_t value = 0;
  std::string_view meaning;
};

/// Reads a gray picture of 8 bits that holds these values alone. Throws Error naming file, column
/// and row of the first other value and the values that are due, and for what cannot be read.
[[nodiscard]] Image ReadMaskPicture(const std::filesystem::path& path,
                                    std::span<const MaskValue> values);

/// Values of an object mask.
inline constexpr std::uint8_t kObject = 255;
inline constexpr std::uint8_t kNoObject = 0;

/// The same of an object mask: its two values alone.
[[nodiscard]] Image ReadObjectMask(const std::filesystem::path& path);

/// Width and height [px]; as wide as numbers that stand in a foreign file.
using PixelSize = std::array<std::int64_t, 2>;

/// The size of a picture, a mask or an organised cloud.
template <class Picture>
[[nodiscard]] PixelSize SizeOf(const Picture& picture) {
  if constexpr (requires { picture.width(); }) {
    return {picture.width(), picture.height()};
  } else {
    return {picture.width, picture.height};
  }
}

/// Throws Error that says "<what> is 3x2 pixels, its picture 4x2" unless the sizes agree.
void RequireSameSize(const std::filesystem::path& path,
                     std::string_view what,
                     const PixelSize& size,
                     const PixelSize& picture_size);

}  // namespace handcraft::datasets
