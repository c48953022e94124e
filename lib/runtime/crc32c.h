// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>

namespace handcraft::runtime {

/// CRC-32C of the bytes: Castagnoli's polynomial 0x1EDC6F41, reflected, start and final value
/// 0xFFFFFFFF, as in RFC 3720 (iSCSI). Finds every error of one to three bits and every burst of up
/// to 32 in a model file. Uses the processor's instruction where there is one (SSE4.2, ARMv8 CRC;
/// asked at run time), else a table; same value either way.
[[nodiscard]] std::uint32_t Crc32c(std::span<const std::uint8_t> bytes) noexcept;

/// As Crc32c by the table alone, on any processor.
[[nodiscard]] std::uint32_t Crc32cByTable(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace handcraft::runtime
