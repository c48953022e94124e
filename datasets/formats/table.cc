// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "datasets/formats/csv_records.h"
#include "datasets/formats/libsvm_table.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

std::string QuotedBriefly(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  const bool is_long = text.size() > kLongest;
  return "'" + std::string(text.substr(0, kLongest)) + (is_long ? "…'" : "'");
}

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

// A number in decimal or scientific notation, nothing before or behind it but blanks.
std::optional<double> ParseNumber(std::string_view text) {
  text = Trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string ListOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    list += (i == 0 ? "" : ", ") + QuotedBriefly(names[i]);
  }
  if (names.size() > kMost) list += ", … (" + std::to_string(names.size()) + " in all)";
  return list;
}

[[noreturn]] void FailLabelColumn(const fs::path& path,
                                  const std::string& label_column,
                                  const std::string& there_are) {
  throw Error({.kind = Error::Kind::kUsage,
               .path = path.string(),
               .reason = "no column " + QuotedBriefly(label_column) + "; " + there_are});
}

std::vector<std::string> ReadColumnNames(CsvRecords& records,
                                         const std::vector<std::string_view>& header) {
  std::vector<std::string> names;
  std::set<std::string_view> seen;
  for (const std::string_view field : header) {
    const std::string_view name = Trimmed(field);
    if (name.empty()) {
      records.Fail("column " + std::to_string(names.size() + 1) + " has no name",
                   "the first line names the columns");
    }
    if (!seen.insert(name).second) records.Fail("column " + QuotedBriefly(name) + " appears twice");
    names.emplace_back(name);
  }
  if (names.size() == 1 && names[0].find(';') != std::string::npos) {
    records.Fail("one column with ';' in its name", "separate fields by commas");
  }
  return names;
}

[[noreturn]] void FailNumber(const CsvRecords& records,
                             const std::string& column,
                             std::string_view text) {
  const std::string where = "column " + QuotedBriefly(column) + ": ";
  if (Trimmed(text).empty()) {
    records.Fail(where + "nothing where a number is due", "fill the gap or remove the line");
  }
  const std::optional<double> value = ParseNumber(text);
  if (value)
    records.Fail(where + QuotedBriefly(text) + " is not a finite number", "remove the line");
  records.Fail(where + QuotedBriefly(text) + " where a number is due");
}

// For each column, whether it is read as numbers.
std::vector<bool> ChooseFeatures(const std::vector<std::string>& names,
                                 std::size_t label,
                                 const std::vector<std::string>& wanted) {
  std::vector<bool> is_feature(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_wanted =
        wanted.empty() || std::find(wanted.begin(), wanted.end(), names[i]) != wanted.end();
    is_feature[i] = i != label && is_wanted;
  }
  return is_feature;
}

Table ReadCsvTable(const fs::path& path,
                   const std::string& label_column,
                   const std::vector<std::string>& wanted) {
  CsvRecords records(path);
  records.RequireUtf8();
  std::vector<std::string_view> fields;
  if (!records.Next(fields)) throw Error({.path = path.string(), .reason = "the file is empty"});
  const std::vector<std::string> names = ReadColumnNames(records, fields);
  const auto label =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), label_column) - names.begin());
  if (!label_column.empty() && label == names.size()) {
    FailLabelColumn(path, label_column, "there are: " + ListOf(names));
  }
  const std::vector<bool> is_feature = ChooseFeatures(names, label, wanted);
  Table table;
  table.label_column = label_column;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_feature[i]) table.columns.push_back(names[i]);
  }
  while (records.Next(fields)) {
    if (fields.size() != names.size()) {
      records.Fail(std::to_string(fields.size()) + " fields; the first line has " +
                   std::to_string(names.size()));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (!is_feature[i]) continue;
      const std::optional<double> value = ParseNumber(fields[i]);
      if (!value || !std::isfinite(*value)) FailNumber(records, names[i], fields[i]);
      table.values.push_back(*value);
    }
    if (label < names.size()) {
      table.labels.emplace_back(Trimmed(fields[label]));
      if (table.labels.back().empty())
        records.Fail("no label in column " + QuotedBriefly(names[label]));
    }
    ++table.num_rows;
  }
  return table;
}

