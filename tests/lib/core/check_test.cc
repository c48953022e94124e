// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/check.h"

#include <stdexcept>

#include "tests/support/expect_throws_message.h"

namespace handcraft {
namespace {

using ::testing::HasSubstr;

void RequireEqual(int rows, int labels) { HC_CHECK(rows == labels, rows, labels); }

TEST(Check, PassesWhenTheConditionHolds) { EXPECT_NO_THROW(RequireEqual(3, 3)); }

TEST(Check, NamesConditionAndValues) {
  EXPECT_THROWS_MESSAGE(RequireEqual(3, 4),
                        std::logic_error,
                        HasSubstr("check failed: rows == labels [rows, labels = 3, 4]"));
}

TEST(Check, NamesFileAndLine) {
  EXPECT_THROWS_MESSAGE(
      RequireEqual(3, 4), std::logic_error, ::testing::ContainsRegex("check_test\\.cc:[0-9]+: "));
}

TEST(Check, NeedsNoValues) {
  const auto fail = [] { HC_CHECK(1 + 1 == 3); };
  EXPECT_THROWS_MESSAGE(fail(), std::logic_error, ::testing::EndsWith("check failed: 1 + 1 == 3"));
}

}  // namespace
}  // namespace handcraft
