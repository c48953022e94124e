// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/text_table.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "lib/core/utf8.h"

namespace handcraft::tools {
namespace {

// Characters, not bytes: continuation bytes of UTF-8 (10xxxxxx) take no column.
std::size_t DisplayWidth(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

bool LooksLikeANumber(std::string_view text) {
  return text.empty() || text == "-" || text == "–" || text == "nan" ||
         text.find_first_of("0123456789") == (text.find_first_of("+-") == 0 ? 1U : 0U);
}

}  // namespace

TextTable::TextTable(std::vector<std::string> head) : has_head_(!head.empty()) {
  if (has_head_) rows_.push_back(std::move(head));
}

void TextTable::AddRow(std::vector<std::string> cells) {
  for (std::string& cell : cells) cell = OnOneLine(cell);
  rows_.push_back(std::move(cells));
}

std::string TextTable::ToText() const {
  std::vector<std::size_t> widths;
  std::vector<bool> to_the_right;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    widths.resize(std::max(widths.size(), rows_[i].size()), 0);
    to_the_right.resize(widths.size(), true);
    for (std::size_t j = 0; j < rows_[i].size(); ++j) {
      widths[j] = std::max(widths[j], DisplayWidth(rows_[i][j]));
      if ((i > 0 || !has_head_) && !LooksLikeANumber(rows_[i][j])) to_the_right[j] = false;
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : rows_) {
    std::string line;
    for (std::size_t j = 0; j < row.size(); ++j) {
      const std::string padding(widths[j] - DisplayWidth(row[j]), ' ');
      if (j > 0) line += "  ";
      line += to_the_right[j] ? padding + row[j] : row[j] + padding;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace handcraft::tools
