// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

TEST(Study, NamesTheStudiesThereAre) {
  const Outcome outcome = RunLine("study run no-such-study");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no command 'no-such-study'; there are: feature-analysis"));
  EXPECT_THAT(RunLine("study").err, HasSubstr("a command is missing; there are: run"));
}

}  // namespace
}  // namespace handcraft::tools
