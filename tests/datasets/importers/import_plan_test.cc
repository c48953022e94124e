// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/import_plan.h"

#include <map>
#include <string>
#include <vector>

#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// The splits of pictures numbered from 0, one letter a picture: r train, e test.
std::string SplitsOf(SourceSet source, const ImportOptions& options) {
  PlanImport(source, options);
  std::string letters;
  for (const SourcePicture& picture : source.pictures) letters += picture.split[1];
  return letters;
}

SourceSet Numbered(int count) {
  SourceSet source;
  for (int i = 0; i < count; ++i) {
    const std::string name(1, static_cast<char>('a' + i));
    source.pictures.push_back({.path = name,
                               .image = name + ".png",
                               .mask = name + ".png",
                               .instance = name,
                               .number = i});
  }
  return source;
}

TEST(PlanImport, SplitsThinsAndKeepsTheGap) {
  EXPECT_EQ(SplitsOf(Numbered(6), {}), "rrrree");
  EXPECT_EQ(SplitsOf(Numbered(6), {.test_share = 0.0}), "rrrrrr");
  EXPECT_EQ(SplitsOf(Numbered(6), {.max_images = 3}), "rre");
  SourceSet source = Numbered(6);
  source.split_gap = 3;
  EXPECT_EQ(SplitsOf(source, {}), "rree");
  PlanImport(source, {});
  ASSERT_EQ(source.notes.size(), 1U);
  EXPECT_EQ(source.notes[0].path, "c");
  EXPECT_EQ(source.notes[0].reason,
            "left out, the first of 2: its number is less than 3 below the first of the test, and "
            "it may show the same object");
}

TEST(PlanImport, RefusesTwins) {
  SourceSet source = Numbered(2);
  source.pictures[1].mask = "a.png";
  EXPECT_THROWS_MESSAGE(
      PlanImport(source, {}), Error, HasSubstr("b: stands for the same picture as a"));
}

TEST(PlanImport, RefusesNamesThatAreNotUtf8) {
  SourceSet source = Numbered(2);
  source.pictures[1].image = "z\xff.png";
  EXPECT_THROWS_MESSAGE(
      PlanImport(source, {}), Error, HasSubstr("b: the name is not UTF-8 after 'z' (rename"));
}

TEST(ImportOptions, NamesTheFieldAtFault) {
  const std::map<std::string, ImportOptions> cases = {
      {"test_share is 1; it must be in [0, 1)", {.test_share = 1.0}},
      {"max_images is -1", {.max_images = -1}},
      {"instance_pattern is '('; it must be a regular expression", {.instance_pattern = "("}},
      {"num_threads is 0", {.num_threads = 0}}};
  for (const auto& [message, options] : cases) {
    EXPECT_THROWS_MESSAGE((options.Validate(), 0), Error, HasSubstr("ImportOptions." + message));
  }
}

class CopyPictureTest : public ImporterTest {};

TEST_F(CopyPictureTest, CopiesAFileAndWritesAMadePicture) {
  WriteImage("a.png", 4, 3);
  std::vector<std::uint8_t> bytes = ReadFile(tree_ / "a.png");
  Image image = CopyPicture({.path = tree_ / "a.png"}, tree_ / "b.png");
  EXPECT_EQ(image.width(), 4);
  EXPECT_EQ(ReadFile(tree_ / "b.png"), bytes);
  CopyPicture({.embedded = [&] { return bytes; }}, tree_ / "c.png");
  EXPECT_EQ(ReadFile(tree_ / "c.png"), bytes);
  CopyPicture({.make_image = [&] { return image; }}, tree_ / "d.png");
  EXPECT_EQ(perception::ReadImage(tree_ / "d.png").values(), image.values());
  EXPECT_THROWS_MESSAGE(
      CopyPicture({.path = "x.json", .embedded = [] { return std::vector<std::uint8_t>{1}; }},
                  tree_ / "e.png"),
      Error,
      HasSubstr("x.json: the embedded picture: "));
}

TEST(AddFoldersOf, MakesParentsFirst) {
  const testing::TemporaryDirectory folder;
  StagingFolder staging(folder / "out");
  AddFoldersOf(staging, {"b/c/d.png", "a.png", "b/e.png"});
  staging.MoveToTarget();
  EXPECT_TRUE(fs::is_directory(folder / "out/b/c"));
}

TEST(TellNotes, GoesThroughThePicturesInOrder) {
  const std::vector<std::vector<Fault>> notes = {
      {{.path = "a", .reason = ""}, {.path = "b", .reason = ""}},
      {},
      {{.path = "c", .reason = ""}}};
  std::string told;
  TellNotes({{.path = "s", .reason = ""}}, notes, {.on_note = [&](const Fault& note) {
              told += note.path;
            }});
  EXPECT_EQ(told, "sabc");
  EXPECT_NO_THROW(TellNotes({}, notes, {})) << "nobody listens";
}

}  // namespace
}  // namespace handcraft::datasets
