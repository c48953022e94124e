// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>

namespace handcraft::perception {

/// CRC-32 of a chunk's type and data: polynomial 0xEDB88320, reflected, begun with and turned over
/// by all ones. Allocates nothing. Source: PNG 3rd edition, annex D.
[[nodiscard]] std::uint32_t PngCrc(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace handcraft::perception
