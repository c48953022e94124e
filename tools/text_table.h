// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace handcraft::tools {

/// A table for people: columns two spaces apart, words to the left, numbers to the right. A column
/// counts as numbers when every cell below its head starts with a digit, a sign or is "-".
class TextTable {
 public:
  /// A table without head when `head` is empty.
  explicit TextTable(std::vector<std::string> head = {});

  /// Control characters in a cell are written as OnOneLine does.
  void AddRow(std::vector<std::string> cells);

  /// The lines, each ended by a newline, no blanks at their ends.
  [[nodiscard]] std::string ToText() const;

 private:
  bool has_head_;
  std::vector<std::vector<std::string>> rows_;  ///< the head first, if there is one
};

}  // namespace handcraft::tools
