// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace handcraft::datasets {

/// A value in a JSON file that others wrote (RFC 8259). What is read must be of the type asked for:
/// every function throws Error naming the file, the place as a JSON pointer (RFC 6901) and what was
/// found. Copies are cheap and keep the file's tree alive; it never changes, so any number of
/// threads may read it.
class JsonValue {
 public:
  /// The top of a file. Throws Error with the byte when it cannot be parsed: truncated, not UTF-8,
  /// numbers that overflow, more than 100 levels.
  [[nodiscard]] static JsonValue ReadFile(const std::filesystem::path& path);

  /// The member of an object; it must be there.
  [[nodiscard]] JsonValue operator[](const std::string& key) const;
  /// Whether the object has the member, and it is not null.
  [[nodiscard]] bool Has(const std::string& key) const;
  /// The members of an object, in the byte order of their keys.
  [[nodiscard]] std::vector<std::pair<std::string, JsonValue>> Members() const;
  /// The members of a list, in order.
  [[nodiscard]] std::vector<JsonValue> Items() const;

  [[nodiscard]] bool IsList() const noexcept;
  [[nodiscard]] bool IsText() const noexcept;
  [[nodiscard]] std::string Text() const;
  [[nodiscard]] double Number() const;
  /// A whole number within the limits; 3.0 is one.
  [[nodiscard]] std::int64_t Integer(std::int64_t lowest, std::int64_t highest) const;
  /// A list of numbers.
  [[nodiscard]] std::vector<double> Numbers() const;

  /// Throws Error naming the file and this place in it.
  [[noreturn]] void Fail(const std::string& reason, const std::string& remedy = {}) const;

 private:
  struct File;
  JsonValue(std::shared_ptr<const File> file, const nlohmann::json* value);
  [[noreturn]] void FailType(std::string_view expected) const;

  std::shared_ptr<const File> file_;
  const nlohmann::json* value_;
};

}  // namespace handcraft::datasets
