// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/rejection_curve.h"

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

TEST(RejectionCurve, OfAHandCase) {
  const std::vector<RejectionPoint> curve =
      RejectionCurve({{3.0, false}, {1.0, true}, {2.0, true}, {2.0, false}});
  ASSERT_EQ(curve.size(), 3U);  // the two of doubt 2 come in together
  EXPECT_EQ(curve[0].limit, 1.0);
  EXPECT_EQ(curve[0].num_kept, 1U);
  EXPECT_EQ(curve[0].num_right, 1U);
  EXPECT_EQ(curve[1].limit, 2.0);
  EXPECT_EQ(curve[1].num_kept, 3U);
  EXPECT_EQ(curve[1].num_right, 2U);
  EXPECT_EQ(curve[2].num_kept, 4U);
  EXPECT_EQ(curve[2].num_right, 2U);
}

// Each point counts what a scan counts, and every share of a twentieth has its point.
TEST(RejectionCurve, CountsAsAScanDoes) {
  Rng rng(1);
  std::vector<JudgedAnswer> answers(1000);
  for (JudgedAnswer& answer : answers) answer = {rng.Normal(), rng.Uniform() < 0.6};
  const std::vector<RejectionPoint> curve = RejectionCurve(answers);
  ASSERT_EQ(curve.size(), kNumRejectionPoints);
  for (std::size_t p = 0; p < curve.size(); ++p) {
    std::size_t num_kept = 0;
    std::size_t num_right = 0;
    for (const JudgedAnswer& answer : answers) {
      if (answer.doubt > curve[p].limit) continue;
      ++num_kept;
      num_right += answer.is_right ? 1 : 0;
    }
    EXPECT_EQ(curve[p].num_kept, num_kept);
    EXPECT_EQ(curve[p].num_kept, 50 * (p + 1));
    EXPECT_EQ(curve[p].num_right, num_right);
  }
}

TEST(RejectionCurve, OfNothingAndOfEqualDoubts) {
  EXPECT_TRUE(RejectionCurve({}).empty());
  const std::vector<RejectionPoint> curve =
      RejectionCurve(std::vector<JudgedAnswer>(7, {.doubt = 1.0, .is_right = true}));
  ASSERT_EQ(curve.size(), 1U);
  EXPECT_EQ(curve[0].num_right, 7U);
}

}  // namespace
}  // namespace handcraft::experiments
