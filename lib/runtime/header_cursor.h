// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lib/runtime/model_error.h"

namespace handcraft::runtime {

/// Walks over the JSON header of a model file (docs/model_format.md § 2.1), piece by piece, from
/// front to back. The header has one fixed depth, so nothing here recurses.
///
/// Every function returns whether the piece was there; the first that was not sets error() with
/// its place in the file, and from then on all fail. Strings allocate (std::bad_alloc).
class HeaderCursor {
 public:
  /// `text` lies at `file_offset` in the file.
  HeaderCursor(std::span<const std::uint8_t> text, std::uint64_t file_offset) noexcept
      : text_(text), file_offset_(file_offset) {}

  /// Steps over exactly these bytes.
  bool Expect(std::string_view literal) noexcept;
  /// Steps over `c` if it comes next; else nothing happens. False after an error as well.
  bool TakeIf(char c) noexcept;
  /// A string of at most max_bytes, escapes resolved (\" \\ \n \t and no other), valid UTF-8.
  bool ReadString(std::size_t max_bytes, std::string& value);
  /// A whole number from 0 to 2^53, without sign, fraction, exponent or leading zero.
  bool ReadInteger(std::uint64_t& value) noexcept;
  /// Steps over the spaces that pad the header, fewer than 64; nothing else may follow.
  bool ExpectPaddingToEnd() noexcept;

  /// The place of the next byte in the file.
  [[nodiscard]] std::uint64_t Offset() const noexcept { return file_offset_ + position_; }
  /// Sets the error, unless there is one already; always false.
  bool Fail(const ModelError& error) noexcept;
  [[nodiscard]] bool Failed() const noexcept { return error_.has_value(); }
  [[nodiscard]] const ModelError& error() const noexcept { return *error_; }

 private:
  [[nodiscard]] bool AtEnd() const noexcept { return position_ == text_.size(); }
  bool FailExpecting(const char* expected) noexcept;
  bool ReadCharacter(std::string& value);

  std::span<const std::uint8_t> text_;
  std::uint64_t file_offset_;
  std::size_t position_ = 0;
  std::optional<ModelError> error_;
};

}  // namespace handcraft::runtime
