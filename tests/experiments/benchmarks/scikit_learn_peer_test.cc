// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/scikit_learn_peer.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

// One feature, four counts: the optimum gives the shares 1/4 and 3/4, log-loss in closed form.
TEST(FitWithScikitLearn, FitsATable) {
  const std::vector<float> features = {0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<std::uint8_t> labels = {1, 0, 0, 0, 1, 1, 1, 0};
  const testing::TemporaryDirectory scratch;
  const auto fit = FitWithScikitLearn(features, labels, scratch.path());
  if (!fit) GTEST_SKIP() << "no python3 with scikit-learn >= 1.2 here";
  EXPECT_NEAR(fit->log_loss, -0.75 * std::log(0.75) - 0.25 * std::log(0.25), 1e-9);
  EXPECT_GT(fit->iterations, 0);
  EXPECT_GT(fit->seconds, 0.0);
  EXPECT_FALSE(fit->version.empty());
}

// A folder with a blank and a quote in its name reaches the peer whole; one class makes it fail.
TEST(FitWithScikitLearn, IsNothingWhenThePeerFails) {
  const testing::TemporaryDirectory scratch;
  const std::filesystem::path folder = scratch / "it's here";
  std::filesystem::create_directory(folder);
  EXPECT_FALSE(
      FitWithScikitLearn(std::vector<float>{0, 1}, std::vector<std::uint8_t>{1, 1}, folder));
  EXPECT_TRUE(std::filesystem::exists(folder / "features.npy"));
}

}  // namespace
}  // namespace handcraft::experiments
