// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handcraft {

/// The whole file as bytes. Throws Error (path, system's reason) when it is missing, a folder,
/// a pipe or a device, unreadable, or larger than max_bytes.
[[nodiscard]] std::vector<std::uint8_t> ReadFile(const std::filesystem::path& path,
                                                 std::size_t max_bytes = std::size_t{1} << 40);

/// As ReadFile, as text.
[[nodiscard]] std::string ReadTextFile(const std::filesystem::path& path);

/// Replaces `path` by `bytes` so that a reader, a crash or a full disk sees the old file or the
/// whole new one and never a part: temporary file in the same folder, fsync, rename.
/// Behind a symbolic link the target is replaced and the link stays. A device or pipe is written
/// to, not replaced. Missing parent folders are an error. Throws Error and removes the temporary
/// file on failure.
void WriteFileAtomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void WriteFileAtomically(const std::filesystem::path& path, std::string_view text);

}  // namespace handcraft
