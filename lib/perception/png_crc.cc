// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/png_crc.h"

#include <array>

namespace handcraft::perception {

std::uint32_t PngCrc(std::span<const std::uint8_t> bytes) noexcept {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      table[n] = n;
      for (int bit = 0; bit < 8; ++bit) {
        table[n] = (table[n] >> 1) ^ ((table[n] & 1U) != 0 ? 0xEDB88320U : 0U);
      }
    }
    return table;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = kTable[(crc ^ byte) & 0xFFU] ^ (crc >> 8);
  return ~crc;
}

}  // namespace handcraft::perception
