// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <charconv>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

namespace handcraft {

/// Shortest text that reads back as the same number, with '.' in every locale.
template <class T>
requires std::is_arithmetic_v<T> std::string NumberToText(T value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else {
    char buffer[64];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end};
  }
}

/// Field name → text, sorted by name, as it is written into a model's metadata.
using FieldTexts = std::map<std::string, std::string>;

/// Every options struct lists its fields once, in `template <class V> void VisitFields(V&& v)
/// const` calling v("name", field) for each; printing, metadata and reports all come from that
/// list.
template <class Options>
FieldTexts FieldsToText(const Options& options, const std::string& prefix = "") {
  FieldTexts texts;
  options.VisitFields([&](std::string_view name, const auto& value) {
    const std::string key = prefix + std::string(name);
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      texts[key] = NumberToText(value);
    } else {
      texts[key] = std::string(value);
    }
  });
  return texts;
}

}  // namespace handcraft
