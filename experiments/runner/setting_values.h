// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/runner/setting.h"
#include "lib/core/error.h"

/// Reading the values of settings. Every function throws Error(kUsage) that names key, value and
/// rule.
namespace handcraft::experiments {

[[noreturn]] inline void FailSetting(const Setting& setting, std::string_view rule) {
  throw Error(
      {.kind = Error::Kind::kUsage,
       .reason = fmt::format("{} is \"{}\"; it must be {}", setting.key, setting.value, rule)});
}

/// All of the value as a number; `rule` says what it must be.
template <class Number>
[[nodiscard]] Number ParseNumber(const Setting& setting, std::string_view rule) {
  Number number{};
  const char* const end = setting.value.data() + setting.value.size();
  const auto [stopped, error] = std::from_chars(setting.value.data(), end, number);
  if (error != std::errc() || stopped != end) FailSetting(setting, rule);
  if constexpr (std::floating_point<Number>) {
    if (!std::isfinite(number)) FailSetting(setting, rule);
  }
  return number;
}

/// The one of `values` whose NameOf is the setting's.
template <class Value>
[[nodiscard]] Value ParseWord(const Setting& setting, std::initializer_list<Value> values) {
  std::string words;
  for (const Value value : values) {
    const std::string_view name = NameOf(value);
    if (setting.value == name) return value;
    if (!words.empty()) words += ", ";
    words += name;
  }
  FailSetting(setting, words);
}

/// Calls the function of the key; `keys` have a name and apply(setting, settings).
template <class Keys, class Settings>
void ApplyByKey(const Keys& keys,
                std::span<const std::string_view> names,
                const Setting& setting,
                Settings& settings) {
  for (const auto& key : keys) {
    if (key.name == setting.key) return key.apply(setting, settings);
  }
  throw Error({.kind = Error::Kind::kUsage,
               .reason = fmt::format(
                   "\"{}\" is no setting; there are: {}", setting.key, fmt::join(names, ", "))});
}

}  // namespace handcraft::experiments
