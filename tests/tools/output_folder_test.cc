// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/output_folder.h"

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

TEST(OutputFolder, MakesFoldersAndKeepsFiles) {
  const TemporaryDirectory folder;
  {
    OutputFolder out(folder / "a/b");
    WriteFileAtomically(out.Claim("f"), "text");
    out.Keep();
  }
  EXPECT_EQ(ReadTextFile(folder / "a/b/f"), "text");
}

TEST(OutputFolder, LeavesNothingUnlessKept) {
  const TemporaryDirectory folder;
  {
    OutputFolder out(folder / "a/b");
    WriteFileAtomically(out.Claim("f"), "text");
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
}

TEST(OutputFolder, LeavesAloneWhatWasThere) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "old", "old");
  {
    OutputFolder out(folder.path());
    WriteFileAtomically(out.Claim("new"), "new");
  }
  EXPECT_EQ(ReadTextFile(folder / "old"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

TEST(OutputFolder, TakesATrailingSlash) {
  const TemporaryDirectory folder;
  OutputFolder out(folder.path() / "a" / "");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a"));
}

TEST(OutputFolder, RefusesAFileInTheWay) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "f", "text");
  EXPECT_THROWS_MESSAGE(
      OutputFolder(folder / "f/g"), Error, HasSubstr("cannot create the folder: "));
  EXPECT_EQ(ReadTextFile(folder / "f"), "text");
}

TEST(OutputFolder, RefusesTheSameFileTwice) {
  const TemporaryDirectory folder;
  OutputFolder out(folder / "a");
  EXPECT_EQ(out.Claim("f"), folder / "a/f");
  EXPECT_THROWS_MESSAGE(out.Claim("f"), Error, HasSubstr("a/f: two inputs would write this file"));
}

}  // namespace
}  // namespace handcraft::tools
