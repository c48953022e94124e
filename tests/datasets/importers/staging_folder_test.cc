// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/staging_folder.h"

#include <filesystem>
#include <iterator>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

std::ptrdiff_t NumEntries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(StagingFolder, AppearsWholeOrNotAtAll) {
  const TemporaryDirectory parent;
  {
    StagingFolder staging(parent / "set");
    staging.AddFolder("a");
    WriteFileAtomically(staging.path() / "a/f", "x");
    EXPECT_FALSE(fs::exists(parent / "set"));
    staging.MoveToTarget();
    EXPECT_EQ(ReadTextFile(parent / "set/a/f"), "x");
  }
  EXPECT_EQ(NumEntries(parent.path()), 1) << "nothing else is left";
  EXPECT_EQ(ReadTextFile(parent / "set/a/f"), "x");
}

TEST(StagingFolder, GoesAwayUnlessMoved) {
  const TemporaryDirectory parent;
  {
    const StagingFolder staging(parent / "set");
    WriteFileAtomically(staging.path() / "f", "x");
  }
  EXPECT_EQ(NumEntries(parent.path()), 0);
}

TEST(StagingFolder, RemovesAFileAndTheFoldersItLeavesEmpty) {
  const TemporaryDirectory parent;
  StagingFolder staging(parent / "set");
  for (const char* name : {"a", "a/b", "c"}) staging.AddFolder(name);
  for (const char* name : {"a/b/f", "c/f", "c/g"}) WriteFileAtomically(staging.path() / name, "x");
  for (const char* name : {"a/b/f", "c/f", "c/no"}) staging.Remove(name);
  EXPECT_FALSE(fs::exists(staging.path() / "a"));
  EXPECT_EQ(NumEntries(staging.path() / "c"), 1);
  EXPECT_TRUE(fs::exists(staging.path() / "c/g"));
}

TEST(StagingFolder, TakesAnEmptyFolderAndATrailingSlash) {
  const TemporaryDirectory parent;
  fs::create_directory(parent / "set");
  StagingFolder staging(parent / "set/");
  WriteFileAtomically(staging.path() / "f", "x");
  staging.MoveToTarget();
  EXPECT_TRUE(fs::exists(parent / "set/f"));
}

TEST(StagingFolder, RefusesWhatIsThere) {
  const TemporaryDirectory parent;
  WriteFileAtomically(parent / "file", "x");
  EXPECT_THROWS_MESSAGE(StagingFolder(parent / "file"), Error, HasSubstr("is there already"));
  EXPECT_THROWS_MESSAGE(StagingFolder(parent.path()), Error, HasSubstr("not an empty folder"));
  EXPECT_THROWS_MESSAGE(
      StagingFolder(parent / "no/set"), Error, HasSubstr("cannot make the folder: No such file"));
  EXPECT_EQ(ReadTextFile(parent / "file"), "x");
}

}  // namespace
}  // namespace handcraft::datasets
