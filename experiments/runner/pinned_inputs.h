// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string_view>

namespace handcraft::experiments {

/// The folder of a study's results, whose inputs are pinned: what the first call of Pin was given
/// under a name, every later run must give too.
class PinnedInputs {
 public:
  /// Makes the folder, or takes up one that was begun. Throws Error when it holds anything else.
  explicit PinnedInputs(std::filesystem::path folder);

  /// Writes inputs/NAME, or compares with what it holds. Throws Error that names input and first
  /// line that differ, and when the input is missing though there are cells: all inputs are pinned
  /// before the folder `cells` is made.
  void Pin(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace handcraft::experiments
