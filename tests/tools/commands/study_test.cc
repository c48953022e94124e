// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

TEST(Study, NamesItsCommands) {
  EXPECT_THAT(RunLine("study").err,
              HasSubstr("a command is missing; there are: run, compare, list"));
}

TEST(Study, NamesTheStudiesThereAre) {
  const Outcome outcome = RunLine("study run no-such-study --out nowhere");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("\"no-such-study\"; there are: feature-analysis, chapter3"));
}

TEST(Study, HelpsWithAnExample) {
  EXPECT_THAT(RunLine("study run --help").out, HasSubstr("handcraft study run"));
}

}  // namespace
}  // namespace handcraft::tools
