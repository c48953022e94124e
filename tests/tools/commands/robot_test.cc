// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

TEST(Robot, NamesItsCommands) {
  const testing::Outcome outcome = testing::RunLine("robot --help");
  EXPECT_EQ(outcome.code, 0);
  for (const char* name : {"info", "fk", "ik"}) {
    EXPECT_THAT(outcome.out, ::testing::HasSubstr(name));
  }
  EXPECT_EQ(testing::RunLine("robot").code, 2);
}

}  // namespace
}  // namespace handcraft::tools
