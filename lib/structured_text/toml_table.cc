// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/structured_text/toml_table.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lib/core/error.h"

namespace handcraft {

TomlTable::TomlTable(std::string file, const toml::table& table, std::string name)
    : file_(std::move(file)), table_(table), name_(std::move(name)) {}

void TomlTable::AllowOnly(std::span<const std::string_view> keys) const {
  for (const auto& [key, node] : table_) {
    const std::string_view found = key.str();
    if (std::find(keys.begin(), keys.end(), found) != keys.end()) continue;
    throw Error({.path = file_,
                 .line = key.source().begin.line,
                 .reason = fmt::format(
                     "\"{}\" is no key of {}", found, name_.empty() ? "this file" : name_),
                 .remedy = fmt::format("there are: {}", fmt::join(keys, ", "))});
  }
}

const toml::node& TomlTable::Node(std::string_view key) const {
  const toml::node* const node = table_.get(key);
  if (node == nullptr) Fail(table_, NameOfKey(key) + " is missing");
  return *node;
}

std::string TomlTable::Text(std::string_view key) const {
  const auto text = Node(key).value_exact<std::string>();
  if (!text || text->empty()) Fail(Node(key), NameOfKey(key) + " is no text");
  return *text;
}

double TomlTable::Number(std::string_view key, double lowest, double highest) const {
  const auto number = Node(key).value<double>();
  if (!number || !(*number >= lowest && *number <= highest)) {
    Fail(Node(key),
         fmt::format("{} must be a number from {} to {}", NameOfKey(key), lowest, highest));
  }
  return *number;
}

TomlTable TomlTable::Table(std::string_view key) const {
  const toml::table* const table = Node(key).as_table();
  if (table == nullptr) Fail(Node(key), NameOfKey(key) + " is no table");
  return {file_, *table, NameOfKey(key)};
}

std::vector<TomlTable> TomlTable::Tables(std::string_view key) const {
  std::vector<TomlTable> tables;
  if (!Has(key)) return tables;
  const toml::array* const array = Node(key).as_array();
  if (array == nullptr) Fail(Node(key), fmt::format("{0} is no list of tables [[{0}]]", key));
  for (const toml::node& node : *array) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) Fail(node, fmt::format("{0} is no list of tables [[{0}]]", key));
    tables.emplace_back(file_, *table, fmt::format("[[{}]]", key));
  }
  return tables;
}

void TomlTable::Fail(const toml::node& node, std::string reason, std::string remedy) const {
  throw Error({.path = file_,
               .line = node.source().begin.line,
               .reason = std::move(reason),
               .remedy = std::move(remedy)});
}

std::string TomlTable::NameOfKey(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{} {}", name_, key);
}

}  // namespace handcraft
