// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/palette_indices.h"

#include <string>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "lib/perception/image_header.h"
#include "tests/lib/perception/png_builder.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

using testing::ByteVector;
using ::testing::HasSubstr;
using testing::PngBuilder;

void Check(const ByteVector& bytes) {
  static_cast<void>(ReadImageHeader("picture", bytes));
  CheckPaletteIndices("picture", bytes);
}

void ExpectRefused(const ByteVector& bytes, const std::string& message) {
  EXPECT_THROWS_MESSAGE((Check(bytes), 0), Error, HasSubstr(message));
}

// A palette of so many colours.
ByteVector Colours(std::size_t count) { return ByteVector(3 * count, 200); }

TEST(CheckPaletteIndices, PassesIndicesWithinThePalette) {
  Check(PngBuilder(2, 2, 8, 3).Chunk("PLTE", Colours(3)).Pixels({0, 0, 1, 0, 2, 2}).End());
  Check(PngBuilder(2, 1, 8, 3).Chunk("PLTE", Colours(256)).Pixels({0, 0, 255}).End());
  Check(PngBuilder(8, 1, 1, 3).Chunk("PLTE", Colours(2)).Pixels({0, 0xFF}).End());
}

TEST(CheckPaletteIndices, PassesWhatHasNoPalette) {
  Check(PngBuilder(2, 1, 8, 0).Pixels({0, 7, 255}).End());
  Check(PngBuilder(1, 1, 8, 2).Chunk("PLTE", Colours(1)).Pixels({0, 7, 8, 9}).End());
  Check({'P', '5', ' ', '1', ' ', '1', ' ', '2', '5', '5', '\n', 9});
}

TEST(CheckPaletteIndices, NamesTheFirstPixelBeyondThePalette) {
  ExpectRefused(PngBuilder(2, 2, 8, 3).Chunk("PLTE", Colours(2)).Pixels({0, 0, 1, 0, 7, 9}).End(),
                "picture: damaged PNG: pixel (0, 1) has palette index 7, but the palette has 2 "
                "colours (save");
  ExpectRefused(PngBuilder(1, 1, 8, 3).Chunk("PLTE", Colours(1)).Pixels({0, 1}).End(),
                "has palette index 1, but the palette has 1 colour (");
}

TEST(CheckPaletteIndices, SeesIndicesOfFewBits) {
  const auto picture = [](int bits, std::size_t num_colours, std::uint8_t row) {
    return PngBuilder(2, 1, bits, 3).Chunk("PLTE", Colours(num_colours)).Pixels({0, row}).End();
  };
  ExpectRefused(picture(1, 1, 0b01000000), "pixel (1, 0) has palette index 1, but");
  ExpectRefused(picture(2, 2, 0b01100000), "pixel (1, 0) has palette index 2, but");
  ExpectRefused(picture(4, 11, 0xAB), "pixel (1, 0) has palette index 11, but");
  Check(picture(1, 1, 0));
  Check(picture(2, 3, 0b01100000));
  Check(picture(4, 12, 0xAB));
}

TEST(CheckPaletteIndices, LooksPastOtherChunksAndBytesBehindTheEnd) {
  const auto picture = [](std::uint8_t index) {
    ByteVector bytes = PngBuilder(1, 1, 8, 3)
                           .Chunk("sBIT", {8, 8, 8})
                           .Chunk("PLTE", Colours(2))
                           .Chunk("tRNS", {0})
                           .Pixels({0, index})
                           .End();
    bytes.insert(bytes.end(), {0xFF, 0xFF, 0xFF, 0xFF, 'j', 'u', 'n', 'k'});
    return bytes;
  };
  Check(picture(1));
  ExpectRefused(picture(2), "palette index 2");
}

// A BMP of 3 x 2 pixels, 8 bits, whose bottom row stands first.
ByteVector Bmp(std::uint8_t num_colours, const ByteVector& rows, bool top_row_first = false) {
  ByteVector bytes(54 + std::size_t{4} * num_colours, 0);
  bytes[0] = 'B';
  bytes[1] = 'M';
  bytes[10] = static_cast<std::uint8_t>(bytes.size());
  bytes[14] = 40;
  bytes[18] = 3;
  bytes[22] = top_row_first ? 0xFE : 2;
  for (std::size_t i = 23; i < 26; ++i) bytes[i] = top_row_first ? 0xFF : 0;
  bytes[26] = 1;
  bytes[28] = 8;
  bytes[46] = num_colours;
  bytes.insert(bytes.end(), rows.begin(), rows.end());
  return bytes;
}

TEST(CheckPaletteIndices, LooksAtABmpToo) {
  Check(Bmp(2, {0, 1, 0, 9, 1, 1, 1, 9}));
  const ByteVector rows = {0, 0, 0, 9, 0, 5, 0, 9};  // 9: padding
  ExpectRefused(Bmp(2, rows),
                "damaged BMP: pixel (1, 0) has palette index 5, but the palette has 2");
  ExpectRefused(Bmp(2, rows, true), "damaged BMP: pixel (1, 1) has palette index 5");
}

}  // namespace
}  // namespace handcraft::perception
