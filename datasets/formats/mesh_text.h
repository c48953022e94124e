// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace handcraft::datasets {

/// Walks a text file of meshes line by line, each cut into words at blanks. Lines end with LF or
/// CRLF; a line that ends with a backslash goes on in the next one; empty lines are skipped. The
/// text must outlive the object.
class MeshText {
 public:
  /// Lines count from `first_line`.
  MeshText(std::filesystem::path path, std::string_view text, std::size_t first_line = 1);

  /// Moves to the next line that has a word; false at the end.
  [[nodiscard]] bool Next();

  [[nodiscard]] const std::vector<std::string_view>& words() const noexcept { return words_; }
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// Bytes of the text that are behind the line.
  [[nodiscard]] std::size_t at() const noexcept { return at_; }

  /// The words from the i-th on, joined by blanks.
  [[nodiscard]] std::string From(std::size_t i) const;

  /// Word i as a finite number, or as a whole number within [lowest, highest]. Throws Error naming
  /// file, line and word when it is not there or is anything else.
  [[nodiscard]] float Number(std::size_t i) const;
  [[nodiscard]] std::int64_t Whole(std::size_t i, std::int64_t lowest, std::int64_t highest) const;

  /// Throws Error naming file and line.
  [[noreturn]] void Fail(std::string reason, std::string remedy = {}) const;

 private:
  std::filesystem::path path_;
  std::string_view text_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
  std::size_t next_line_;
  std::size_t line_ = 0;
};

}  // namespace handcraft::datasets
