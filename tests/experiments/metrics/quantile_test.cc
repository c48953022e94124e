// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/quantile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

TEST(Quantile, OfAHandCase) {
  const std::vector<double> values = {5.0, 1.0, 4.0, 2.0, 3.0};
  EXPECT_EQ(Quantile(values, 0.0), 1.0);
  EXPECT_EQ(Quantile(values, 0.5), 3.0);
  EXPECT_EQ(Quantile(values, 0.9), 5.0);
  EXPECT_EQ(Quantile(values, 0.6), 3.0);
  EXPECT_EQ(Quantile(values, 1.0), 5.0);
  EXPECT_EQ(Quantile({7.0}, 0.3), 7.0);
}

TEST(Quantile, OfNothingIsNoNumber) { EXPECT_TRUE(std::isnan(Quantile({}, 0.5))); }

}  // namespace
}  // namespace handcraft::experiments
