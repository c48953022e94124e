// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/answer_table.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"

namespace handcraft::experiments {
namespace {

std::string CountCell(std::size_t count, std::size_t row_total, bool is_right) {
  if (count == 0) return "<td class=\"number\"></td>";
  const double share = static_cast<double>(count) / static_cast<double>(row_total);
  return fmt::format(
      "<td class=\"number\" title=\"{}\" style=\"background: rgba({}, {:.2f})\">{}</td>",
      PercentText(share),
      is_right ? "20, 140, 130" : "205, 95, 40",
      0.08 + 0.5 * share,
      count);
}

// Of the table: many columns are narrow, and have their names upright where these are long or many.
std::string ClassesOf(const AnswerCounts& answers) {
  constexpr std::size_t kMostWideColumns = 8;
  constexpr std::size_t kMostLevelNames = 24;
  constexpr std::size_t kShortName = 6;
  if (answers.columns.size() <= kMostWideColumns) return "";
  const bool is_upright =
      answers.columns.size() > kMostLevelNames ||
      std::any_of(answers.columns.begin(), answers.columns.end(), [](const std::string& name) {
        return name.size() > kShortName;
      });
  return is_upright ? " class=\"dense upright\"" : " class=\"dense\"";
}

}  // namespace

std::string AnswerTable(const AnswerCounts& answers) {
  std::string text = fmt::format("<div class=\"scroll\"><table{}>\n<thead><tr><th>{}</th>",
                                 ClassesOf(answers),
                                 EscapeHtml(answers.row_title));
  for (const std::string& column : answers.columns) {
    text += fmt::format("<th class=\"number\"><span>{}</span></th>", BreakableHtml(column));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < answers.rows.size(); ++row) {
    const std::vector<std::size_t>& counts = answers.counts[row];
    const std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    text += fmt::format("<tr><th scope=\"row\">{}</th>", EscapeHtml(answers.rows[row]));
    for (std::size_t column = 0; column < counts.size(); ++column) {
      text += CountCell(counts[column], total, answers.is_right[row][column]);
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n";
}

}  // namespace handcraft::experiments
