// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {
namespace {

// No limit on times. What must hold is that the chain went through to the region.
TEST(SearchSpaceBenchmark, GoesFromTheCloudToTheRegion) {
  const BenchmarkResult result = BenchmarkSearchSpaceVga({.repetitions = 1});
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_EQ(result.dissertation_ms, 172.0);
  EXPECT_EQ(result.details.at("pixels_picture"), 307200.0);
  EXPECT_GT(result.details.at("pixels_region"), 100.0);
  EXPECT_LT(result.details.at("pixels_region"), 100000.0);
  EXPECT_EQ(result.details.at("made_ours_points"), result.details.at("pixels_without_outliers"));
}

}  // namespace
}  // namespace handcraft::experiments
