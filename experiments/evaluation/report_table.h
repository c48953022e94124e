// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace handcraft::experiments {

/// A table of a report: texts that are ready to be shown, every row as long as the head.
struct ReportTable {
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};
};

/// RFC 4180 with line feeds: a cell with a comma, a quote or a line feed is quoted.
[[nodiscard]] std::string CsvText(const ReportTable& table);

/// With an empty line after it.
[[nodiscard]] std::string MarkdownText(const ReportTable& table);

/// Inside a page of experiments/evaluation/html_text.h: the first column are the names of the rows,
/// the others stand to the right. Everything is escaped.
[[nodiscard]] std::string HtmlText(const ReportTable& table);

}  // namespace handcraft::experiments
