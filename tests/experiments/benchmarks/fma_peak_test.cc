// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/fma_peak.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

TEST(MeasureFmaPeak, KnowsTheFusedSetsOfThisProcessor) {
  for (const features::InstructionSet set : features::SupportedInstructionSets()) {
    const double peak = MeasureFmaPeak(set);
    if (set == features::InstructionSet::kAvx2 || set == features::InstructionSet::kAvx512) {
      EXPECT_GT(peak, 1e8) << NameOf(set);
    } else {
      EXPECT_TRUE(std::isnan(peak)) << NameOf(set);
    }
  }
}

}  // namespace
}  // namespace handcraft::experiments
