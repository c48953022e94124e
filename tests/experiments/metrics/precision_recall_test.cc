// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/precision_recall.h"

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

TEST(PrecisionRecallCurve, CountsByHand) {
  const std::vector<float> scores = {0.9F, 0.8F, 0.8F, 0.3F, 0.1F};
  const std::vector<std::uint8_t> labels = {1, 1, 0, 0, 1};
  const std::vector<PrecisionRecallPoint> curve = PrecisionRecallCurve(scores, labels, 100);
  ASSERT_EQ(curve.size(), 4U);
  EXPECT_DOUBLE_EQ(curve[0].recall, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(curve[0].precision, 1.0);
  EXPECT_DOUBLE_EQ(curve[1].recall, 2.0 / 3.0);  // the tie counts as one threshold
  EXPECT_DOUBLE_EQ(curve[1].precision, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(curve[2].precision, 2.0 / 4.0);
  EXPECT_DOUBLE_EQ(curve[3].recall, 1.0);
  EXPECT_DOUBLE_EQ(curve[3].precision, 3.0 / 5.0);
}

TEST(PrecisionRecallCurve, RisesInRecallAndEndsAtTheShareOfGoodSamples) {
  Rng rng(5);
  std::vector<float> scores;
  std::vector<std::uint8_t> labels;
  for (int i = 0; i < 1000; ++i) {
    scores.push_back(static_cast<float>(rng.Uniform()));
    labels.push_back(static_cast<std::uint8_t>(rng.UniformInt(4) == 0));
  }
  const std::vector<PrecisionRecallPoint> curve = PrecisionRecallCurve(scores, labels, 50);
  ASSERT_EQ(curve.size(), 50U);
  for (std::size_t k = 1; k < curve.size(); ++k) EXPECT_GE(curve[k].recall, curve[k - 1].recall);
  std::size_t num_good = 0;
  for (const std::uint8_t label : labels) num_good += label;
  EXPECT_DOUBLE_EQ(curve.back().recall, 1.0);
  EXPECT_DOUBLE_EQ(curve.back().precision, static_cast<double>(num_good) / 1000.0);
}

TEST(PrecisionRecallCurve, IsEmptyWithoutGoodSamples) {
  EXPECT_TRUE(PrecisionRecallCurve({}, {}, 2).empty());
  EXPECT_TRUE(
      PrecisionRecallCurve(std::vector<float>{0.5F}, std::vector<std::uint8_t>{0}, 2).empty());
}

TEST(PrecisionRecallCurve, RefusesBadInput) {
  const std::vector<float> scores = {0.5F};
  const std::vector<float> with_nan = {std::numeric_limits<float>::quiet_NaN()};
  const std::vector<std::uint8_t> labels = {1};
  const std::vector<std::uint8_t> two = {2};
  EXPECT_THROW(static_cast<void>(PrecisionRecallCurve(scores, {}, 2)), std::logic_error);
  EXPECT_THROW(static_cast<void>(PrecisionRecallCurve(with_nan, labels, 2)), std::logic_error);
  EXPECT_THROW(static_cast<void>(PrecisionRecallCurve(scores, two, 2)), std::logic_error);
  EXPECT_THROW(static_cast<void>(PrecisionRecallCurve(scores, labels, 1)), std::logic_error);
}

}  // namespace
}  // namespace handcraft::experiments
