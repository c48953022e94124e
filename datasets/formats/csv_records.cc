// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/csv_records.h"

#include <algorithm>
#include <utility>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/utf8.h"

namespace handcraft::datasets {

CsvRecords::CsvRecords(std::filesystem::path path)
    : path_(std::move(path)), text_(ReadTextFile(path_)) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

void CsvRecords::RequireUtf8() const {
  const std::size_t good = std::min(Utf8PrefixLength(text_), text_.find('\0'));
  if (good >= text_.size()) return;
  const auto line_ends =
      std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(good), '\n');
  throw Error({.path = path_.string(),
               .line = static_cast<std::size_t>(line_ends) + 1,
               .reason = "not UTF-8 text: a byte that cannot stand there",
               .remedy = "save it as CSV in UTF-8"});
}

void CsvRecords::Fail(std::string reason, std::string remedy) const {
  throw Error({.path = path_.string(),
               .line = record_line_,
               .reason = std::move(reason),
               .remedy = std::move(remedy)});
}

bool CsvRecords::TakeLineEnd() noexcept {
  const std::size_t length = std::string_view(text_).substr(at_).starts_with("\r\n") ? 2 : 1;
  if (length == 1 && (at_ >= text_.size() || text_[at_] != '\n')) return false;
  at_ += length;
  ++line_;
  return true;
}

std::string_view CsvRecords::TakePlainField() noexcept {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n') ++at_;
  std::size_t end = at_;
  const bool at_line_end = at_ == text_.size() || text_[at_] == '\n';
  if (at_line_end && end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

std::string_view CsvRecords::TakeQuotedField() {
  ++at_;  // the opening quote
  const std::size_t begin = at_;
  std::size_t end = begin;
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '"') {
      ++at_;
      if (at_ >= text_.size() || text_[at_] != '"') {
        return std::string_view(text_).substr(begin, end - begin);
      }
    }
    if (text_[at_] == '\n') ++line_;
    text_[end++] = text_[at_];
  }
  Fail("a quote is opened and never closed");
}

bool CsvRecords::Next(std::vector<std::string_view>& fields) {
  fields.clear();
  while (TakeLineEnd()) {
  }
  if (at_ >= text_.size()) return false;
  record_line_ = line_;
  while (true) {
    const bool quoted = at_ < text_.size() && text_[at_] == '"';
    fields.push_back(quoted ? TakeQuotedField() : TakePlainField());
    if (at_ < text_.size() && text_[at_] == '\r' && at_ + 1 == text_.size()) ++at_;
    if (at_ >= text_.size() || TakeLineEnd()) return true;
    if (text_[at_] != ',') {
      Fail("field " + std::to_string(fields.size()) + " goes on after its closing quote",
           "double a quote that belongs to the text: \"\"");
    }
    ++at_;
  }
}

std::string CsvField(std::string_view text) {
  const bool plain = text.find_first_of(",\"\r\n") == std::string_view::npos;
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

}  // namespace handcraft::datasets
