// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace handcraft::perception {

/// Refuses a picture with a pixel whose index is beyond its palette, which decoders draw black.
/// `bytes` is a whole file that ReadImageHeader has passed and that can be decoded; what has no
/// palette, or one with a colour for every index, costs nothing. Throws Error naming the first such
/// pixel, as stored, its index and the number of colours. Source: PNG 3rd edition, section 11.2.2;
/// BITMAPINFOHEADER, biClrUsed.
void CheckPaletteIndices(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace handcraft::perception
