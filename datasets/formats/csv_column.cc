// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/csv_column.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "datasets/formats/csv_records.h"
#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

void AppendRecord(const std::vector<std::string_view>& fields, std::string& text) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    text.append(i == 0 ? "" : ",").append(CsvField(fields[i]));
  }
  text += '\n';
}

}  // namespace

void RewriteCsvColumn(const std::filesystem::path& path,
                      std::string_view column,
                      std::span<const std::string> values) {
  CsvRecords records(path);
  std::vector<std::string_view> fields;
  if (!records.Next(fields)) throw Error({.path = path.string(), .reason = "the file is empty"});
  const auto found = std::find(fields.begin(), fields.end(), column);
  if (found == fields.end()) records.Fail("no column " + Quoted(column));
  const auto place = static_cast<std::size_t>(found - fields.begin());
  std::string text;
  AppendRecord(fields, text);
  std::size_t num_rows = 0;
  while (records.Next(fields)) {
    if (place >= fields.size()) records.Fail("the row ends before column " + Quoted(column));
    if (num_rows < values.size()) fields[place] = values[num_rows];
    AppendRecord(fields, text);
    ++num_rows;
  }
  if (num_rows != values.size()) {
    throw Error({.path = path.string(),
                 .reason = std::to_string(num_rows) + " rows; " + std::to_string(values.size()) +
                           " are due",
                 .remedy = "was the file changed meanwhile?"});
  }
  WriteFileAtomically(path, text);
}

}  // namespace handcraft::datasets
