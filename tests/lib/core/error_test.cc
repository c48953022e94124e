// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft {
namespace {

TEST(Error, ReadsAsPathLineReasonRemedy) {
  const Error error({.path = "set/manifest.csv",
                     .line = 7,
                     .reason = "5 columns, expected 6",
                     .remedy = "add one"});
  EXPECT_STREQ(error.what(), "set/manifest.csv:7: 5 columns, expected 6 (add one)");
}

TEST(Error, ReadsWithByteOffset) {
  const Error error({.path = "m.safetensors", .byte = 12, .reason = "no '{'"});
  EXPECT_STREQ(error.what(), "m.safetensors at byte 12: no '{'");
}

TEST(Error, ReadsWithoutPath) {
  EXPECT_STREQ(Error({.reason = "ridge must be >= 0"}).what(), "ridge must be >= 0");
}

TEST(Error, StandsOnOneLineWhateverNamesHold) {
  EXPECT_STREQ(Error({.path = "a\nb.png", .reason = "the class 'x\t\x1B[2J'"}).what(),
               "a\\nb.png: the class 'x\\t\\x1B[2J'");
}

TEST(Error, EachKindHasItsExitCode) {
  EXPECT_EQ(ExitCode(Error::Kind::kUsage), 2);
  EXPECT_EQ(ExitCode(Error::Kind::kBadInput), 3);
  EXPECT_EQ(ExitCode(Error::Kind::kNoResult), 4);
}

}  // namespace
}  // namespace handcraft
