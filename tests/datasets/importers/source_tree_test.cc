// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/source_tree.h"

#include <sys/stat.h>

#include <map>
#include <optional>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr auto kNoName = [](const fs::path&) { return false; };

TEST(ListFiles, GoesAsDeepAsAsked) {
  const TemporaryDirectory folder;
  fs::create_directories(folder / "b/c");
  for (const char* name : {"z", "a", "b/m", "b/c/x"}) WriteFileAtomically(folder / name, "");
  EXPECT_THAT(ListFiles(folder.path(), 0, kNoName), ElementsAre(folder / "a", folder / "z"));
  EXPECT_THAT(ListFiles(folder.path(), 1, kNoName),
              ElementsAre(folder / "a", folder / "b/m", folder / "z"));
  EXPECT_THAT(ListFiles(folder.path(), 2, kNoName),
              ElementsAre(folder / "a", folder / "b/c/x", folder / "b/m", folder / "z"));
  EXPECT_THROWS_MESSAGE(
      ListFiles(folder / "no", 0, kNoName), Error, HasSubstr("cannot read the folder"));
  EXPECT_THROWS_MESSAGE(
      ListFiles(folder / "a", 0, kNoName),
      Error,
      HasSubstr("a: is a file; a folder is due (give the folder that it lies in)"));
}

TEST(ListFiles, FollowsLinksAndNamesThoseThatLeadNowhere) {
  const TemporaryDirectory folder;
  fs::create_directory(folder / "b");
  WriteFileAtomically(folder / "a", "");
  fs::create_symlink(folder / "a", folder / "b/link");
  EXPECT_THAT(ListFiles(folder.path(), 1, kNoName), ElementsAre(folder / "a", folder / "b/link"));
  fs::remove(folder / "a");
  EXPECT_THROWS_MESSAGE(
      ListFiles(folder.path(), 1, kNoName),
      Error,
      HasSubstr("b/link: is a symbolic link to " + (folder / "a").string() + ", where nothing is"));
}

TEST(ListFiles, NamesLinksToFoldersItWouldEnter) {
  const TemporaryDirectory folder;
  fs::create_directories(folder / "set/b");
  fs::create_directory(folder / "elsewhere");
  WriteFileAtomically(folder / "elsewhere/a.png", "");
  fs::create_directory_symlink("../elsewhere", folder / "set/more");
  fs::create_directory_symlink("../../elsewhere", folder / "set/b/.more");
  EXPECT_THROWS_MESSAGE(
      ListFiles(folder / "set", 1, kNoName),
      Error,
      HasSubstr("set/more: is a link to a folder, which is not followed (give the folder itself"));
  EXPECT_THAT(ListFiles(folder / "set", 0, kNoName), ::testing::IsEmpty())
      << "folders are not entered";
  EXPECT_THAT(ListFiles(folder / "set/more", 1, kNoName), ElementsAre(folder / "set/more/a.png"));
  fs::remove(folder / "set/more");
  EXPECT_THAT(ListFiles(folder / "set", 2, kNoName), ::testing::IsEmpty())
      << "hidden ones are passed by";
  fs::create_symlink("loop", folder / "set/loop");
  EXPECT_THROWS_MESSAGE(
      ListFiles(folder / "set", 2, kNoName), Error, HasSubstr("set/loop: is a symbolic"));
}

// Adversaries: what stands where a file is meant, and is none.
class RequireFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder_ / "folder");
    WriteFileAtomically(folder_ / "empty", "");
    WriteFileAtomically(folder_ / "full", "x");
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    fs::create_symlink("no", folder_ / "link");
  }

  TemporaryDirectory folder_;
  std::map<std::string, std::string> refusals_ = {
      {"folder", "folder: is a folder; a file is due"},
      {"empty", "empty: the file is empty (copy it again from its source, or remove it)"},
      {"pipe", "pipe: is a pipe or a device; a file is due (save what it gives to a file)"},
      {"link", "link: is a symbolic link to no, where nothing is"}};
};

