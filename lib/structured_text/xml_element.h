// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;  // NOLINT(cppcoreguidelines-virtual-class-destructor): theirs; its tree frees it
}  // namespace tinyxml2

namespace handcraft {

/// An element of an XML file that others wrote (XML 1.0 without document types: entities of a
/// file's own are not expanded). Every function throws Error naming the file, the line and what was
/// found when something is not as asked for. Copies are cheap and keep the file's tree alive; it
/// never changes, so any number of threads may read it.
class XmlElement {
 public:
  /// The root of a file. Throws Error with the line when it cannot be parsed: truncated, not XML,
  /// more than 100 levels.
  [[nodiscard]] static XmlElement ReadFile(const std::filesystem::path& path);

  [[nodiscard]] std::string Name() const;
  /// The elements directly inside, in order.
  [[nodiscard]] std::vector<XmlElement> Children() const;
  /// Those of one name.
  [[nodiscard]] std::vector<XmlElement> Children(const std::string& name) const;
  /// The text the element begins with; empty when it begins with something else.
  [[nodiscard]] std::string Text() const;

  [[nodiscard]] bool Has(const std::string& attribute) const;
  /// The value of an attribute; it must be there.
  [[nodiscard]] std::string Attribute(const std::string& attribute) const;
  /// The same, as a finite number.
  [[nodiscard]] double Number(const std::string& attribute) const;
  /// The same, as a whole number within the limits.
  [[nodiscard]] std::int64_t Integer(const std::string& attribute,
                                     std::int64_t lowest,
                                     std::int64_t highest) const;

  /// The place in the file, for messages: "line 7, <box>".
  [[nodiscard]] std::string Where() const;
  /// Throws Error naming the file and the line.
  [[noreturn]] void Fail(const std::string& reason, const std::string& remedy = {}) const;

 private:
  struct File;
  XmlElement(std::shared_ptr<const File> file, const tinyxml2::XMLElement* element);

  std::shared_ptr<const File> file_;
  const tinyxml2::XMLElement* element_;
};

}  // namespace handcraft
