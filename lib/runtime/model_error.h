// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::runtime {

/// Why a model was refused: the C interface's own type, passed by value inside the runtime.
using ModelError = hc_error;

/// The offset of an error that lies nowhere in the file.
inline constexpr std::uint64_t kNoOffset = UINT64_MAX;

/// An error with a printf-style message, cut to fit. Does not allocate.
[[nodiscard]] __attribute__((format(printf, 3, 4))) ModelError MakeError(hc_status status,
                                                                         std::uint64_t byte_offset,
                                                                         const char* format,
                                                                         ...) noexcept;

/// Text from a file made fit for a message: at most 40 bytes, anything but printable ASCII as '?',
/// cut text ends in "...". Use as Printable(text).c_str() within one expression.
class Printable {
 public:
  explicit Printable(std::string_view text) noexcept;
  [[nodiscard]] const char* c_str() const noexcept { return buffer_.data(); }

 private:
  std::array<char, 44> buffer_{};
};

}  // namespace handcraft::runtime
