// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace handcraft {

/// A number of things as people read it: "1 page", "2 pages", "0 classes". `many` is what more than
/// one, or none, are called; empty: `one` with an s.
template <std::integral Count>
[[nodiscard]] std::string Counted(Count count, std::string_view one, std::string_view many = {}) {
  std::string text = std::to_string(count);
  text += ' ';
  text += count == 1 || many.empty() ? one : many;
  if (count != 1 && many.empty()) text += 's';
  return text;
}

}  // namespace handcraft
