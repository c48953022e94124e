// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/option_rules.h"

#include "tests/support/expect_throws_message.h"

namespace handcraft {
namespace {

using ::testing::StrEq;

TEST(RequireOption, NamesFieldValueAndRule) {
  RequireOption(true, "Options.share", 0.5, "in (0, 1]");
  EXPECT_THROWS_MESSAGE(RequireOption(false, "Options.share", 1.5, "in (0, 1]"),
                        Error,
                        StrEq("Options.share is 1.5; it must be in (0, 1]"));
}

TEST(RequireOption, IsWrongUse) {
  try {
    RequireOption(false, "Options.share", 0, "in (0, 1]");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.details().kind, Error::Kind::kUsage);
  }
}

}  // namespace
}  // namespace handcraft
