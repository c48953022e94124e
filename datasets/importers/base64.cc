// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/base64.h"

#include <cstddef>

namespace handcraft::datasets {

std::optional<std::vector<std::uint8_t>> DecodeBase64(std::string_view text) {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  std::size_t num_letters = 0;
  std::size_t num_padding = 0;
  for (const char letter : text) {
    if (letter == '\n' || letter == '\r') continue;
    if (letter == '=') {
      ++num_padding;
      continue;
    }
    const std::size_t value = kAlphabet.find(letter);
    if (value == std::string_view::npos || num_padding > 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (++num_letters % 4 == 1) continue;                            // six bits: not a byte yet
    const std::size_t num_new_bits = (4 - num_letters % 4) % 4 * 2;  // of the byte after
    bytes.push_back(static_cast<std::uint8_t>(bits >> num_new_bits));
  }
  if ((num_letters + num_padding) % 4 != 0 || num_padding > 2) return std::nullopt;
  return bytes;
}

}  // namespace handcraft::datasets
