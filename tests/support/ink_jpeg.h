// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "lib/core/file.h"

namespace handcraft::testing {

/// Writes a baseline JPEG of four inks (cyan, magenta, yellow, black), each 128 everywhere: one
/// zero bit says that a block's mean does not change, another that nothing else follows. Source:
/// ITU-T T.81, annex B.
inline void WriteInkJpeg(const std::filesystem::path& path, int width, int height) {
  constexpr std::size_t kInks = 4;
  std::vector<std::uint8_t> bytes = {0xFF, 0xD8, 0xFF, 0xDB, 0x00, 0x43, 0x00};
  bytes.insert(bytes.end(), 64, 1);  // each quantized by 1
  const auto append = [&bytes](const auto& values) {
    for (const int value : values) bytes.push_back(static_cast<std::uint8_t>(value));
  };
  append(std::array{0xFF, 0xC0, 0x00, 0x14, 8, height >> 8, height, width >> 8, width, 4});
  for (int ink = 1; ink <= 4; ++ink) append(std::array{ink, 0x11, 0x00});
  for (const int table : {0x00, 0x10}) {  // of means and of the rest: the code 0 stands for 0
    append(std::array{0xFF, 0xC4, 0x00, 0x14, table, 1});
    bytes.insert(bytes.end(), 16, 0);
  }
  append(std::array{0xFF, 0xDA, 0x00, 0x0E, 4, 1, 0, 2, 0, 3, 0, 4, 0, 0, 63, 0});
  const auto blocks = static_cast<std::size_t>(((width + 7) / 8) * ((height + 7) / 8));
  bytes.insert(bytes.end(), blocks * kInks * 2 / 8, 0x00);
  append(std::array{0xFF, 0xD9});
  WriteFileAtomically(path, bytes);
}

}  // namespace handcraft::testing
