// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/libsvm_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/csv_records.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

constexpr std::size_t kMaxIndex = 1000000;
constexpr std::size_t kMaxNumbers = std::size_t{1} << 28;

struct Entry {
  std::size_t index;  // from 1
  double value;
};

struct Sample {
  std::string label;
  std::vector<Entry> entries;
};

template <class T>
std::optional<T> Parse(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Walks the samples of a file.
class LibsvmLines {
 public:
  explicit LibsvmLines(const std::filesystem::path& path) : path_(path), bytes_(ReadFile(path)) {
    rest_ = {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()};
  }

  // False at the end of the file; empty lines are passed over.
  bool Next(Sample& sample) {
    while (!rest_.empty()) {
      const std::size_t length = std::min(rest_.find('\n'), rest_.size());
      words_ = rest_.substr(0, length);
      rest_.remove_prefix(std::min(length + 1, rest_.size()));
      ++line_;
      const std::string_view label = TakeWord();
      if (label.empty()) continue;
      sample.label = NumberToText(FiniteNumber(label, "a label"));
      sample.entries.clear();
      for (std::string_view word = TakeWord(); !word.empty(); word = TakeWord()) {
        sample.entries.push_back(ToEntry(word, sample.entries));
      }
      return true;
    }
    return false;
  }

  [[noreturn]] void Fail(const std::string& reason) const {
    throw Error({.path = path_.string(), .line = line_, .reason = reason});
  }

 private:
  std::string_view TakeWord() {
    constexpr std::string_view kBlanks = " \t\r";
    words_.remove_prefix(std::min(words_.find_first_not_of(kBlanks), words_.size()));
    const std::string_view word = words_.substr(0, words_.find_first_of(kBlanks));
    words_.remove_prefix(word.size());
    return word;
  }

  [[nodiscard]] double FiniteNumber(std::string_view text, const char* what) const {
    const std::optional<double> value = Parse<double>(text);
    if (value && std::isfinite(*value)) return *value;
    Fail(Quoted(text) + " where " + what + ", a finite number, is due");
  }

  [[nodiscard]] Entry ToEntry(std::string_view word, const std::vector<Entry>& before) const {
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) Fail(Quoted(word) + " where index:value is due");
    const std::optional<std::size_t> index = Parse<std::size_t>(word.substr(0, colon));
    if (!index || *index < 1 || *index > kMaxIndex) {
      Fail(Quoted(word) + ": an index is a whole number from 1 to " + NumberToText(kMaxIndex));
    }
    if (!before.empty() && *index <= before.back().index) {
      Fail(Quoted(word) + ": indices rise within a line");
    }
    return {.index = *index, .value = FiniteNumber(word.substr(colon + 1), "a value")};
  }

  std::filesystem::path path_;
  std::vector<std::uint8_t> bytes_;
  std::string_view rest_;
  std::string_view words_;
  std::size_t line_ = 0;
};

}  // namespace

bool IsLibsvmText(const std::filesystem::path& path) {
  return path.extension() == ".libsvm" || path.extension() == ".svm";
}

Table ReadLibsvmTable(const std::filesystem::path& path, std::size_t min_columns) {
  std::size_t num_columns = min_columns;
  Table table;
  Sample sample;
  for (LibsvmLines lines(path); lines.Next(sample); ++table.num_rows) {
    if (!sample.entries.empty()) num_columns = std::max(num_columns, sample.entries.back().index);
  }
  if (num_columns > 0 && table.num_rows > kMaxNumbers / num_columns) {
    throw Error({.path = path.string(),
                 .reason = NumberToText(table.num_rows) + " rows of " + NumberToText(num_columns) +
                           " columns are more than 2^28 numbers"});
  }
  table.label_column = "label";
  for (std::size_t j = 1; j <= num_columns; ++j) table.columns.push_back(NumberToText(j));
  table.values.assign(table.num_rows * num_columns, 0.0);
  for (LibsvmLines lines(path); lines.Next(sample);) {
    double* row = table.values.data() + table.labels.size() * num_columns;
    for (const Entry& entry : sample.entries) row[entry.index - 1] = entry.value;
    table.labels.push_back(sample.label);
  }
  return table;
}

}  // namespace handcraft::datasets
