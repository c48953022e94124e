// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/crc32c.h"

#include <cstddef>
#include <numeric>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::runtime {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes RandomBytes(std::size_t size, std::uint64_t index) {
  Rng rng = Rng::Stream(1, "crc32c", index);
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.Next());
  return bytes;
}

// RFC 3720, appendix B.4, and the check value of the catalogue of parametrised CRC algorithms.
TEST(Crc32c, GivesThePublishedValues) {
  Bytes rising(32);
  std::iota(rising.begin(), rising.end(), std::uint8_t{0});
  constexpr std::string_view kDigits = "123456789";
  for (const auto checksum : {Crc32c, Crc32cByTable}) {
    EXPECT_EQ(checksum({}), 0U);
    EXPECT_EQ(checksum(Bytes(32, 0x00)), 0x8A9136AAU);
    EXPECT_EQ(checksum(Bytes(32, 0xFF)), 0x62A8AB43U);
    EXPECT_EQ(checksum(rising), 0x46DD794EU);
    EXPECT_EQ(checksum(Bytes(kDigits.begin(), kDigits.end())), 0xE3069283U);
  }
}

TEST(Crc32c, IsTheSameByInstructionAndByTable) {
  const Bytes bytes = RandomBytes(300, 0);
  for (std::size_t begin = 0; begin < 16; ++begin) {
    for (std::size_t size = 0; begin + size <= bytes.size(); ++size) {
      const auto part = std::span(bytes).subspan(begin, size);
      ASSERT_EQ(Crc32c(part), Crc32cByTable(part)) << begin << " " << size;
    }
  }
}

TEST(Crc32c, ChangesWithAnyOneOrTwoBits) {
  const Bytes bytes = RandomBytes(24, 1);
  const std::uint32_t original = Crc32c(bytes);
  for (std::size_t a = 0; a < 8 * bytes.size(); ++a) {
    for (std::size_t b = a; b < 8 * bytes.size(); ++b) {
      Bytes flipped = bytes;
      flipped[a / 8] ^= static_cast<std::uint8_t>(1U << (a % 8));
      if (b != a) flipped[b / 8] ^= static_cast<std::uint8_t>(1U << (b % 8));
      ASSERT_NE(Crc32c(flipped), original) << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace handcraft::runtime
