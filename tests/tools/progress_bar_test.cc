// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/progress_bar.h"

#include <sstream>

#include <gmock/gmock.h>

namespace handcraft::tools {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

TEST(ProgressBar, DrawsNothingWhenPiped) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err, /*interactive=*/false};
  ProgressBar bar(console);
  EXPECT_FALSE(bar.Callback());
  bar.Clear();
  EXPECT_EQ(err.str(), "");
}

TEST(ProgressBar, DrawsShareAndStage) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err, /*interactive=*/true};
  ProgressBar bar(console);
  bar.Callback()("reading", 1, 4);
  EXPECT_THAT(err.str(), HasSubstr("reading  [#####---------------]  25 %"));
  bar.Callback()("reading", 9, 4);
  EXPECT_THAT(err.str(), HasSubstr("reading  [####################] 100 %"));
  EXPECT_EQ(out.str(), "");
}

TEST(ProgressBar, CountsWhenTheEndIsUnknown) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err, /*interactive=*/true};
  ProgressBar bar(console);
  bar.Callback()("iterating", 12, 0);
  EXPECT_THAT(err.str(), HasSubstr("iterating  12"));
}

TEST(ProgressBar, WritesOnlyWhatChanged) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err, /*interactive=*/true};
  ProgressBar bar(console);
  bar.Callback()("reading", 1000, 1000000);
  const std::string once = err.str();
  bar.Callback()("reading", 1001, 1000000);
  EXPECT_EQ(err.str(), once);
}

TEST(ProgressBar, LeavesACleanLine) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err, /*interactive=*/true};
  {
    ProgressBar bar(console);
    bar.Callback()("reading", 1, 2);
  }
  EXPECT_THAT(err.str(), EndsWith("\r\x1b[K"));
}

}  // namespace
}  // namespace handcraft::tools
