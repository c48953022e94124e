// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lib/core/file.h"

namespace handcraft::testing {

/// Every file below a folder, by its path relative to it.
inline std::map<std::string, std::vector<std::uint8_t>> ReadTree(
    const std::filesystem::path& root) {
  std::map<std::string, std::vector<std::uint8_t>> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    files[entry.path().lexically_relative(root).generic_string()] = ReadFile(entry.path());
  }
  return files;
}

}  // namespace handcraft::testing
