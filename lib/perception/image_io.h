// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>

#include "lib/core/image.h"
#include "lib/features/colour.h"

namespace handcraft::perception {

enum class Channels {
  kAsStored,  ///< 1 channel when the file is gray, else 3 (BGR)
  kGray,      ///< 1 channel; a colour file is refused, a palette must lead to gray values alone
};

/// Reads an 8-bit PNG, JPEG, BMP or PPM/PGM. JPEG rotation tags are applied; palettes become BGR;
/// an alpha channel is dropped. Pixels beyond the palette (CheckPaletteIndices), 16-bit and
/// floating-point files, empty and damaged ones are refused: throws Error with the path and what
/// was found.
[[nodiscard]] Image ReadImage(const std::filesystem::path& path,
                              Channels channels = Channels::kAsStored);

/// Reads a gray PNG or PGM of 16 bits, as depths are kept. Colour, other depths, empty and damaged
/// files are refused: throws Error with the path and what was found.
[[nodiscard]] BasicImage<std::uint16_t> ReadImage16(const std::filesystem::path& path);

/// Writes a PNG (1 or 3 channels), replacing the file atomically. Throws Error. Same picture, same
/// bytes.
void WritePng(const std::filesystem::path& path, const Image& image);

/// Writes a gray PNG of 16 bits, as depths are kept, replacing the file atomically. Throws Error.
/// Same values, same bytes.
void WritePng16(const std::filesystem::path& path, const BasicImage<std::uint16_t>& image);

/// The picture as the feature code takes it; the image must outlive the view.
[[nodiscard]] features::RawImage RawView(const Image& image);

}  // namespace handcraft::perception
