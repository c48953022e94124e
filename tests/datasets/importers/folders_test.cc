// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/folders.h"

#include <functional>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::NoiseImage;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

// A mask of 4 × 1 with the values 0, 1, 7, 255.
Image FourValues() {
  Image mask(4, 1);
  mask.At(1, 0) = 1;
  mask.At(2, 0) = 7;
  mask.At(3, 0) = 255;
  return mask;
}

void Write(const fs::path& path, const Image& image) {
  fs::create_directories(path.parent_path());
  perception::WritePng(path, image);
}

void WritePair(const fs::path& image, const fs::path& mask) {
  Write(image, NoiseImage(4, 1, 3, std::hash<std::string>()(image.string())));
  Write(mask, FourValues());
}

std::vector<std::uint8_t> MaskOf(const SourceSet& set, std::size_t index = 0) {
  return set.pictures.at(index).make_mask(4, 1).values();
}

TEST(ListFolders, PairsByNameAndTakesNonzeroForGood) {
  const TemporaryDirectory folder;
  WritePair(folder / "images/mug/a b.png", folder / "masks/mug/a b.PNG");
  WritePair(folder / "images/ü.png", folder / "masks/ü.png");
  WriteFileAtomically(folder / "images/README.txt", "not a picture");
  const SourceSet set = ListFolders(folder.path(), {});
  ASSERT_THAT(set.pictures, SizeIs(2));
  EXPECT_EQ(set.pictures[0].path, folder / "images/mug/a b.png");
  EXPECT_EQ(set.pictures[0].image, "mug/a b.png");
  EXPECT_EQ(set.pictures[0].mask, "mug/a b.png");
  EXPECT_EQ(set.pictures[0].object_class, "mug");
  EXPECT_EQ(set.pictures[0].instance, "mug/a b");
  EXPECT_EQ(set.pictures[1].object_class, "object");
  EXPECT_EQ(MaskOf(set), (std::vector<std::uint8_t>{0, 255, 255, 255}));
  EXPECT_THAT(FindFaults(ImportPictures(set, folder / "out", {})), IsEmpty());
}

TEST(ListFolders, MapsValues) {
  const TemporaryDirectory folder;
  WritePair(folder / "images/a.png", folder / "masks/a.png");
  EXPECT_EQ(MaskOf(ListFolders(folder.path(), {.good = {7}, .dont_care = {1}})),
            (std::vector<std::uint8_t>{0, 128, 255, 0}));
  EXPECT_EQ(MaskOf(ListFolders(folder.path(), {.dont_care = {255}})),
            (std::vector<std::uint8_t>{0, 255, 255, 128}));
  EXPECT_EQ(MaskOf(ListFolders(folder.path(), {.good = {0, 255}})),
            (std::vector<std::uint8_t>{255, 0, 0, 255}));
}

TEST(ListFolders, TellsKindsApartBySuffix) {
  const TemporaryDirectory folder;
  WritePair(folder / "cup1.png", folder / "cup1_label.png");
  WritePair(folder / "cup2_label_.png", folder / "cup2_label__label.png");
  const SourceSet set =
      ListFolders(folder.path(), {.images = ".", .masks = ".", .mask_suffix = "_label"});
  ASSERT_THAT(set.pictures, SizeIs(2));
  EXPECT_EQ(set.pictures[0].image, "cup1.png");
  EXPECT_EQ(set.pictures[0].instance, "cup1");
  EXPECT_EQ(set.pictures[1].image, "cup2_label_.png");
}

TEST(ListFolders, TakesMasksBelowThePictures) {
  const TemporaryDirectory folder;
  WritePair(folder / "a_rgb.png", folder / "masks/a.png");
  EXPECT_THAT(ListFolders(folder.path(), {.images = ".", .image_suffix = "_rgb"}).pictures,
              SizeIs(1));
  WritePair(folder / "masks/sub/b_rgb.png", folder / "masks/b.png");
  EXPECT_THROWS_MESSAGE(ListFolders(folder.path(), {.images = ".", .image_suffix = "_rgb"}),
                        Error,
                        HasSubstr("masks/b.png: has no picture"));
}

TEST(ListFolders, WantsAPartnerForEachFile) {
  const TemporaryDirectory folder;
  WritePair(folder / "images/a.png", folder / "masks/a.png");
  Write(folder / "images/b.png", NoiseImage(4, 1, 3, 1));
  EXPECT_THROWS_MESSAGE(
      ListFolders(folder.path(), {}),
      Error,
      HasSubstr("images/b.png: has no mask: expected " + (folder / "masks/b").string() + ".*"));
  fs::rename(folder / "images/b.png", folder / "masks/b.png");
  EXPECT_THROWS_MESSAGE(
      ListFolders(folder.path(), {}), Error, HasSubstr("masks/b.png: has no picture: expected "));
  Write(folder / "images/a.bmp", NoiseImage(4, 1, 3, 1));
  EXPECT_THROWS_MESSAGE(ListFolders(folder.path(), {}),
                        Error,
                        HasSubstr("images/a.png: stands for the same picture as "));
}

TEST(ListFolders, SaysWhatWasExpectedAndFound) {
  const TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(
      ListFolders(folder.path(), {}), Error, HasSubstr("images/: cannot read the folder"));
  fs::create_directory(folder / "images");
  fs::create_directory(folder / "masks");
  WriteFileAtomically(folder / "images/notes.txt", "");
  EXPECT_THROWS_MESSAGE(ListFolders(folder.path(), {}),
                        Error,
                        HasSubstr("no picture *.png, .jpg, .bmp, .ppm or "
                                  ".pgm; found 1 files"));
  EXPECT_THROWS_MESSAGE(ListFolders(folder.path(), {.images = "./masks", .masks = "masks/"}),
                        Error,
                        HasSubstr("the same folder and the same suffix"));
}

// Adversary: a camera that turns its JPEG by a tag; the mask is of the picture as it is seen.
TEST(ListFolders, TakesATurnedJpegAsItIsSeen) {
  const TemporaryDirectory folder;
  WritePair(folder / "images/x.png", folder / "masks/a.png");
  fs::remove(folder / "images/x.png");
  testing::WriteTurnedJpeg(folder / "images/a.jpg", 64, 48);
  const SourceSet set = ListFolders(folder.path(), {});
  EXPECT_THROWS_MESSAGE(ImportPictures(set, folder / "out", {}),
                        Error,
                        HasSubstr("a.png: the mask is 4x1 pixels, its picture 48x64"));
  Write(folder / "masks/a.png", testing::CountedMask(48, 64, 9, 9));
  EXPECT_EQ(ReadMask(ImportPictures(set, folder / "out", {}), 0).width(), 48);
}

TEST(FoldersOptions, NamesTheFieldAtFault) {
  EXPECT_THROWS_MESSAGE((FoldersOptions{.good = {256}}.Validate(), 0),
                        Error,
                        HasSubstr("FoldersOptions.good is 256; it must be from 0 to 255"));
  EXPECT_THROWS_MESSAGE((FoldersOptions{.good = {1}, .dont_care = {1}}.Validate(), 0),
                        Error,
                        HasSubstr("FoldersOptions.dont_care is 1; it must be none of the good"));
}

}  // namespace
}  // namespace handcraft::datasets
