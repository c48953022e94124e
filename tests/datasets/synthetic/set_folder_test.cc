// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/set_folder.h"

#include <array>
#include <string>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr std::array<std::string_view, 2> kFolders = {"images", "scenes"};

TEST(PrepareSetFolder, MakesTheFolderAndTakesItUpAgain) {
  const TemporaryDirectory folder;
  PrepareSetFolder(folder / "set", "seed = 1\n", kFolders);
  EXPECT_EQ(ReadTextFile(folder / "set/dataset.toml"), "seed = 1\n");
  WriteFileAtomically(folder / "set/images/whole.png", "pixels");
  PrepareSetFolder(folder / "set", "seed = 1\n", kFolders);
  EXPECT_EQ(ReadTextFile(folder / "set/images/whole.png"), "pixels");
  EXPECT_TRUE(fs::is_directory(folder / "set/scenes"));
}

TEST(PrepareSetFolder, RemovesWhatWasBeingWrittenAndNothingElse) {
  const TemporaryDirectory folder;
  PrepareSetFolder(folder / "set", "", kFolders);
  const std::array<std::string, 4> half = {
      "dataset.toml.aB3xYz", "images/a.png.aB3xYz", "images/a.pcd.000000", "scenes/a.toml.ZZZZZZ"};
  const std::array<std::string, 3> kept = {
      "images/a.png", "images/notes.aB3xYz", "images/a.png.old"};
  for (const std::string& name : half) WriteFileAtomically(folder / "set" / name, "half");
  for (const std::string& name : kept) WriteFileAtomically(folder / "set" / name, "whole");
  PrepareSetFolder(folder / "set", "", kFolders);
  for (const std::string& name : half) EXPECT_FALSE(fs::exists(folder / "set" / name)) << name;
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(folder / "set" / name)) << name;
}

TEST(PrepareSetFolder, RefusesWhatIsNotItsOwn) {
  const TemporaryDirectory folder;
  const auto refuses = [&](const std::string& name, const std::string& message) {
    EXPECT_THROWS_MESSAGE(
        PrepareSetFolder(folder / name, "seed = 2\n", kFolders), Error, HasSubstr(message));
  };
  PrepareSetFolder(folder / "set", "seed = 1\n", kFolders);
  refuses(
      "set",
      "dataset.toml:1: tells of a set made with other options: seed = 1 there, seed = 2 here (give "
      "--seed as there, or another folder)");
  EXPECT_EQ(ReadTextFile(folder / "set/dataset.toml"), "seed = 1\n");
  WriteFileAtomically(folder / "file", "");
  refuses("file", "file: is not a folder");
  fs::create_directory(folder / "others");
  WriteFileAtomically(folder / "others/mine", "precious");
  refuses("others", "others: is there already and is not an empty folder");
  refuses("no/set", "cannot make the folder: No such file");
  PrepareSetFolder(folder / "longer", "seed = 2\nviews = 3\n", kFolders);
  refuses("longer",
          "dataset.toml:2: tells of a set made with other options: views = 3 there, nothing here "
          "(give the options as there");
  PrepareSetFolder(folder / "pictures", "seed = 2\nnum_images = 3\n", kFolders);
  refuses("pictures", "num_images = 3 there, nothing here (give --images or --size as there");
  EXPECT_FALSE(fs::exists(folder / "others/images"));
}

TEST(PrepareSetFolder, TellsOfParametersThatWereCut) {
  const TemporaryDirectory folder;
  PrepareSetFolder(folder / "set", "seed = 1\n", kFolders);
  for (const std::string cut : {"", "seed = "}) {
    WriteFileAtomically(folder / "set/dataset.toml", cut);
    try {
      PrepareSetFolder(folder / "set", "seed = 1\n", kFolders);
      ADD_FAILURE() << "takes up '" << cut << "'";
    } catch (const Error& error) {
      EXPECT_EQ(error.details().kind, Error::Kind::kBadInput);
      EXPECT_THAT(error.what(),
                  HasSubstr("dataset.toml: is cut after " + std::to_string(cut.size()) + " bytes"));
    }
  }
}

TEST(PrepareSetFolder, RefusesLinksThatLeadRoundInACircle) {
  const TemporaryDirectory folder;
  fs::create_symlink("loop", folder / "loop");
  EXPECT_THROWS_MESSAGE(PrepareSetFolder(folder / "loop", "", kFolders),
                        Error,
                        HasSubstr("loop: cannot make the folder"));
  PrepareSetFolder(folder / "set", "", kFolders);
  fs::remove(folder / "set/dataset.toml");
  fs::create_symlink("dataset.toml", folder / "set/dataset.toml");
  EXPECT_THROWS_MESSAGE(PrepareSetFolder(folder / "set", "", kFolders),
                        Error,
                        HasSubstr("dataset.toml: cannot open: Too many levels of symbolic links"));
}

}  // namespace
}  // namespace handcraft::synthetic
