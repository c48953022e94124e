// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/sample_quotas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Counts = std::vector<std::size_t>;

PixelCounts Sum(const std::vector<PixelCounts>& counts) {
  PixelCounts sum;
  for (const PixelCounts& count : counts) sum = {sum.good + count.good, sum.bad + count.bad};
  return sum;
}

TEST(ShareEvenly, FillsUpToALevel) {
  EXPECT_THAT(ShareEvenly(Counts{10, 10, 10}, 9), ElementsAre(3, 3, 3));
  EXPECT_THAT(ShareEvenly(Counts{10, 10, 10}, 11), ElementsAre(4, 4, 3));
  EXPECT_THAT(ShareEvenly(Counts{10, 2, 10}, 14), ElementsAre(6, 2, 6));
  EXPECT_THAT(ShareEvenly(Counts{10, 2, 10}, 15), ElementsAre(7, 2, 6));
  EXPECT_THAT(ShareEvenly(Counts{1, 2, 0}, 100), ElementsAre(1, 2, 0));
  EXPECT_THAT(ShareEvenly(Counts{5, 5}, 0), ElementsAre(0, 0));
  EXPECT_THAT(ShareEvenly(Counts{}, 5), IsEmpty());
}

// Oracle: give one at a time to the one that has got least, the first of equals.
TEST(ShareEvenly, AgreesWithGivingOneAtATime) {
  Rng rng(21);
  for (int round = 0; round < 300; ++round) {
    Counts capacities(rng.UniformInt(7));
    for (std::size_t& capacity : capacities) capacity = rng.UniformInt(12);
    const std::size_t total = rng.UniformInt(60);
    Counts given(capacities.size());
    for (std::size_t left = total; left > 0; --left) {
      std::size_t best = given.size();
      for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i] < capacities[i] && (best == given.size() || given[i] < given[best])) best = i;
      }
      if (best == given.size()) break;
      ++given[best];
    }
    EXPECT_EQ(ShareEvenly(capacities, total), given);
  }
}

TEST(ShareSamples, GivesOneBadForEachGood) {
  const std::vector<PixelCounts> available = {{100, 1000}, {4, 1000}, {100, 1000}};
  EXPECT_THAT(ShareSamples(available, 40, 1.0),
              ElementsAre(PixelCounts{8, 8}, PixelCounts{4, 4}, PixelCounts{8, 8}));
}

TEST(ShareSamples, LeavesOutImagesOfOneKind) {
  const std::vector<PixelCounts> available = {{100, 0}, {0, 100}, {100, 100}, {0, 0}};
  EXPECT_EQ(Sum(ShareSamples(available, 20, 1.0)), (PixelCounts{10, 10}));
  EXPECT_EQ(ShareSamples(available, 20, 1.0)[2], (PixelCounts{10, 10}));
  EXPECT_EQ(Sum(ShareSamples(available, 0, 1.0)), (PixelCounts{100, 100}));
}

TEST(ShareSamples, TakesEveryPixelWhenAskedForZero) {
  const std::vector<PixelCounts> available = {{3, 100}, {50, 7}};
  EXPECT_EQ(ShareSamples(available, 0, 1.0), available);
}

// Laws over random cases: no more than there is, the whole number when there is enough, the ratio
// to within one pixel an image.
TEST(ShareSamples, KeepsTotalAndRatio) {
  Rng rng(22);
  for (int round = 0; round < 500; ++round) {
    std::vector<PixelCounts> available(1 + rng.UniformInt(6));
    for (PixelCounts& counts : available) counts = {rng.UniformInt(50), rng.UniformInt(400)};
    const std::size_t wanted = 1 + rng.UniformInt(300);
    const double ratio = std::exp(2.0 * rng.Normal());
    const std::vector<PixelCounts> quotas = ShareSamples(available, wanted, ratio);
    ASSERT_EQ(quotas.size(), available.size());
    for (std::size_t i = 0; i < quotas.size(); ++i) {
      EXPECT_LE(quotas[i].good, available[i].good);
      EXPECT_LE(quotas[i].bad, available[i].bad);
      const auto partners = static_cast<double>(quotas[i].good) * ratio;
      // One pixel for the carry, and the rounding of the whole number of good ones.
      EXPECT_NEAR(static_cast<double>(quotas[i].bad), partners, 2.0 + ratio);
    }
    const PixelCounts sum = Sum(quotas);
    EXPECT_LE(sum.good + sum.bad, wanted);
    const auto wanted_good =
        static_cast<std::size_t>(std::llround(static_cast<double>(wanted) / (1.0 + ratio)));
    if (wanted_good > 0 && sum.good == wanted_good) {
      EXPECT_GE(sum.good + sum.bad + available.size(), wanted);
    }
  }
}

TEST(ShareSamples, SurvivesExtremeRatios) {
  const std::vector<PixelCounts> available = {{100, 100}, {100, 100}};
  EXPECT_EQ(Sum(ShareSamples(available, 10, 1e300)).good, 0U);
  EXPECT_EQ(Sum(ShareSamples(available, 10, 1e-300)), (PixelCounts{10, 0}));
  const std::size_t huge = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ(Sum(ShareSamples(available, huge, 1.0)), (PixelCounts{200, 200}));
}

TEST(ShareSamples, ServesTheDissertationsNumber) {
  const std::vector<PixelCounts> available(100, {2000, 290000});
  EXPECT_EQ(Sum(ShareSamples(available, 154188, 1.0)), (PixelCounts{77094, 77094}));
}

}  // namespace
}  // namespace handcraft::datasets
