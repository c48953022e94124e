// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace handcraft {

/// What can be allocated now without swapping [bytes]: MemAvailable of Linux; nothing where the
/// system does not tell.
[[nodiscard]] std::optional<std::uint64_t> AvailableMemory(
    const std::filesystem::path& meminfo = "/proc/meminfo");

/// Throws Error(kBadInput) "<what> needs 14746 MB of memory, of which 3210 MB are available
/// (<remedy>)" when more is needed than is available; never when that is not known.
void RequireMemory(std::uint64_t needed,
                   std::optional<std::uint64_t> available,
                   const std::string& what,
                   const std::string& remedy);

}  // namespace handcraft
