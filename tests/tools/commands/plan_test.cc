// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

TEST(Plan, NamesItsCommands) {
  const testing::Outcome outcome = testing::RunLine("plan --help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, ::testing::HasSubstr("grasp"));
  EXPECT_EQ(testing::RunLine("plan").code, 2);
}

}  // namespace
}  // namespace handcraft::tools
