// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace handcraft::datasets {

/// What the labels of an annotation tool mean. A label without a role says nothing: what carries it
/// is bad, as everything is that carries no label.
struct LabelRoles {
  std::vector<std::string> good = {"good"};
  std::vector<std::string> bad = {};  ///< bad even where it lies on something good
  std::vector<std::string> dont_care = {};

  /// Throws Error(kUsage) when a label has two roles.
  void Validate() const;

  /// kMaskGood, kMaskBad or kMaskDontCare; nothing for a label without a role.
  [[nodiscard]] std::optional<std::uint8_t> ValueOf(const std::string& label) const;

  /// Throws Error(kUsage) naming the labels there are when one with a role is not among them: a
  /// mistyped label would make a set without good pixels.
  void RequireAmong(const std::set<std::string>& labels, const std::filesystem::path& source) const;
};

}  // namespace handcraft::datasets
