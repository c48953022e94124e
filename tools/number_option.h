// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <charconv>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

#include <CLI/App.hpp>

#include "lib/core/error.h"
#include "lib/core/fields.h"

/// Options that are numbers. Whoever refuses one, the library or the command, it is said so:
///   --ridge: -1 given; it must be a finite number >= 0
namespace handcraft::tools {

/// The rule in the message of an options struct's Validate(): what follows "must be".
[[nodiscard]] std::string RuleOf(const Error& refusal);

/// Reads all of `text` as a decimal number. Returns what it must be if it is no such number; a
/// whole number that is too large for the type gives the type's nearest.
template <class T>
[[nodiscard]] std::string ReadNumber(const std::string& text, T& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (stop == end && code == std::errc()) return "";
  if (stop == end && code == std::errc::result_out_of_range) {
    using Limits = std::numeric_limits<T>;
    if constexpr (std::integral<T>) value = text.front() == '-' ? Limits::lowest() : Limits::max();
    return "from " + NumberToText(Limits::lowest()) + " to " + NumberToText(Limits::max());
  }
  if constexpr (std::unsigned_integral<T>) {
    std::int64_t negative = 0;
    if (ReadNumber(text, negative).empty()) return "0 or more";
  }
  return std::integral<T> ? "a whole number" : "a number";
}

/// Refuses what is no number of the type, and a number against which `rule_against` names a rule;
/// it returns an empty text for a good one. What passes is rewritten for CLI11, which would take
/// 010 for 8.
template <class T, std::invocable<T> RuleAgainst>
[[nodiscard]] CLI::Validator CheckNumber(RuleAgainst rule_against) {
  const auto check = [rule_against](std::string& text) -> std::string {
    T value{};
    const std::string misread = ReadNumber(text, value);
    const bool is_too_large = std::integral<T> && misread.starts_with("from ");
    const bool has_value = misread.empty() || misread == "0 or more" || is_too_large;
    std::string rule = has_value ? rule_against(value) : misread;
    if (rule.empty()) rule = misread;
    if (!rule.empty()) return text + " given; it must be " + rule;
    text = NumberToText(value);
    return "";
  };
  return {check, ""};
}

/// Any number the type can hold.
template <class T>
[[nodiscard]] CLI::Validator AnyNumber() {
  return CheckNumber<T>([](T) { return std::string(); });
}

/// From `lowest` to `highest`, both included.
[[nodiscard]] CLI::Validator IntegerWithin(int lowest, int highest);

/// What the library takes: Options::Validate() is asked about this value of the field, the other
/// fields at their defaults.
template <class Options, class T>
[[nodiscard]] CLI::Validator TakenBy(T Options::*field) {
  return CheckNumber<T>([field](T value) -> std::string {
    Options options;
    options.*field = value;
    try {
      options.Validate();
    } catch (const Error& refusal) {
      return RuleOf(refusal);
    }
    return "";
  });
}

/// An option for a number: shows its default, takes what `validator` lets pass.
template <class T>
CLI::Option* AddNumber(CLI::App& command,
                       const std::string& name,
                       T& value,
                       const CLI::Validator& validator,
                       const std::string& description) {
  return command.add_option(name, value, description)
      ->transform(validator)
      ->type_name(std::integral<T> ? "INT" : "NUMBER")
      ->capture_default_str();
}

/// As above, for a field of an options struct.
template <class Options, class T>
CLI::Option* AddNumber(CLI::App& command,
                       const std::string& name,
                       Options& options,
                       T Options::*field,
                       const std::string& description) {
  return AddNumber(command, name, options.*field, TakenBy(field), description);
}

}  // namespace handcraft::tools
