// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/png_crc.h"

#include <array>

#include <gtest/gtest.h>

namespace handcraft::perception {
namespace {

TEST(PngCrc, IsThatOfTheCatalogue) {
  // The check value of CRC-32/ISO-HDLC, and the last chunk of every PNG.
  EXPECT_EQ(PngCrc(std::array<std::uint8_t, 9>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}),
            0xCBF43926U);
  EXPECT_EQ(PngCrc(std::array<std::uint8_t, 4>{'I', 'E', 'N', 'D'}), 0xAE426082U);
  EXPECT_EQ(PngCrc({}), 0U);
}

}  // namespace
}  // namespace handcraft::perception
