// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {
namespace {

TEST(LoadBenchmark, LoadsAWholeModel) {
  const BenchmarkResult result = BenchmarkLoadModel({.repetitions = 1});
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_GT(result.details.at("model_bytes"), 500.0 * 4.0);
  EXPECT_DOUBLE_EQ(result.ratio, result.peer_ms / result.ours_ms);
}

}  // namespace
}  // namespace handcraft::experiments
