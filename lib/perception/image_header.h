// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace handcraft::perception {

/// Largest side of a picture [px]: pixel coordinates fit into 16 bits.
inline constexpr int kMaxImageSide_px = 65535;
/// Largest picture, in pixels.
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;

/// How many bits a value must have: up to 8 as pictures have, or 16 as depths have.
enum class ChannelBits { k8, k16 };

/// What the first bytes of a picture file say about it.
struct ImageHeader {
  std::string_view format;  ///< "PNG", "JPEG", "BMP", "PGM" or "PPM"
  int width = 0;            ///< [px], as stored: before a rotation tag is applied
  int height = 0;           ///< [px]
  bool gray = false;        ///< stored as intensities; a palette counts as colour
  bool may_turn = false;    ///< has an Exif part, whose rotation tag can swap width and height
  bool indexed = false;     ///< a PNG with a palette
};

/// Reads the header and walks the file to its end without decoding a pixel, so that a file that
/// must be refused is refused before memory is taken for its picture, and a damaged one with the
/// place of the damage. Checked: bits a channel, size limits, and completeness (PNG: every
/// chunk's length and CRC-32; JPEG: markers up to the end of the image; BMP, PGM, PPM: number of
/// bytes). Throws Error with path, byte and what was found. Allocates nothing on success.
/// Source: PNG 3rd edition, sections 5 and 11.2.1; ITU-T T.81, Annex B.
[[nodiscard]] ImageHeader ReadImageHeader(const std::filesystem::path& path,
                                          std::span<const std::uint8_t> bytes,
                                          ChannelBits due = ChannelBits::k8);

}  // namespace handcraft::perception
