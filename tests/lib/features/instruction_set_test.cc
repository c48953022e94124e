// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/instruction_set.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace handcraft::features {
namespace {

TEST(SupportedInstructionSets, AreAscendingAndNotEmpty) {
  const auto sets = SupportedInstructionSets();
  ASSERT_FALSE(sets.empty());
  EXPECT_TRUE(std::is_sorted(sets.begin(), sets.end()));
  for (const InstructionSet set : sets) EXPECT_NE(NameOf(set), "unknown");
}

TEST(SupportedInstructionSets, StayTheSame) {
  EXPECT_EQ(SupportedInstructionSets().data(), SupportedInstructionSets().data());
}

}  // namespace
}  // namespace handcraft::features
