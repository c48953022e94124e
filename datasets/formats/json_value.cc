// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/json_value.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kMaxDepth = 100;

// What stands there, short enough for a message.
std::string Excerpt(const json& value) {
  constexpr std::size_t kMaxLength = 40;
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_object()) return "an object";
  const std::string text = value.dump(-1, ' ', true);  // escapes all but ASCII
  return text.size() <= kMaxLength ? text : text.substr(0, kMaxLength) + "...";
}

std::string Escaped(std::string_view key) {
  std::string escaped;
  for (const char letter : key) {
    escaped += letter == '~' ? "~0" : letter == '/' ? "~1" : std::string(1, letter);
  }
  return escaped;
}

// The pointer to `target`, which is looked for only when a fault is told. Trees are not deep.
std::optional<std::string> PointerTo(const json& tree, const json* target) {
  if (&tree == target) return "";
  if (!tree.is_structured()) return std::nullopt;
  std::size_t index = 0;
  for (auto it = tree.begin(); it != tree.end(); ++it, ++index) {
    const std::optional<std::string> rest = PointerTo(*it, target);
    if (rest) return "/" + (tree.is_object() ? Escaped(it.key()) : std::to_string(index)) + *rest;
  }
  return std::nullopt;
}

json Parse(const fs::path& path, const std::string& text) {
  const auto refuse_depth = [&](int depth, json::parse_event_t, const json&) {
    if (depth <= kMaxDepth) return true;
    throw Error(
        {.path = path.string(),
         .reason = "more than " + std::to_string(kMaxDepth) + " levels of lists and objects",
         .remedy = "give the file as the annotation tool wrote it"});
  };
  const std::string remedy = "is the file whole? write it again";
  try {
    return json::parse(text, refuse_depth);
  } catch (const json::parse_error& error) {
    throw Error({.path = path.string(),
                 .byte = std::max<std::size_t>(error.byte, 1) - 1,  // theirs counts from 1
                 .reason = text.empty() ? "the file is empty; JSON is due" : "this is not JSON",
                 .remedy = remedy});
  } catch (const json::exception& error) {
    throw Error({.path = path.string(),
                 .reason = "a number is too large for a computer: " + std::string(error.what()),
                 .remedy = remedy});
  }
}

}  // namespace

struct JsonValue::File {
  fs::path path;
  json tree;
};

JsonValue::JsonValue(std::shared_ptr<const File> file, const json* value)
    : file_(std::move(file)), value_(value) {}

JsonValue JsonValue::ReadFile(const fs::path& path) {
  auto file = std::make_shared<File>(File{path, Parse(path, ReadTextFile(path))});
  const json* const tree = &file->tree;
  return {std::move(file), tree};
}

JsonValue JsonValue::operator[](const std::string& key) const {
  if (!value_->is_object()) FailType("an object");
  const auto found = value_->find(key);
  if (found == value_->end()) Fail("no member '" + key + "'");
  return {file_, &*found};
}

bool JsonValue::Has(const std::string& key) const {
  if (!value_->is_object()) FailType("an object");
  const auto found = value_->find(key);
  return found != value_->end() && !found->is_null();
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::Members() const {
  if (!value_->is_object()) FailType("an object");
  std::vector<std::pair<std::string, JsonValue>> members;
  for (auto it = value_->begin(); it != value_->end(); ++it) {
    members.emplace_back(it.key(), JsonValue(file_, &*it));
  }
  return members;
}

std::vector<JsonValue> JsonValue::Items() const {
  if (!value_->is_array()) FailType("a list");
  std::vector<JsonValue> items;
  items.reserve(value_->size());
  for (const json& item : *value_) items.push_back(JsonValue(file_, &item));
  return items;
}

bool JsonValue::IsList() const noexcept { return value_->is_array(); }
bool JsonValue::IsText() const noexcept { return value_->is_string(); }

std::string JsonValue::Text() const {
  if (!value_->is_string()) FailType("a text");
  return value_->get<std::string>();
}

double JsonValue::Number() const {
  if (!value_->is_number()) FailType("a number");
  return value_->get<double>();
}

std::int64_t JsonValue::Integer(std::int64_t lowest, std::int64_t highest) const {
  const double number = Number();
  const bool is_whole = std::nearbyint(number) == number && std::abs(number) < 0x1p62;
  const std::int64_t value = is_whole ? value_->get<std::int64_t>() : 0;
  if (!is_whole || value < lowest || value > highest) {
    FailType("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return value;
}

std::vector<double> JsonValue::Numbers() const {
  if (!value_->is_array()) FailType("a list of numbers");
  std::vector<double> numbers;
  numbers.reserve(value_->size());
  for (const json& item : *value_) numbers.push_back(JsonValue(file_, &item).Number());
  return numbers;
}

void JsonValue::Fail(const std::string& reason, const std::string& remedy) const {
  const std::string pointer = PointerTo(file_->tree, value_).value_or("");
  throw Error({.path = file_->path.string(),
               .reason = (pointer.empty() ? "" : "at " + pointer + ": ") + reason,
               .remedy = remedy});
}

void JsonValue::FailType(std::string_view expected) const {
  Fail(Excerpt(*value_) + "; " + std::string(expected) + " is due");
}

}  // namespace handcraft::datasets