TEST_F(RequireFileTest, NamesWhatIsNone) {
  for (const auto& [name, message] : refusals_) {
    EXPECT_THROWS_MESSAGE((RequireFile(folder_ / name), 0), Error, HasSubstr(message));
    EXPECT_THROWS_MESSAGE(HasFile(folder_ / name), Error, HasSubstr(message));
  }
  EXPECT_TRUE(HasFile(folder_ / "full"));
  EXPECT_FALSE(HasFile(folder_ / "no"));
  EXPECT_FALSE(HasFile(folder_ / "full/no"));
  EXPECT_NO_THROW(RequireFile(folder_ / "no"));
}

TEST_F(RequireFileTest, IsAskedOfFilesThatAreMeant) {
  fs::remove(folder_ / "link");
  refusals_.erase("link");
  for (const auto& [meant, message] : refusals_) {
    const auto is_meant = [name = meant](const fs::path& path) { return path.filename() == name; };
    EXPECT_THROWS_MESSAGE(ListFiles(folder_.path(), 0, is_meant), Error, HasSubstr(message));
  }
  EXPECT_THAT(ListFiles(folder_.path(), 0, kNoName),
              ElementsAre(folder_ / "empty", folder_ / "full"));
}

TEST_F(RequireFileTest, IsAskedOfNamedFiles) {
  for (const auto& [name, message] : refusals_) {
    EXPECT_THROWS_MESSAGE(FindNamedFile(folder_.path(), name, "x.json"), Error, HasSubstr(message));
  }
}

TEST(RequireFolder, NamesWhatIsNone) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "a", "");
  EXPECT_THROWS_MESSAGE((RequireFolder(folder / "a"), 0), Error, HasSubstr("is a file; a folder"));
  EXPECT_THROWS_MESSAGE((RequireFolder("/dev/null"), 0),
                        Error,
                        HasSubstr("/dev/null: is a pipe or a device; a folder is due"));
  EXPECT_NO_THROW(RequireFolder(folder.path()));
  EXPECT_NO_THROW(RequireFolder(folder / "no"));
}

TEST(IsNamedLikeAPicture, LooksAtTheExtension) {
  for (const char* name : {"a.png", "a.b.JPG", "x/y.jpeg", "a.BMP", "a.ppm", "a.pgm"}) {
    EXPECT_TRUE(IsNamedLikeAPicture(name)) << name;
  }
  for (const char* name : {"a", "png", ".png", "a.png.txt", "a.tiff", "a.png/b", ""}) {
    EXPECT_FALSE(IsNamedLikeAPicture(name)) << name;
  }
}

TEST(FindNamedFile, FindsWhatLiesBelow) {
  const TemporaryDirectory folder;
  fs::create_directory(folder / "b");
  WriteFileAtomically(folder / "b/ü ,\".png", "x");
  const fs::path expected = "b/ü ,\".png";
  EXPECT_EQ(FindNamedFile(folder.path(), "b/ü ,\".png", "x.json"), expected);
  EXPECT_EQ(FindNamedFile(folder.path(), ".\\b\\ü ,\".png", "x.json"), expected);
}

TEST(FindNamedFile, RefusesWhatDoesNot) {
  const TemporaryDirectory folder;
  fs::create_directory(folder / "below");
  WriteFileAtomically(folder / "a.png", "");
  const std::map<std::string, std::string> cases = {
      {"", "x.json: the file name '' is not one"},
      {std::string("a.png\0.png", 10), "'a.png(zero byte)' is not one"},
      {"/etc/hostname", "'/etc/hostname' leads out of"},
      {"../a.png", "leads out of"},
      {"b/../../a.png", "leads out of"},
      {"..\\a.png", "leads out of"},
      {"C:\\a.png", "leads out of"},
      {".", "is a folder; a file is due"}};
  for (const auto& [name, message] : cases) {
    EXPECT_THROWS_MESSAGE(
        FindNamedFile(folder / "below", name, "x.json"), Error, HasSubstr(message));
  }
  EXPECT_EQ(FindNamedFile(folder / "below", "a.png", "x.json"), std::nullopt);
}

TEST(ClassOfPath, IsTheFirstFolder) {
  EXPECT_EQ(ClassOfPath("mug/red/a.png"), "mug");
  EXPECT_EQ(ClassOfPath("a.png"), "object");
}

}  // namespace
}  // namespace handcraft::datasets
