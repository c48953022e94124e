// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/lzf.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <gmock/gmock.h>

#include "lib/core/rng.h"

namespace handcraft::datasets {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes ToBytes(std::string_view text) { return {text.begin(), text.end()}; }

// The longest earlier occurrence of what stands at `at`, by brute force.
struct Match {
  std::size_t length = 0;
  std::size_t distance = 0;
};
Match FindMatch(const Bytes& plain, std::size_t at) {
  Match best;
  for (std::size_t distance = 1; distance <= std::min<std::size_t>(at, 8192); ++distance) {
    std::size_t length = 0;
    while (length < 264 && at + length < plain.size() &&
           plain[at + length] == plain[at + length - distance]) {
      ++length;
    }
    if (length > best.length) best = {length, distance};
  }
  return best;
}

// A packer as slow as it is simple.
Bytes Pack(const Bytes& plain) {
  Bytes packed;
  for (std::size_t at = 0; at < plain.size();) {
    const Match match = FindMatch(plain, at);
    if (match.length < 3) {
      packed.push_back(0);
      packed.push_back(plain[at++]);
      continue;
    }
    const std::size_t length = match.length - 2;
    const std::size_t distance = match.distance - 1;
    packed.push_back(
        static_cast<std::uint8_t>(std::min<std::size_t>(length, 7) << 5U | distance >> 8U));
    if (length >= 7) packed.push_back(static_cast<std::uint8_t>(length - 7));
    packed.push_back(static_cast<std::uint8_t>(distance & 255U));
    at += match.length;
  }
  return packed;
}

TEST(UnpackLzf, UnpacksByHand) {
  // Three bytes as they are, then five from three back: what the copy itself writes is copied on.
  EXPECT_EQ(UnpackLzf(Bytes{2, 'a', 'b', 'c', 3U << 5U, 2}, 8), ToBytes("abcabcab"));
  // One byte, then 9 + 200 of the same: the long form.
  EXPECT_EQ(UnpackLzf(Bytes{0, 'z', 7U << 5U, 200, 0}, 210), Bytes(210, 'z'));
  EXPECT_EQ(UnpackLzf(Bytes{}, 0), Bytes{});
}

TEST(UnpackLzf, GivesBackWhatWasPacked) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    Rng rng = Rng::Stream(1, "lzf", i);
    Bytes plain(1 + rng.UniformInt(900));
    const std::uint64_t letters = 1 + rng.UniformInt(i % 2 == 0 ? 3 : 256);
    for (std::uint8_t& byte : plain) byte = static_cast<std::uint8_t>(rng.UniformInt(letters));
    EXPECT_EQ(UnpackLzf(Pack(plain), plain.size()), plain) << i;
  }
}

TEST(UnpackLzf, RefusesDamagedStreams) {
  const Bytes good = {2, 'a', 'b', 'c', 3U << 5U, 2};
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_FALSE(UnpackLzf(std::span(good).first(size), 8)) << "cut at " << size;
  }
  EXPECT_FALSE(UnpackLzf(good, 7)) << "gives more";
  EXPECT_FALSE(UnpackLzf(good, 9)) << "gives less";
  EXPECT_FALSE(UnpackLzf(Bytes{0, 'a', 1U << 5U, 1}, 4)) << "points before the begin";
  EXPECT_FALSE(UnpackLzf(Bytes{1U << 5U, 0}, 3)) << "points before anything";
  EXPECT_FALSE(UnpackLzf(Bytes{31, 'a'}, 32)) << "announces more than is there";
  EXPECT_FALSE(UnpackLzf(Bytes{0, 'a', 7U << 5U}, 300)) << "no further length";
  EXPECT_FALSE(UnpackLzf(good, std::size_t{1} << 60)) << "no memory is taken for it";
}

TEST(UnpackLzf, SurvivesNoise) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Rng rng = Rng::Stream(2, "lzf", i);
    Bytes noise(rng.UniformInt(60));
    for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(rng.UniformInt(256));
    const std::size_t size = rng.UniformInt(500);
    const auto plain = UnpackLzf(noise, size);
    if (plain) {
      EXPECT_EQ(plain->size(), size);
    }
  }
}

}  // namespace
}  // namespace handcraft::datasets
