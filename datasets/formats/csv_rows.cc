// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/csv_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

}  // namespace

CsvRows::CsvRows(std::filesystem::path path,
                 std::span<const std::string_view> columns,
                 std::span<const std::string_view> optional_columns)
    : records_(std::move(path)), columns_(columns), optional_columns_(optional_columns) {
  records_.RequireUtf8();
  if (!records_.Next(fields_)) {
    throw Error({.path = records_.path().string(),
                 .reason = "the file is empty",
                 .remedy = "its first line names the columns; see docs/datasets.md"});
  }
  num_fields_ = fields_.size();
  for (const std::string_view column : columns) {
    places_.push_back(Find(column));
    if (places_.back() != kMissing) continue;
    std::string names;
    for (const std::string_view name : columns)
      names += (names.empty() ? "" : ",") + std::string(name);
    Fail("no column " + Quoted(column), "the first line names the columns: " + names);
  }
  for (const std::string_view column : optional_columns) places_.push_back(Find(column));
}

std::size_t CsvRows::Find(std::string_view column) const {
  const auto found = std::find(fields_.begin(), fields_.end(), column);
  if (found == fields_.end()) return kMissing;
  if (std::find(found + 1, fields_.end(), column) != fields_.end()) {
    Fail("column " + Quoted(column) + " appears twice");
  }
  return static_cast<std::size_t>(found - fields_.begin());
}

std::string_view CsvRows::Name(std::size_t column) const {
  if (column < columns_.size()) return columns_[column];
  return optional_columns_[column - columns_.size()];
}

bool CsvRows::Next() {
  if (!records_.Next(fields_)) return false;
  if (fields_.size() != num_fields_) {
    Fail(std::to_string(fields_.size()) + " fields; the first line has " +
             std::to_string(num_fields_),
         "fill in what is missing; a field that holds a comma stands in quotes");
  }
  return true;
}

std::string_view CsvRows::Text(std::size_t column) const {
  HC_CHECK(column < places_.size(), column, places_.size());
  return places_[column] == kMissing ? std::string_view() : fields_[places_[column]];
}

std::string_view CsvRows::Required(std::size_t column) const {
  const std::string_view text = Text(column);
  if (text.empty()) Fail("no " + std::string(Name(column)) + " given", "fill in the column");
  return text;
}

double CsvRows::Number(std::size_t column) const {
  const std::string_view text = Trimmed(Text(column));
  const std::string where = "column " + Quoted(Name(column)) + ": ";
  if (text.empty()) Fail(where + "nothing where a number is due");
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    Fail(where + Quoted(text) + " where a number is due");
  }
  if (!std::isfinite(value)) Fail(where + Quoted(text) + " is not a finite number");
  return value;
}

void CsvRows::Fail(std::string reason, std::string remedy) const {
  records_.Fail(std::move(reason), std::move(remedy));
}

}  // namespace handcraft::datasets
