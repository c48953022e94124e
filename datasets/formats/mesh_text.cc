// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

void AppendWords(std::string_view line, std::vector<std::string_view>& words) {
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
}

// A word as it is quoted in a message: short, and without bytes that are no text.
std::string Quoted(std::string_view word) {
  std::string quoted = "\"";
  for (const char letter : word.substr(0, 30)) {
    quoted += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return quoted + (word.size() > 30 ? "...\"" : "\"");
}

}  // namespace

MeshText::MeshText(std::filesystem::path path, std::string_view text, std::size_t first_line)
    : path_(std::move(path)), text_(text), next_line_(first_line) {}

bool MeshText::Next() {
  words_.clear();
  line_ = next_line_;
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    AppendWords(text_.substr(at_, end - at_), words_);
    at_ = std::min(end + 1, text_.size());
    ++next_line_;
    const bool goes_on = !words_.empty() && words_.back() == "\\";
    if (goes_on) {
      words_.pop_back();
      continue;
    }
    if (!words_.empty()) return true;
    line_ = next_line_;
  }
  return !words_.empty();
}

std::string MeshText::From(std::size_t i) const {
  std::string joined;
  for (; i < words_.size(); ++i) {
    if (!joined.empty()) joined += ' ';
    joined += words_[i];
  }
  return joined;
}

float MeshText::Number(std::size_t i) const {
  if (i >= words_.size()) Fail("ends after " + std::to_string(i) + " words; a number is due");
  const std::string_view word = words_[i].substr(words_[i].front() == '+' ? 1 : 0);
  double value = 0.0;  // a float would refuse what is too small for it
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const auto narrow = static_cast<float>(value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(narrow)) {
    Fail(Quoted(words_[i]) + " is no finite number; one is due");
  }
  return narrow;
}

std::int64_t MeshText::Whole(std::size_t i, std::int64_t lowest, std::int64_t highest) const {
  if (i >= words_.size()) Fail("ends after " + std::to_string(i) + " words; a number is due");
  std::int64_t value = 0;
  const std::string_view word = words_[i];
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value < lowest ||
      value > highest) {
    Fail(Quoted(word) + " is no whole number from " + std::to_string(lowest) + " to " +
         std::to_string(highest) + "; one is due");
  }
  return value;
}

void MeshText::Fail(std::string reason, std::string remedy) const {
  throw Error({.path = path_.string(),
               .line = line_,
               .reason = std::move(reason),
               .remedy = std::move(remedy)});
}

}  // namespace handcraft::datasets
