// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {
namespace {

// No limit on times: those are what the benchmark is for. What must hold is that both sides
// computed the same probabilities and that the figures belong together.
TEST(ScoreBenchmark, ComparesLikeWithLike) {
  const BenchmarkResult result = BenchmarkScoreEdges54Vga({.repetitions = 1});
  EXPECT_LT(result.details.at("worst_difference_gather"), 1e-4);
  EXPECT_LT(result.details.at("worst_difference_convolutions"), 1e-4);
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_DOUBLE_EQ(result.ratio, result.peer_ms / result.ours_ms);
  EXPECT_EQ(result.dissertation_ms, 1000.0);
}

}  // namespace
}  // namespace handcraft::experiments
