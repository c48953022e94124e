// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/utf8.h"

namespace handcraft {
namespace {

bool IsControlCharacter(char c) noexcept {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

// Bytes of the UTF-8 sequence that this lead byte announces; 0: not a lead byte.
std::size_t SequenceLength(unsigned char lead) noexcept {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

// The second byte's range is narrower after some leads (RFC 3629, section 4).
bool IsSecondByte(unsigned char lead, unsigned char second) noexcept {
  const unsigned char low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned char high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  return second >= low && second <= high;
}

}  // namespace

std::size_t Utf8PrefixLength(std::string_view text) noexcept {
  std::size_t i = 0;
  while (i < text.size()) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = SequenceLength(lead);
    if (length == 0 || length > text.size() - i) return i;
    if (length > 1 && !IsSecondByte(lead, static_cast<unsigned char>(text[i + 1]))) return i;
    for (std::size_t k = 2; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) return i;
    }
    i += length;
  }
  return i;
}

std::string OnOneLine(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string line;
  for (const char c : text) {
    if (!IsControlCharacter(c)) {
      line += c;
    } else if (c == '\n' || c == '\t' || c == '\r') {
      line.append(c == '\n' ? "\\n" : c == '\t' ? "\\t" : "\\r");
    } else {
      const auto byte = static_cast<unsigned char>(c);
      line.append("\\x").append({kDigits[byte / 16], kDigits[byte % 16]});
    }
  }
  return line;
}

}  // namespace handcraft
