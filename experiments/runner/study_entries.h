// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/runner/setting.h"
#include "lib/structured_text/toml_table.h"

/// What the files of all studies are made of: names, values by size, settings, methods, factors.
/// Every function throws Error with path and line.
namespace handcraft::experiments {

/// Which of two values is meant where a study file writes { small = 216, full = 13247 }.
enum class StudySize : std::uint8_t {
  kSmall,  ///< minutes
  kFull,   ///< as large as the publication's
};
[[nodiscard]] std::string_view NameOf(StudySize size) noexcept;

/// The settings that a kind of study has.
struct SettingRules {
  std::span<const std::string_view> keys;  ///< in the order in which cells are told apart by them
  void (*check)(const Setting&);           ///< throws Error for a value that does not fit its key
};

/// The key "name" of a table: letters, digits, _ and -, since it becomes part of names of files.
[[nodiscard]] std::string ParseName(const TomlTable& table);

/// The node itself, or what { small = …, full = … } has for the size.
[[nodiscard]] const toml::node& OfSize(const TomlTable& table,
                                       const toml::node& node,
                                       StudySize size);

/// A whole number from `lowest` to 1e9, which may be given by size.
[[nodiscard]] std::int64_t ParseWhole(const TomlTable& table,
                                      std::string_view key,
                                      StudySize size,
                                      std::int64_t lowest);

/// The settings of a table, in the order of the rules' keys; other keys are left to the caller.
[[nodiscard]] std::vector<Setting> ParseSettings(const TomlTable& table,
                                                 StudySize size,
                                                 const SettingRules& rules);

/// The table [settings], which need not be there.
[[nodiscard]] std::vector<Setting> ParseStudySettings(const TomlTable& top,
                                                      StudySize size,
                                                      const SettingRules& rules);

/// The tables [[method]]: at least one, their names told apart.
[[nodiscard]] std::vector<Method> ParseMethods(const TomlTable& top,
                                               StudySize size,
                                               const SettingRules& rules);

/// The lists of [grid], which need not be there: settings that no method sets.
[[nodiscard]] std::vector<Factor> ParseGrid(const TomlTable& top,
                                            StudySize size,
                                            const SettingRules& rules,
                                            std::span<const Method> methods);

/// Leaves out all methods but these, in the order they have; `study` is named in messages. Throws
/// Error(kUsage) for a name that is none of them, which it lists.
void KeepMethods(std::span<const std::string> names,
                 const std::string& study,
                 std::vector<Method>& methods);

/// Every combination of the factors' values, the last factor changing fastest.
[[nodiscard]] std::vector<std::vector<Setting>> Combine(std::span<const Factor> factors);

/// "method,key=value,…", in words that stay the same when other methods or values are added; fit
/// for the name of a file.
[[nodiscard]] std::string CombinationId(std::string_view method, std::span<const Setting> factors);

}  // namespace handcraft::experiments
