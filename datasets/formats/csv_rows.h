// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/csv_records.h"

namespace handcraft::datasets {

/// Walks a CSV file whose first line names its columns, which may stand in any order; columns that
/// are not asked for are passed over. A field is asked for by the place of its column in the list
/// given to the constructor. Text must be UTF-8. Source: RFC 4180, docs/datasets.md "CSV".
class CsvRows {
 public:
  /// Reads the whole file and its first line. Both lists must outlive the object. Throws Error when
  /// the file cannot be read or is empty, and with line 1 for a column that is there twice or, if
  /// it is not optional, missing.
  explicit CsvRows(std::filesystem::path path,
                   std::span<const std::string_view> columns,
                   std::span<const std::string_view> optional_columns = {});

  /// Moves to the next row; false at the end. Throws Error with the line for a row with more or
  /// fewer fields than the first line has.
  [[nodiscard]] bool Next();

  /// The column's name, as it was asked for.
  [[nodiscard]] std::string_view Name(std::size_t column) const;

  /// The field as it stands, valid as long as the object lives; empty where an optional column is
  /// missing.
  [[nodiscard]] std::string_view Text(std::size_t column) const;

  /// The same, not empty. Throws Error with line and column when it is.
  [[nodiscard]] std::string_view Required(std::size_t column) const;

  /// The field as a number with a decimal point, blanks around it allowed. Throws Error with line
  /// and column when it is empty, no number or not finite.
  [[nodiscard]] double Number(std::size_t column) const;

  /// The records that the rows are made of, at this row.
  [[nodiscard]] const CsvRecords& records() const noexcept { return records_; }

  /// The line the row began on, 1-based.
  [[nodiscard]] std::size_t line() const noexcept { return records_.line(); }

  /// Throws Error naming the file and the line of the row.
  [[noreturn]] void Fail(std::string reason, std::string remedy = {}) const;

 private:
  static constexpr std::size_t kMissing = static_cast<std::size_t>(-1);
  [[nodiscard]] std::size_t Find(std::string_view column) const;

  CsvRecords records_;
  std::span<const std::string_view> columns_;
  std::span<const std::string_view> optional_columns_;
  std::size_t num_fields_ = 0;
  std::vector<std::size_t> places_;
  std::vector<std::string_view> fields_;
};

}  // namespace handcraft::datasets
