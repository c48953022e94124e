// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace handcraft::synthetic {

/// What a run has written of a set; what was whole before is not written again.
struct Written {
  std::size_t num_pictures = 0;  ///< of which a file was missing or not whole
  std::size_t num_lists = 0;     ///< that were missing or told something else

  [[nodiscard]] bool IsNothing() const noexcept { return num_pictures + num_lists == 0; }
};

/// Makes the folder of a made-up set with its subfolders, or takes up one that the same options
/// have begun: `parameters`, the text of its dataset.toml, is written first and must be the same to
/// go on. Removes what a killed run has left of files that were being written; what is whole stays.
/// Throws Error when `out` holds anything else or a set made with other options, and when it cannot
/// write.
void PrepareSetFolder(const std::filesystem::path& out,
                      std::string_view parameters,
                      std::span<const std::string_view> subfolders);

}  // namespace handcraft::synthetic
