// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/inverse_kinematics_benchmark.h"

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

// Few poses; no limit on times.
TEST(InverseKinematicsBenchmark, SolvesAllAndComparesWithKdl) {
  const BenchmarkResult result =
      BenchmarkInverseKinematicsOf({.num_poses = 500, .num_peer_poses = 50, .num_slow_poses = 5});
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_EQ(result.dissertation_ms, 20.0);
  EXPECT_EQ(result.details.at("num_poses"), 500.0);
  EXPECT_EQ(result.details.at("ours_solved"), 1.0);
  EXPECT_LT(result.details.at("ours_largest_error_m"), 1e-9);
  EXPECT_LT(result.details.at("ours_largest_error_rad"), 1e-9);
  EXPECT_GT(result.details.at("kdl_lma_solved"), 0.5);
  EXPECT_EQ(result.details.at("kdl_nr_limits_poses"), 5.0);
  EXPECT_GT(result.details.at("kdl_restarts_solved"), 0.9);
}

}  // namespace
}  // namespace handcraft::experiments
