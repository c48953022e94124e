// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/benchmark.h"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

TEST(AllBenchmarks, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Benchmark& benchmark : AllBenchmarks()) {
    EXPECT_TRUE(names.insert(benchmark.name).second) << benchmark.name;
    EXPECT_FALSE(benchmark.what.empty());
    EXPECT_NE(benchmark.run, nullptr);
  }
  for (const char* name : {"score_all500_vga",
                           "score_edges54_vga",
                           "search_space_vga",
                           "load_model",
                           "train_irls_154188x500",
                           "pca_154188x500",
                           "inverse_kinematics",
                           "rotation_layer",
                           "nearest_demonstration"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(MedianMs, CallsOnceMoreThanItCounts) {
  int calls = 0;
  EXPECT_GE(MedianMs(5, [&] { ++calls; }), 0.0);
  EXPECT_EQ(calls, 6);
  EXPECT_THROW(static_cast<void>(MedianMs(0, [] {})), std::logic_error);
}

}  // namespace
}  // namespace handcraft::experiments
