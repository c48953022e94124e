// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/cost_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::uint32_t> Order(const std::vector<double>& costs) {
  std::vector<std::uint32_t> order = {7U};
  std::vector<std::uint64_t> scratch;
  OrderByCost(costs, order, scratch);
  return order;
}

TEST(OrderByCost, OrdersAFewByHand) {
  EXPECT_THAT(Order({}), IsEmpty());
  EXPECT_THAT(Order({1.0}), ElementsAre(0));
  EXPECT_THAT(Order({0.5, 0.25, 1e30, 0.0, 0.25}), ElementsAre(3, 1, 4, 0, 2));
}

TEST(OrderByCost, TellsCostsApartThatSinglePrecisionDoesNot) {
  const double above = std::nextafter(0.3, 1.0);
  EXPECT_THAT(Order({above, 0.3, std::nextafter(0.3, 0.0)}), ElementsAre(2, 1, 0));
}

TEST(OrderByCost, DoesAsAStableSort) {
  Rng rng(1);
  for (const std::size_t n : {2U, 50U, 300U, 3000U}) {
    std::vector<double> costs(n);
    for (double& cost : costs)
      cost = std::round(1000.0 * rng.Uniform()) * std::pow(10.0, -5.0 * rng.Uniform());
    for (std::size_t i = 0; i < n / 4; ++i) costs[rng.UniformInt(n)] = costs[0];
    std::vector<std::uint32_t> expected(n);
    std::iota(expected.begin(), expected.end(), 0U);
    std::stable_sort(
        expected.begin(), expected.end(), [&](auto a, auto b) { return costs[a] < costs[b]; });
    EXPECT_EQ(Order(costs), expected);
  }
}

}  // namespace
}  // namespace handcraft::robot
