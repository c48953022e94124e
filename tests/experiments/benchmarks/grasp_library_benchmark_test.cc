// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {
namespace {

TEST(GraspLibraryBenchmark, MeasuresTheRotationLayer) {
  const BenchmarkResult result = BenchmarkRotationLayer({.repetitions = 1});
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_DOUBLE_EQ(result.ratio, result.peer_ms / result.ours_ms);
}

TEST(GraspLibraryBenchmark, TheTreeFindsWhatTheScanFinds) {
  const BenchmarkResult result = BenchmarkNearestDemonstration({.repetitions = 1});
  EXPECT_EQ(result.details.at("same_row"), 1.0);
  EXPECT_EQ(result.dissertation_ms, 7.0);
  EXPECT_DOUBLE_EQ(result.ratio, result.peer_ms / result.ours_ms);
}

}  // namespace
}  // namespace handcraft::experiments
