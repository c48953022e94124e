// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/probability_bins.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

TEST(BinProbabilities, CountsByHand) {
  const std::vector<float> probabilities = {0.0F, 0.125F, 0.25F, 0.5F, 1.0F};
  const std::vector<std::uint8_t> labels = {0, 1, 0, 1, 1};
  const std::vector<ProbabilityBin> bins = BinProbabilities(probabilities, labels, 4);
  ASSERT_EQ(bins.size(), 4U);
  EXPECT_EQ(bins[0].num_good, 1U);
  EXPECT_EQ(bins[0].num_bad, 1U);
  EXPECT_DOUBLE_EQ(bins[0].mean_probability, 0.0625);
  EXPECT_EQ(bins[1].num_bad, 1U);   // 0.25 opens the second bin
  EXPECT_EQ(bins[2].num_good, 1U);  // 0.5 the third
  EXPECT_EQ(bins[3].num_good, 1U);  // 1 closes the last
  EXPECT_DOUBLE_EQ(bins[2].low, 0.5);
  EXPECT_DOUBLE_EQ(bins[2].high, 0.75);
}

TEST(BinProbabilities, EverySampleFallsIntoTheBinThatHoldsIt) {
  Rng rng(1);
  std::vector<float> probabilities;
  std::vector<std::uint8_t> labels;
  for (int i = 0; i < 1000; ++i) {
    probabilities.push_back(static_cast<float>(rng.Uniform()));
    labels.push_back(static_cast<std::uint8_t>(rng.UniformInt(2)));
  }
  std::size_t total = 0;
  for (const ProbabilityBin& bin : BinProbabilities(probabilities, labels, 7)) {
    total += bin.Total();
    EXPECT_GE(bin.mean_probability, bin.low);
    EXPECT_LE(bin.mean_probability, bin.high);
  }
  EXPECT_EQ(total, 1000U);
}

TEST(BinProbabilities, EmptyBinsHaveNoMean) {
  for (const ProbabilityBin& bin : BinProbabilities({}, {}, 3)) {
    EXPECT_EQ(bin.Total(), 0U);
    EXPECT_TRUE(std::isnan(bin.mean_probability));
  }
}

TEST(BinProbabilities, RefusesWhatIsNoProbability) {
  const std::vector<std::uint8_t> labels = {1};
  for (const float wrong : {-0.1F, 1.5F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROWS_MESSAGE(BinProbabilities(std::vector<float>{wrong}, labels, 2),
                          std::logic_error,
                          HasSubstr("p >= 0.0 && p <= 1.0"));
  }
  EXPECT_THROWS_MESSAGE(BinProbabilities({}, labels, 2), std::logic_error, HasSubstr("0, 1"));
  EXPECT_THROWS_MESSAGE(BinProbabilities({}, {}, 0), std::logic_error, HasSubstr("num_bins"));
}

TEST(EstimateReliability, PutsImagesTogetherByHand) {
  const std::vector<std::vector<ProbabilityBin>> images = {
      {{0.0, 0.5, 1, 2, 0.2}, {0.5, 1.0, 0, 0, std::nan("")}},
      {{0.0, 0.5, 4, 2, 0.4}, {0.5, 1.0, 0, 0, std::nan("")}},
      {{0.0, 0.5, 0, 0, std::nan("")}, {0.5, 1.0, 0, 3, 0.8}}};
  const std::vector<ReliabilityBin> bins = EstimateReliability(images, 200, 1);
  ASSERT_EQ(bins.size(), 2U);
  EXPECT_EQ(bins[0].bin.num_good, 5U);
  EXPECT_EQ(bins[0].bin.num_bad, 4U);
  EXPECT_EQ(bins[0].bin.high, 0.5);
  EXPECT_DOUBLE_EQ(bins[0].bin.mean_probability, (3 * 0.2 + 6 * 0.4) / 9.0);
  EXPECT_DOUBLE_EQ(bins[0].good_share.value, 5.0 / 9.0);
  EXPECT_DOUBLE_EQ(bins[0].good_share.low, 1.0 / 3.0);   // the first image alone
  EXPECT_DOUBLE_EQ(bins[0].good_share.high, 2.0 / 3.0);  // the second alone
  EXPECT_EQ(bins[1].good_share.value, 0.0);
  EXPECT_TRUE(std::isnan(bins[1].good_share.low)) << "one image alone has no interval";
  EXPECT_TRUE(EstimateReliability({}, 200, 1).empty());
}

}  // namespace
}  // namespace handcraft::experiments
