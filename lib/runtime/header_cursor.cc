// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/header_cursor.h"

#include <algorithm>

#include "lib/core/utf8.h"
#include "lib/runtime/format.h"

namespace handcraft::runtime {

bool HeaderCursor::Fail(const ModelError& error) noexcept {
  if (!error_) error_ = error;
  return false;
}

bool HeaderCursor::FailExpecting(const char* expected) noexcept {
  if (AtEnd()) {
    return Fail(
        MakeError(HC_ERROR_FORMAT, Offset(), "the header ends where %s was expected", expected));
  }
  const auto found = static_cast<char>(text_[position_]);
  return Fail(MakeError(HC_ERROR_FORMAT,
                        Offset(),
                        "the header holds '%s' (0x%02x) where %s was expected; only compact JSON "
                        "with sorted keys is allowed",
                        Printable({&found, 1}).c_str(),
                        static_cast<unsigned>(text_[position_]),
                        expected));
}

bool HeaderCursor::Expect(std::string_view literal) noexcept {
  if (Failed()) return false;
  const std::size_t length = std::min(literal.size(), text_.size() - position_);
  for (std::size_t i = 0; i < literal.size(); ++i) {
    if (i < length && text_[position_ + i] == static_cast<std::uint8_t>(literal[i])) continue;
    position_ += i;
    return FailExpecting(Printable(literal.substr(i)).c_str());
  }
  position_ += length;
  return true;
}

bool HeaderCursor::TakeIf(char c) noexcept {
  if (Failed() || AtEnd() || text_[position_] != static_cast<std::uint8_t>(c)) return false;
  ++position_;
  return true;
}

bool HeaderCursor::ReadCharacter(std::string& value) {
  if (AtEnd()) return FailExpecting("the end of a string");
  auto c = static_cast<char>(text_[position_]);
  if (static_cast<unsigned char>(c) < ' ') return FailExpecting("a printable character");
  ++position_;
  if (c == '\\') {
    constexpr std::string_view kEscapes = "\"\\nt";
    constexpr std::string_view kMeanings = "\"\\\n\t";
    const std::size_t which =
        AtEnd() ? std::string_view::npos : kEscapes.find(static_cast<char>(text_[position_]));
    if (which == std::string_view::npos)
      return FailExpecting("one of the escapes \\\" \\\\ \\n \\t");
    ++position_;
    c = kMeanings[which];
  }
  value.push_back(c);
  return true;
}

bool HeaderCursor::ReadString(std::size_t max_bytes, std::string& value) {
  value.clear();
  const std::uint64_t start = Offset();
  if (!Failed() && !TakeIf('"')) return FailExpecting("a string");
  while (!TakeIf('"')) {
    if (Failed() || !ReadCharacter(value)) return false;
    if (value.size() > max_bytes) {
      return Fail(MakeError(
          HC_ERROR_FORMAT, start, "the header holds a string of more than %zu bytes", max_bytes));
    }
  }
  if (IsUtf8(value)) return true;
  return Fail(MakeError(HC_ERROR_FORMAT, start, "the header holds a string that is not UTF-8"));
}

bool HeaderCursor::ReadInteger(std::uint64_t& value) noexcept {
  const auto is_digit = [&] {
    return !AtEnd() && text_[position_] >= '0' && text_[position_] <= '9';
  };
  if (Failed()) return false;
  const std::uint64_t start = Offset();
  if (!is_digit()) return FailExpecting("a whole number of at least 0");
  const bool leading_zero = text_[position_] == '0';
  value = 0;
  std::size_t num_digits = 0;
  for (; is_digit(); ++position_, ++num_digits) {
    value = value * 10 + (text_[position_] - std::uint64_t{'0'});
    if (value > format::kMaxInteger) {
      return Fail(MakeError(HC_ERROR_FORMAT, start, "the header holds a number above 2^53"));
    }
  }
  if (!leading_zero || num_digits == 1) return true;
  return Fail(MakeError(HC_ERROR_FORMAT, start, "the header holds a number with a leading zero"));
}

bool HeaderCursor::ExpectPaddingToEnd() noexcept {
  if (Failed()) return false;
  const std::uint64_t start = Offset();
  while (TakeIf(' ')) {
  }
  if (!AtEnd()) return FailExpecting("nothing but spaces");
  if (Offset() - start < format::kDataAlignment) return true;
  return Fail(MakeError(HC_ERROR_FORMAT,
                        start,
                        "the header ends in %zu spaces where fewer than %zu were expected",
                        static_cast<std::size_t>(Offset() - start),
                        format::kDataAlignment));
}

}  // namespace handcraft::runtime
