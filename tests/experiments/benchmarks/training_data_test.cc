// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/training_data.h"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/experiments/benchmarks/two_pictures.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

TEST(ScratchFolder, GoesWithWhatIsInIt) {
  std::filesystem::path path;
  {
    const ScratchFolder folder;
    path = folder.path();
    std::ofstream(path / "file") << "text";
    EXPECT_TRUE(std::filesystem::exists(path / "file"));
    EXPECT_NE(ScratchFolder().path(), path);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TrainingData, GivesTheSamePixelsForEverySpecification) {
  const testing::TemporaryDirectory folder;
  CopyTwoPictures(folder.path());
  const ScratchFolder scratch;
  const TrainingData data({.dataset = folder.path()}, 600, scratch.path());
  const datasets::GraspPointSamples small = data.FeaturesOf("filters=edge_0,window=1");
  const datasets::GraspPointSamples large = data.FeaturesOf("filters=edge_0+edge_30,window=1");
  EXPECT_EQ(small.num_samples(), 600U);
  EXPECT_EQ(small.labels, large.labels);
  for (std::size_t i = 0; i < 600; ++i) {
    EXPECT_EQ(small.features[i], large.features[2 * i]);
  }
}

}  // namespace
}  // namespace handcraft::experiments
