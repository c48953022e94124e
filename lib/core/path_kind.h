// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace handcraft {

/// What stands at a path. A symbolic link counts as what it leads to.
enum class PathKind {
  kNothing,
  kFile,
  kFolder,
  kOther,      ///< a pipe, a socket, a device, or what cannot be looked at
  kBrokenLink  ///< a symbolic link that leads nowhere, or round in a circle
};

/// Unlike std::filesystem::exists and its kin, never throws: whoever opens the path tells the
/// system's reason.
[[nodiscard]] PathKind KindOf(const std::filesystem::path& path) noexcept;

/// Whether a path leads to anything: KindOf tells neither kNothing nor kBrokenLink.
[[nodiscard]] bool Exists(const std::filesystem::path& path) noexcept;

}  // namespace handcraft
