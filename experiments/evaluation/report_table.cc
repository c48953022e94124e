// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/report_table.h"

#include <string_view>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"

namespace handcraft::experiments {
namespace {

std::string Joined(const std::vector<std::string>& cells,
                   std::string_view between,
                   std::string_view before,
                   std::string_view after) {
  std::string line(before);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += between;
    line += cells[i];
  }
  return line + std::string(after) + "\n";
}

// RFC 4180: a cell with a comma or a quote is quoted.
std::string CsvCell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// Of "61.7 [55.4, 67.6] of 240" what follows the value stands below it, which keeps columns narrow.
std::string WithRangeBelow(const std::string& text) {
  const std::size_t range = text.find(" [");
  if (range == std::string::npos || range == 0) return EscapeHtml(text);
  return fmt::format("{}<span class=\"range\">{}</span>",
                     EscapeHtml(text.substr(0, range)),
                     EscapeHtml(text.substr(range + 1)));
}

}  // namespace

std::string CsvText(const ReportTable& table) {
  std::string text;
  const auto add = [&](std::vector<std::string> cells) {
    for (std::string& cell : cells) cell = CsvCell(cell);
    text += Joined(cells, ",", "", "");
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return text;
}

std::string MarkdownText(const ReportTable& table) {
  std::string text = Joined(table.head, " | ", "| ", " |");
  text += Joined(std::vector<std::string>(table.head.size(), "---"), "|", "|", "|");
  for (const auto& row : table.rows) text += Joined(row, " | ", "| ", " |");
  return text + "\n";
}

std::string HtmlText(const ReportTable& table) {
  std::string text = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    text += fmt::format(
        "<th{}>{}</th>", i > 0 ? " class=\"number\"" : "", BreakableHtml(table.head[i]));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i == 0 ? fmt::format("<th>{}</th>", BreakableHtml(row[i]))
                     : fmt::format("<td class=\"number\">{}</td>", WithRangeBelow(row[i]));
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n";
}

}  // namespace handcraft::experiments
