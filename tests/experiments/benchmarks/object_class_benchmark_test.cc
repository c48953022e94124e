// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/object_class_benchmark.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

constexpr ObjectClassBenchmarkSize kSmall{.num_classes = 3,
                                          .views_per_class = 4,
                                          .grid_size = 8,
                                          .object_px = 40,
                                          .peer_folds = 4,
                                          .repetitions = 1};

// Small; no limit on times.
TEST(ObjectClassBenchmark, LeaveOneOutFillsEveryFigure) {
  const BenchmarkResult result = BenchmarkLeaveOneOut({}, kSmall);
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_GT(result.peer_ms, 0.0);
  EXPECT_THAT(result.peer, ::testing::HasSubstr("OpenCV"));
  EXPECT_EQ(result.details.at("num_folds"), 12.0);
  EXPECT_EQ(result.details.at("num_machines"), 3.0 + 12.0 * 2.0);
  EXPECT_EQ(result.details.at("same_predictions"), 4.0);
}

TEST(ObjectClassBenchmark, ClassifyFillsEveryFigure) {
  const BenchmarkResult result = BenchmarkClassify({.repetitions = 1}, kSmall);
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_GT(result.details.at("features_ms"), 0.0);
  EXPECT_EQ(result.details.at("num_support_vectors"), 12.0);
}

}  // namespace
}  // namespace handcraft::experiments
