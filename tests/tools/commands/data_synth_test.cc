// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>

#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

TEST(DataSynth, NamesTheKinds) {
  const Outcome help = RunLine("data synth --help");
  EXPECT_EQ(help.code, 0);
  for (const char* kind : {"grasp-points", "turntable", "moved"}) {
    EXPECT_THAT(help.out, HasSubstr(kind));
  }
}

TEST(DataSynth, NeedsAKind) {
  EXPECT_EQ(RunLine("data synth").code, 2);
  EXPECT_EQ(RunLine("data synth pictures --out made").code, 2);
}

}  // namespace
}  // namespace handcraft::tools
