// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/peak_memory.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

TEST(PeakMemoryAbove, SeesMemoryThatCameAndWent) {
  constexpr std::size_t kBytes = 64U << 20U;
  const double peak = PeakMemoryAbove([&] {
    std::vector<char> memory(kBytes, 1);  // touched, then freed
    ASSERT_EQ(std::count(memory.begin(), memory.end(), 1), kBytes);
  });
  if (std::isnan(peak)) GTEST_SKIP() << "no /proc/self/clear_refs here";
  EXPECT_GE(peak, 0.95 * kBytes);
  EXPECT_LT(PeakMemoryAbove([] {}), 0.25 * kBytes);
}

}  // namespace
}  // namespace handcraft::experiments
