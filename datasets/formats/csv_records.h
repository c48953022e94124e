// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace handcraft::datasets {

/// Walks a CSV file record by record: fields separated by commas, "quoted" where they hold commas,
/// quotes (doubled) or line ends; lines end with LF or CRLF; a UTF-8 byte order mark at the start
/// and empty lines are skipped. Source: RFC 4180.
class CsvRecords {
 public:
  /// Reads the whole file. Throws Error when it cannot.
  explicit CsvRecords(std::filesystem::path path);
  CsvRecords(const CsvRecords&) = delete;
  CsvRecords& operator=(const CsvRecords&) = delete;

  /// Throws Error with the line when the file is not UTF-8 text: Latin-1 letters, UTF-16, another
  /// kind of file. Before the first Next. (A manifest may hold any bytes: names of files do.)
  void RequireUtf8() const;

  /// Moves to the next record; false at the end of the file. The fields stay valid as long as the
  /// object lives. Throws Error with the line when a quote is not closed or closed in mid-field.
  [[nodiscard]] bool Next(std::vector<std::string_view>& fields);

  /// The line the last record began on, 1-based.
  [[nodiscard]] std::size_t line() const noexcept { return record_line_; }
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Throws Error naming the file and the line of the last record.
  [[noreturn]] void Fail(std::string reason, std::string remedy = {}) const;

 private:
  [[nodiscard]] std::string_view TakePlainField() noexcept;
  [[nodiscard]] std::string_view TakeQuotedField();
  [[nodiscard]] bool TakeLineEnd() noexcept;

  std::filesystem::path path_;
  std::string text_;  ///< doubled quotes are made single in place, as they are met
  std::size_t at_ = 0;
  std::size_t line_ = 1;  ///< at `at_`
  std::size_t record_line_ = 0;
};

/// A field as it is written into a CSV file: quoted when it must be.
[[nodiscard]] std::string CsvField(std::string_view text);

/// A field as messages show it: 'text'.
[[nodiscard]] std::string Quoted(std::string_view text);

}  // namespace handcraft::datasets
