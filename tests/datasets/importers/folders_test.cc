// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/folders.h"

#include <string>

#include "tests/datasets/importers/importer_test.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A mask of 4 × 1 with the values 0, 1, 7, 255.
Image FourValues() {
  Image mask(4, 1);
  mask.At(1, 0) = 1;
  mask.At(2, 0) = 7;
  mask.At(3, 0) = 255;
  return mask;
}

class ListFoldersTest : public ImporterTest {
 protected:
  void WritePair(const fs::path& image, const fs::path& mask) const {
    WriteImage(image, 4, 1);
    WriteImage(mask, FourValues());
  }
};

std::vector<std::uint8_t> MaskOf(const SourceSet& set, std::size_t index = 0) {
  return set.pictures.at(index).make_mask(4, 1).values();
}

TEST_F(ListFoldersTest, PairsByNameAndTakesNonzeroForGood) {
  WritePair("images/mug/a b.png", "masks/mug/a b.PNG");
  WritePair("images/ü.png", "masks/ü.png");
  WriteText("images/README.txt", "not a picture");
  const SourceSet set = ListFolders(tree_, {});
  ASSERT_THAT(set.pictures, SizeIs(2));
  EXPECT_EQ(set.pictures[0].path, tree_ / "images/mug/a b.png");
  EXPECT_EQ(set.pictures[0].image, "mug/a b.png");
  EXPECT_EQ(set.pictures[0].mask, "mug/a b.png");
  EXPECT_EQ(set.pictures[0].object_class, "mug");
  EXPECT_EQ(set.pictures[0].instance, "mug/a b");
  EXPECT_EQ(set.pictures[1].object_class, "object");
  EXPECT_EQ(MaskOf(set), (std::vector<std::uint8_t>{0, 255, 255, 255}));
  EXPECT_THAT(FindFaults(ImportPictures(set, out_, {})), IsEmpty());
}

TEST_F(ListFoldersTest, MapsValues) {
  WritePair("images/a.png", "masks/a.png");
  EXPECT_EQ(MaskOf(ListFolders(tree_, {.good = {7}, .dont_care = {1}})),
            (std::vector<std::uint8_t>{0, 128, 255, 0}));
  EXPECT_EQ(MaskOf(ListFolders(tree_, {.dont_care = {255}})),
            (std::vector<std::uint8_t>{0, 255, 255, 128}));
  EXPECT_EQ(MaskOf(ListFolders(tree_, {.good = {0, 255}})),
            (std::vector<std::uint8_t>{255, 0, 0, 255}));
}

TEST_F(ListFoldersTest, TellsKindsApartBySuffix) {
  WritePair("cup1.png", "cup1_label.png");
  WritePair("cup2_label_.png", "cup2_label__label.png");
  const SourceSet set = ListFolders(tree_, {.images = ".", .masks = ".", .mask_suffix = "_label"});
  ASSERT_THAT(set.pictures, SizeIs(2));
  EXPECT_EQ(set.pictures[0].image, "cup1.png");
  EXPECT_EQ(set.pictures[0].instance, "cup1");
  EXPECT_EQ(set.pictures[1].image, "cup2_label_.png");
}

TEST_F(ListFoldersTest, TakesMasksBelowThePictures) {
  WritePair("a_rgb.png", "masks/a.png");
  EXPECT_THAT(ListFolders(tree_, {.images = ".", .image_suffix = "_rgb"}).pictures, SizeIs(1));
  WritePair("masks/sub/b_rgb.png", "masks/b.png");
  const SourceSet set = ListFolders(tree_, {.images = ".", .image_suffix = "_rgb"});
  EXPECT_THAT(set.pictures, SizeIs(1));
  ASSERT_THAT(set.notes, SizeIs(1));
  EXPECT_EQ(set.notes[0].path, (tree_ / "masks/b.png").string());
}

TEST_F(ListFoldersTest, LeavesOutWhatHasNoPartner) {
  WritePair("images/a.png", "masks/a.png");
  WriteImage("images/b.png", 4, 1);
  const SourceSet set = ListFolders(tree_, {});
  EXPECT_THAT(set.pictures, SizeIs(1));
  ASSERT_THAT(set.notes, SizeIs(1));
  EXPECT_EQ(set.notes[0].path, (tree_ / "images/b.png").string());
  EXPECT_EQ(set.notes[0].reason, "left out: no mask: expected " + (tree_ / "masks/….*").string());
  fs::rename(tree_ / "images/b.png", tree_ / "masks/b.png");
  const SourceSet other = ListFolders(tree_, {});
  ASSERT_THAT(other.notes, SizeIs(1));
  EXPECT_EQ(other.notes[0].path, (tree_ / "masks/b.png").string());
  EXPECT_EQ(other.notes[0].reason,
            "left out: no picture: expected " + (tree_ / "images/….*").string());
  WriteImage("images/a.bmp", 4, 1);
  EXPECT_THROWS_MESSAGE(
      ListFolders(tree_, {}), Error, HasSubstr("images/a.png: stands for the same picture as "));
}

TEST_F(ListFoldersTest, SaysWhatWasExpectedAndFound) {
  const auto refuses = [&](const std::string& message) {
    EXPECT_THROWS_MESSAGE(ListFolders(tree_, {}), Error, HasSubstr(message));
  };
  refuses(tree_.string() + ": expected the folder images/ in it, found nothing (name the folders");
  fs::create_directories(tree_ / "images");
  refuses("expected the folder masks/ in it, found images (name the folders");
  for (const char* name : {"a", "b", "c", "d", "e"}) fs::create_directories(tree_ / name);
  refuses("expected the folder masks/ in it, found a, b, c, d, e, … (name the folders");
  fs::create_directories(tree_ / "masks");
  WriteText("images/notes.txt", "");
  EXPECT_THROWS_MESSAGE(ListFolders(tree_, {}),
                        Error,
                        HasSubstr("no picture *.png, .jpg, .bmp, .ppm or .pgm with a mask; "
                                  "found 0 pictures and 0 masks"));
  EXPECT_THROWS_MESSAGE(ListFolders(tree_, {.images = "./masks", .masks = "masks/"}),
                        Error,
                        HasSubstr("the same folder and the same suffix"));
}

// Adversary: a camera that turns its JPEG by a tag; the mask is of the picture as it is seen.
TEST_F(ListFoldersTest, TakesATurnedJpegAsItIsSeen) {
  WritePair("images/x.png", "masks/a.png");
  fs::remove(tree_ / "images/x.png");
  testing::WriteTurnedJpeg(tree_ / "images/a.jpg", 64, 48);
  const SourceSet set = ListFolders(tree_, {});
  EXPECT_THROWS_MESSAGE(ImportPictures(set, out_, {}),
                        Error,
                        HasSubstr("a.png: the mask is 4x1 pixels, its picture 48x64"));
  WriteImage("masks/a.png", testing::CountedMask(48, 64, 9, 9));
  EXPECT_EQ(ReadMask(ImportPictures(set, out_, {}), 0).width(), 48);
}

TEST(FoldersOptions, NamesTheFieldAtFault) {
  EXPECT_THROWS_MESSAGE((FoldersOptions{.good = {256}}.Validate(), 0),
                        Error,
                        HasSubstr("FoldersOptions.good is 256; it must be from 0 to 255"));
  EXPECT_THROWS_MESSAGE(
      (FoldersOptions{.good = {1}, .dont_care = {1}}.Validate(), 0),
      Error,
      HasSubstr("the value 1 has two roles; it must be one of good and don't care"));
}

}  // namespace
}  // namespace handcraft::datasets
