// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/rng.h"

#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft {
namespace {

// Reference: the authors' xoshiro256plusplus.c with the state filled by their splitmix64.c from
// seed 42, first three outputs.
TEST(Rng, FollowsThePublishedAlgorithm) {
  Rng rng(42);
  EXPECT_EQ(rng.Next(), 15021278609987233951ULL);
  EXPECT_EQ(rng.Next(), 5881210131331364753ULL);
  EXPECT_EQ(rng.Next(), 18149643915985481100ULL);
}

TEST(Rng, StreamsDependOnSeedNameAndIndexAlone) {
  EXPECT_EQ(Rng::Stream(1, "a", 2).Next(), Rng::Stream(1, "a", 2).Next());
  std::set<std::uint64_t> firsts;
  for (const std::uint64_t seed : {1, 2}) {
    for (const char* name : {"a", "b"}) {
      for (const std::uint64_t index : {0, 1}) firsts.insert(Rng::Stream(seed, name, index).Next());
    }
  }
  EXPECT_EQ(firsts.size(), 8U);
}

TEST(Rng, UniformHasTheRightMeanAndRange) {
  Rng rng(1);
  double sum = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = rng.Uniform();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 4.0 / std::sqrt(12.0 * kDraws));  // four standard errors
}

TEST(Rng, UniformIntIsFlat) {
  Rng rng(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts[rng.UniformInt(7)];
  for (const int count : counts) EXPECT_NEAR(count, 10000, 400);
  EXPECT_THROW(rng.UniformInt(0), std::logic_error);
}

TEST(Rng, NormalHasTheRightMoments) {
  Rng rng(3);
  double sum = 0.0;
  double sum_of_squares = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = rng.Normal();
    sum += value;
    sum_of_squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.013);
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0, 0.018);
}

TEST(Rng, ShuffleKeepsEveryValue) {
  Rng rng(4);
  std::vector<int> values(100);
  std::iota(values.begin(), values.end(), 0);
  rng.Shuffle(std::span<int>(values));
  EXPECT_FALSE(std::is_sorted(values.begin(), values.end()));
  EXPECT_EQ(std::set<int>(values.begin(), values.end()).size(), 100U);
}

TEST(Rng, SampleSortedDrawsEachIndexEquallyOften) {
  Rng rng(5);
  std::array<int, 10> counts{};
  for (int i = 0; i < 10000; ++i) {
    const auto chosen = rng.SampleSorted(10, 3);
    ASSERT_EQ(chosen.size(), 3U);
    ASSERT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    for (const std::size_t index : chosen) ++counts[index];
  }
  for (const int count : counts) EXPECT_NEAR(count, 3000, 200);
  EXPECT_EQ(rng.SampleSorted(4, 4), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_THROW(static_cast<void>(rng.SampleSorted(3, 4)), std::logic_error);
}

}  // namespace
}  // namespace handcraft
