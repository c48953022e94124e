// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/pca_benchmark.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/benchmarks/two_pictures.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

// Two of the sample pictures and few samples; no limit on times.
TEST(PcaBenchmark, FillsEveryFigure) {
  const testing::TemporaryDirectory folder;
  CopyTwoPictures(folder.path());
  const BenchmarkResult result = BenchmarkPrincipalComponents(
      {.dataset = folder.path()},
      {.num_samples = 2500, .features = "edges54", .repetitions = 1, .with_peer = true});
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_EQ(result.details.at("num_samples"), 2500.0);
  EXPECT_GT(result.details.at("single_error"), 0.0);
  EXPECT_LT(result.details.at("single_error"), 1e-5);
  if (std::isnan(result.peer_ms)) {
    EXPECT_THAT(result.peer, ::testing::HasSubstr("not run"));
    return;
  }
  EXPECT_THAT(result.peer, ::testing::HasSubstr("NumPy"));
  EXPECT_LT(result.details.at("eigenvalue_error"), 1e-12);
  EXPECT_GT(result.details.at("seconds_scikit_learn"), 0.0);
}

}  // namespace
}  // namespace handcraft::experiments
