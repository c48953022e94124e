// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace handcraft {

/// Bytes at the front of the text that are UTF-8: shortest forms only, no surrogates, up to
/// U+10FFFF; text.size() when all of it is. Source: RFC 3629.
[[nodiscard]] std::size_t Utf8PrefixLength(std::string_view text) noexcept;

[[nodiscard]] inline bool IsUtf8(std::string_view text) noexcept {
  return Utf8PrefixLength(text) == text.size();
}

/// The text on one line, for messages and tables: each control character (U+0000 to U+001F and
/// U+007F: a line end, a tab, what terminals take for a command) is written \n, \t, \r or \xNN.
[[nodiscard]] std::string OnOneLine(std::string_view text);

}  // namespace handcraft
