// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace handcraft::tools {

/// Where a command writes.
struct Console {
  std::ostream& out;         ///< results
  std::ostream& err;         ///< errors, warnings, progress
  bool interactive = false;  ///< `err` is a terminal: progress bars are drawn

  /// One line on `err`: "handcraft: warning: <text>".
  void Warn(std::string_view text) const;

  /// Prints a JSON value on `out`, indented by two; text that is not UTF-8 is made so.
  void Print(const nlohmann::ordered_json& json) const;
};

}  // namespace handcraft::tools
