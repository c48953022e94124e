// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/train_benchmark.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/benchmarks/two_pictures.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

// Two of the sample pictures and few samples; no limit on times.
TEST(TrainBenchmark, FillsEveryFigure) {
  const testing::TemporaryDirectory folder;
  CopyTwoPictures(folder.path());

  const BenchmarkResult result = BenchmarkTraining({.dataset = folder.path()},
                                                   {.num_samples = 2500,
                                                    .features = "edges54,energy=log",
                                                    .repetitions = 1,
                                                    .with_peer = false});
  EXPECT_GT(result.ours_ms, 0.0);
  EXPECT_TRUE(std::isnan(result.peer_ms));
  EXPECT_THAT(result.peer, ::testing::HasSubstr("not run"));
  EXPECT_EQ(result.details.at("num_samples"), 2500.0);
  EXPECT_GT(result.details.at("log_loss_ours"), 0.0);
  EXPECT_LT(result.details.at("log_loss_ours"), std::log(2.0));
  EXPECT_GT(result.details.at("speedup_2_threads"), 0.0);
  for (const char* count : {"54", "150", "180"}) {
    EXPECT_GT(result.details.at("seconds_" + std::string(count) + "_features"), 0.0);
  }
}

}  // namespace
}  // namespace handcraft::experiments
