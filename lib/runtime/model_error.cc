// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_error.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace handcraft::runtime {

ModelError MakeError(hc_status status,
                     std::uint64_t byte_offset,
                     const char* format,
                     ...) noexcept {
  ModelError error{status, byte_offset, {}};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(error.message, sizeof error.message, format, arguments);
  va_end(arguments);
  return error;
}

Printable::Printable(std::string_view text) noexcept {
  constexpr std::size_t kMaxBytes = 40;
  const std::size_t shown = std::min(text.size(), kMaxBytes);
  std::transform(
      text.begin(), text.begin() + static_cast<std::ptrdiff_t>(shown), buffer_.begin(), [](char c) {
        return c >= ' ' && c <= '~' ? c : '?';
      });
  if (text.size() > kMaxBytes) std::fill_n(buffer_.begin() + kMaxBytes, 3, '.');
}

}  // namespace handcraft::runtime