// The label column of an NPY file by number, −1 the last; num_columns when there is none.
std::size_t NpyLabelColumn(const fs::path& path,
                           const std::string& label_column,
                           std::size_t num_columns) {
  if (label_column.empty()) return num_columns;
  if (label_column == "-1" && num_columns > 0) return num_columns - 1;
  std::size_t index = 0;
  const char* const text_end = label_column.data() + label_column.size();
  const auto [end, error] = std::from_chars(label_column.data(), text_end, index);
  if (error == std::errc() && end == text_end && index < num_columns) return index;
  FailLabelColumn(path,
                  label_column,
                  "the columns of an NPY file are numbers from 0 to " +
                      std::to_string(num_columns - std::min<std::size_t>(num_columns, 1)) +
                      ", -1 is the last");
}

Table ReadNpyTable(const fs::path& path, const std::string& label_column) {
  const NpyMatrix matrix = ReadNpy(path);
  if (matrix.columns == 0) throw Error({.path = path.string(), .reason = "no column of numbers"});
  const std::size_t label = NpyLabelColumn(path, label_column, matrix.columns);
  Table table;
  table.num_rows = matrix.rows;
  for (std::size_t column = 0; column < matrix.columns; ++column) {
    if (column != label) table.columns.push_back(std::to_string(column));
  }
  if (label < matrix.columns) table.label_column = std::to_string(label);
  table.values.reserve(matrix.rows * table.columns.size());
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    if (i % matrix.columns == label) {
      table.labels.push_back(NumberToText(matrix.values[i]));
    } else {
      table.values.push_back(matrix.values[i]);
    }
  }
  return table;
}

// Numbers in numeric order before words in alphabetical order.
bool LabelLess(const std::string& a, const std::string& b) {
  const auto rank = [](const std::string& label) {
    const std::optional<double> value = ParseNumber(label);
    const bool is_number = value && std::isfinite(*value);
    return std::tuple(!is_number, is_number ? *value : 0.0, label);
  };
  return rank(a) < rank(b);
}

}  // namespace

Table ReadTable(const fs::path& path,
                const std::string& label_column,
                const std::vector<std::string>& wanted) {
  Table table;
  if (IsLibsvmText(path)) {
    if (!label_column.empty() && label_column != "label") {
      FailLabelColumn(path, label_column, "a file of libsvm has labels without a name, or 'label'");
    }
    table = ReadLibsvmTable(path, wanted.size());
  } else if (path.extension() == ".npy" || IsNpy(path)) {
    table = ReadNpyTable(path, label_column);
  } else {
    table = ReadCsvTable(path, label_column, wanted);
  }
  if (table.num_rows == 0) throw Error({.path = path.string(), .reason = "no row of numbers"});
  if (table.columns.empty() && wanted.empty()) {
    throw Error({.path = path.string(), .reason = "no column of numbers beside the label"});
  }
  return table;
}

BinaryLabels ToBinaryLabels(const Table& table, const fs::path& path) {
  const std::set<std::string> alphabetical(table.labels.begin(), table.labels.end());
  std::vector<std::string> distinct(alphabetical.begin(), alphabetical.end());
  std::sort(distinct.begin(), distinct.end(), LabelLess);
  if (distinct.size() != 2) {
    throw Error({.path = path.string(),
                 .reason = "column " + QuotedBriefly(table.label_column) + " holds " +
                           std::to_string(distinct.size()) + " labels" +
                           (distinct.empty() ? "" : ": ") + ListOf(distinct) +
                           "; exactly two are due",
                 .remedy = "choose the label column with --label"});
  }
  BinaryLabels labels{.negative = distinct[0], .positive = distinct[1], .values = {}};
  labels.values.reserve(table.labels.size());
  for (const std::string& label : table.labels) {
    labels.values.push_back(label == labels.positive ? 1 : 0);
  }
  return labels;
}

ClassLabels ToClassLabels(const Table& table, const fs::path& path) {
  ClassLabels labels;
  labels.values.reserve(table.labels.size());
  std::map<std::string_view, std::uint32_t> numbers;
  for (const std::string& label : table.labels) {
    const auto [entry, is_new] =
        numbers.try_emplace(label, static_cast<std::uint32_t>(labels.names.size()));
    if (is_new) labels.names.push_back(label);
    labels.values.push_back(entry->second);
  }
  if (labels.names.size() >= 2) return labels;
  throw Error({.path = path.string(),
               .reason = "column " + QuotedBriefly(table.label_column) + " holds " +
                         std::to_string(labels.names.size()) + " labels" +
                         (labels.names.empty() ? "" : ": ") + ListOf(labels.names) +
                         "; at least two are due",
               .remedy = "choose the label column with --label"});
}

}  // namespace handcraft::datasets
