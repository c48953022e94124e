// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_entries.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kMostNameLength = 60;

// The names of studies and methods become part of names of files.
bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= kMostNameLength && name.front() != '-' &&
         std::all_of(name.begin(), name.end(), [](char letter) {
           return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                  (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
         });
}

// A setting's value as the command line would have it: text, or a number.
std::string ValueText(const TomlTable& table, const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto whole = node.value_exact<std::int64_t>()) return NumberToText(*whole);
  if (const auto number = node.value_exact<double>()) return NumberToText(*number);
  table.Fail(node, "a setting is a text or a number");
}

// Tries the setting, so that what is wrong is told with its line.
void CheckSetting(const TomlTable& table,
                  const toml::node& node,
                  const SettingRules& rules,
                  const Setting& setting) {
  try {
    rules.check(setting);
  } catch (const Error& error) {
    table.Fail(node, error.details().reason, error.details().remedy);
  }
}

Factor ParseFactor(const TomlTable& table,
                   std::string_view key,
                   StudySize size,
                   const SettingRules& rules) {
  const toml::node& list = OfSize(table, table.Node(key), size);
  const toml::array* const values = list.as_array();
  if (values == nullptr || values->empty()) {
    table.Fail(list, fmt::format("[grid] {} is no list of values", key));
  }
  Factor factor{.key = std::string(key), .values = {}};
  for (const toml::node& node : *values) {
    Setting setting{factor.key, ValueText(table, node)};
    CheckSetting(table, node, rules, setting);
    if (std::find(factor.values.begin(), factor.values.end(), setting.value) !=
        factor.values.end()) {
      table.Fail(node, fmt::format("[grid] {} has {} twice", key, setting.value));
    }
    factor.values.push_back(std::move(setting.value));
  }
  return factor;
}

// Features are written with commas and the like; a name of a file has none of / and blanks.
std::string PlainText(const std::string& value) {
  std::string plain = value;
  for (char& letter : plain) {
    if (letter == '/' || letter == ' ' || letter == ',') letter = '+';
  }
  return plain;
}

}  // namespace

std::string_view NameOf(StudySize size) noexcept {
  return size == StudySize::kSmall ? "small" : "full";
}

std::string ParseName(const TomlTable& table) {
  std::string name = table.Text("name");
  if (!IsPlainName(name)) {
    table.Fail(table.Node("name"),
               fmt::format("name is \"{}\"", name),
               "use letters, digits, _ and -, up to 60");
  }
  return name;
}

const toml::node& OfSize(const TomlTable& table, const toml::node& node, StudySize size) {
  const toml::table* const by_size = node.as_table();
  if (by_size == nullptr) return node;
  const toml::node* const chosen = by_size->get(NameOf(size));
  if (chosen == nullptr || by_size->size() != 2 || !by_size->contains("small") ||
      !by_size->contains("full")) {
    table.Fail(node, "a value by size has two entries", "write { small = 216, full = 13247 }");
  }
  return *chosen;
}

std::int64_t ParseWhole(const TomlTable& table,
                        std::string_view key,
                        StudySize size,
                        std::int64_t lowest) {
  constexpr std::int64_t kMost = 1'000'000'000;
  const toml::node& node = OfSize(table, table.Node(key), size);
  const auto number = node.value_exact<std::int64_t>();
  if (!number || *number < lowest || *number > kMost) {
    table.Fail(node, fmt::format("{} must be a whole number from {} to 1e+09", key, lowest));
  }
  return *number;
}

std::vector<Setting> ParseSettings(const TomlTable& table,
                                   StudySize size,
                                   const SettingRules& rules) {
  std::vector<Setting> settings;
  for (const std::string_view key : rules.keys) {
    if (!table.Has(key)) continue;
    const toml::node& node = OfSize(table, table.Node(key), size);
    Setting setting{std::string(key), ValueText(table, node)};
    CheckSetting(table, node, rules, setting);
    settings.push_back(std::move(setting));
  }
  return settings;
}

std::vector<Setting> ParseStudySettings(const TomlTable& top,
                                        StudySize size,
                                        const SettingRules& rules) {
  if (!top.Has("settings")) return {};
  const TomlTable settings = top.Table("settings");
  settings.AllowOnly(rules.keys);
  return ParseSettings(settings, size, rules);
}

std::vector<Method> ParseMethods(const TomlTable& top, StudySize size, const SettingRules& rules) {
  std::vector<Method> methods;
  std::vector<std::string_view> keys(rules.keys.begin(), rules.keys.end());
  keys.push_back("name");
  std::set<std::string> names;
  for (const TomlTable& table : top.Tables("method")) {
    table.AllowOnly(keys);
    methods.push_back({ParseName(table), ParseSettings(table, size, rules)});
    const std::string& name = methods.back().name;
    if (!names.insert(name).second) {
      table.Fail(table.Node("name"), "two methods are named \"" + name + "\"");
    }
  }
  if (methods.empty()) top.Fail(top.table(), "a study has at least one [[method]]");
  return methods;
}

std::vector<Factor> ParseGrid(const TomlTable& top,
                              StudySize size,
                              const SettingRules& rules,
                              std::span<const Method> methods) {
  std::vector<Factor> factors;
  if (!top.Has("grid")) return factors;
  const TomlTable table = top.Table("grid");
  table.AllowOnly(rules.keys);
  for (const std::string_view key : rules.keys) {
    if (!table.Has(key)) continue;
    for (const Method& method : methods) {
      const bool is_set = std::any_of(method.settings.begin(),
                                      method.settings.end(),
                                      [&](const Setting& setting) { return setting.key == key; });
      if (is_set) {
        table.Fail(table.Node(key),
                   fmt::format("{} is set by the method \"{}\" too", key, method.name),
                   "vary it in the methods or in [grid]");
      }
    }
    factors.push_back(ParseFactor(table, key, size, rules));
  }
  return factors;
}

void KeepMethods(std::span<const std::string> names,
                 const std::string& study,
                 std::vector<Method>& methods) {
  std::vector<std::string> known;
  known.reserve(methods.size());
  for (const Method& method : methods) known.push_back(method.name);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("the study {} has no method \"{}\"", study, name),
                 .remedy = fmt::format("name some of {}", fmt::join(known, ", "))});
  }
  std::erase_if(methods, [&](const Method& method) {
    return std::find(names.begin(), names.end(), method.name) == names.end();
  });
}

std::vector<std::vector<Setting>> Combine(std::span<const Factor> factors) {
  std::vector<std::vector<Setting>> combinations = {{}};
  for (const Factor& factor : factors) {
    std::vector<std::vector<Setting>> longer;
    for (const std::vector<Setting>& combination : combinations) {
      for (const std::string& value : factor.values) {
        longer.push_back(combination);
        longer.back().push_back({factor.key, value});
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

std::string CombinationId(std::string_view method, std::span<const Setting> factors) {
  std::string id(method);
  for (const Setting& factor : factors) {
    id += fmt::format(",{}={}", factor.key, PlainText(factor.value));
  }
  return id;
}

}  // namespace handcraft::experiments
