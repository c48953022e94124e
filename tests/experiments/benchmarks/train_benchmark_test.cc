// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/train_benchmark.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/formats/labelled_image_set.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

// Two of the sample pictures and few samples; no limit on times.
TEST(TrainBenchmark, FillsEveryFigure) {
  const testing::TemporaryDirectory folder;
  datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(
      std::string(HANDCRAFT_SOURCE_DIR) + "/datasets/samples/cornell_mini");
  set.items.resize(2);
  std::filesystem::create_directories(folder / "images");
  std::filesystem::create_directories(folder / "masks");
  for (const datasets::LabelledImage& item : set.items) {
    std::filesystem::copy(set.root / item.image, folder / item.image);
    std::filesystem::copy(set.root / item.mask, folder / item.mask);
  }
  set.root = folder.path();
  datasets::WriteManifest(set);

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
