// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace handcraft {

/// One table of a TOML file, read strictly. Every function throws Error with path and line for what
/// is missing, of another type or out of range.
class TomlTable {
 public:
  /// `name` says in messages which table it is: "[data.train]"; empty for the top of the file. The
  /// table must outlive the object.
  TomlTable(std::string file, const toml::table& table, std::string name);

  /// Throws Error for a key that is not among `keys`, and lists them.
  void AllowOnly(std::span<const std::string_view> keys) const;

  [[nodiscard]] bool Has(std::string_view key) const { return table_.contains(key); }
  [[nodiscard]] const toml::node& Node(std::string_view key) const;
  [[nodiscard]] std::string Text(std::string_view key) const;
  /// A number in [lowest, highest].
  [[nodiscard]] double Number(std::string_view key, double lowest, double highest) const;
  [[nodiscard]] TomlTable Table(std::string_view key) const;
  /// The tables [[key]]; none when the key is missing.
  [[nodiscard]] std::vector<TomlTable> Tables(std::string_view key) const;
  [[nodiscard]] const toml::table& table() const noexcept { return table_; }

  [[noreturn]] void Fail(const toml::node& node, std::string reason, std::string remedy = {}) const;

 private:
  [[nodiscard]] std::string NameOfKey(std::string_view key) const;

  std::string file_;
  const toml::table& table_;
  std::string name_;
};

}  // namespace handcraft
