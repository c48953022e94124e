// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace handcraft::datasets {

/// No LZF stream grows by more than this factor: three bytes stand for up to 264.
inline constexpr std::size_t kMostLzfGrowth = 88;

/// Unpacks an LZF stream of `size` bytes once unpacked; nothing when the stream is damaged: it ends
/// in mid-item, points before its begin, or gives more or fewer bytes. Reads and writes nothing
/// beyond either. Format: a byte below 32, one less than the number of bytes that follow as they
/// are; else three bits of length (7: a byte of further length follows) and thirteen of distance
/// back, both less than they mean (length by 2, distance by 1).
/// Source: M. Lehmann's LibLZF, as PCD files of kind binary_compressed hold it.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> UnpackLzf(
    std::span<const std::uint8_t> packed, std::size_t size);

}  // namespace handcraft::datasets
