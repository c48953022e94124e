// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/lda/ledoit_wolf.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/trainers/lda/two_classes.h"

namespace handcraft::lda {
namespace {

double ShareOf(const TwoClasses& data, int num_threads = 1) {
  const Scatter scatter = ComputeScatter(data.X(), data.labels, 2);
  std::vector<double> scale;
  for (std::size_t j = 0; j < data.num_features; ++j) {
    scale.push_back(std::sqrt(scatter.products[j * data.num_features + j] /
                              static_cast<double>(data.labels.size())));
  }
  return LedoitWolfShare(data.X(), data.labels, scatter, scale, num_threads);
}

TEST(LedoitWolf, OfAHandCase) {
  // Each class has six rows ±(1, 1) and two ±(1, −1): R = [1 1/2; 1/2 1], Σ‖z‖⁴/n = 4, ‖R‖² = 2.5,
  // ‖R − I‖² = 0.5, hence λ = (4 − 2.5)/16/0.5.
  TwoClasses tilted{.num_features = 2};
  for (int label = 0; label < 2; ++label) {
    for (const double sign : {1.0, -1.0}) {
      for (const double second : {1.0, 1.0, 1.0, -1.0}) {
        tilted.values.insert(tilted.values.end(), {sign, sign * second});
        tilted.labels.push_back(static_cast<std::uint8_t>(label));
      }
    }
  }
  EXPECT_NEAR(ShareOf(tilted), 1.5 / 16.0 / 0.5, 1e-14);
}

TEST(LedoitWolf, ShrinksLessWithMoreSamplesAndIsNeverAboveOne) {
  double previous = 1.0;
  for (const std::size_t num_samples : {9U, 30U, 300U, 3000U}) {
    const double share = ShareOf(DrawTwoClasses(num_samples, 12, 1.0, 3));
    EXPECT_LT(share, previous);
    EXPECT_GT(share, 0.0);
    previous = share;
  }
  EXPECT_LT(previous, 0.01);
}

TEST(LedoitWolf, LeavesConstantColumnsOutAndThreadsAlone) {
  TwoClasses data = DrawTwoClasses(2500, 4, 1.0, 5);
  const double share = ShareOf(data);
  TwoClasses wider{.num_features = 5, .values = {}, .labels = data.labels};
  for (std::size_t i = 0; i < data.labels.size(); ++i) {
    wider.values.insert(wider.values.end(), data.X().Row(i), data.X().Row(i) + 4);
    wider.values.push_back(7.0);
  }
  EXPECT_NEAR(ShareOf(wider), share, 1e-12);
  EXPECT_EQ(ShareOf(wider, 3), ShareOf(wider, 1));
}

}  // namespace
}  // namespace handcraft::lda
