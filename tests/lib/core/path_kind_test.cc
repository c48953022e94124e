// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/path_kind.h"

#include <sys/stat.h>

#include <string>

#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

namespace fs = std::filesystem;

TEST(KindOf, TellsFilesFromFoldersAndFollowsLinks) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "f", "");
  fs::create_symlink("f", folder / "to_file");
  fs::create_symlink(".", folder / "to_folder");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(KindOf(folder / "f"), PathKind::kFile);
  EXPECT_EQ(KindOf(folder / "to_file"), PathKind::kFile);
  EXPECT_EQ(KindOf(folder.path()), PathKind::kFolder);
  EXPECT_EQ(KindOf(folder / "to_folder"), PathKind::kFolder);
  EXPECT_EQ(KindOf(folder / "pipe"), PathKind::kOther);
  EXPECT_EQ(KindOf("/dev/null"), PathKind::kOther);
  for (const char* name : {"f", "to_file", "to_folder", "pipe"}) {
    EXPECT_TRUE(Exists(folder / name)) << name;
  }
}

TEST(KindOf, NamesLinksThatLeadNowhereAndNeverThrows) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "f", "");
  fs::create_symlink("loop", folder / "loop");
  fs::create_symlink("gone", folder / "dangling");
  EXPECT_EQ(KindOf(folder / "loop"), PathKind::kBrokenLink);
  EXPECT_EQ(KindOf(folder / "dangling"), PathKind::kBrokenLink);
  EXPECT_EQ(KindOf(folder / "loop/below"), PathKind::kNothing);
  EXPECT_EQ(KindOf(folder / "no"), PathKind::kNothing);
  EXPECT_EQ(KindOf(folder / "f/below"), PathKind::kNothing);
  for (const char* name : {"loop", "dangling", "no"}) EXPECT_FALSE(Exists(folder / name)) << name;
  EXPECT_EQ(KindOf(""), PathKind::kNothing);
  EXPECT_EQ(KindOf(std::string(5000, 'x')), PathKind::kOther) << "longer than a name may be";
}

}  // namespace
}  // namespace handcraft
