// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/contact_sheet.h"

#include <gmock/gmock.h>

#include "datasets/sheet_pictures.h"
#include "lib/core/error.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using testing::AddPicture;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

// One class of gray pictures without labels, one of a picture that is good all over.
LabelledImageSet TwoClasses(const std::filesystem::path& root) {
  LabelledImageSet set{.root = root, .items = {}};
  for (const char* name : {"a", "b", "c", "d"}) {
    AddPicture(set, name, Image(40, 30, 3, 100), Image(40, 30));
  }
  AddPicture(set, "wide", Image(80, 20, 1, 200), Image(80, 20, 1, kMaskGood));
  set.items.back().object_class = "wide_object";
  return set;
}

TEST(DrawOverview, HasARowAClassAndEachPictureTwice) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = TwoClasses(folder.path());
  const Image sheet =
      DrawOverview(SheetPicturesOf(set), {.images_per_class = 3, .tile_width_px = 40});
  ASSERT_EQ(sheet.width(), 2 * 3 * 40);
  ASSERT_EQ(sheet.height(), 2 * 30);
  EXPECT_EQ(sheet.At(20, 15, 0), 100) << "96 ... 103 become 100";
  EXPECT_EQ(sheet.At(60, 15, 1), 100) << "no label, no colour";
  EXPECT_EQ(sheet.At(20, 45, 1), 204) << "the second class, 200 ... 207";
  EXPECT_GT(sheet.At(60, 45, 1), sheet.At(60, 45, 2) + 50) << "good is green";
  EXPECT_EQ(sheet.At(20, 32, 1), 4) << "above a wide picture it is black";
  EXPECT_EQ(sheet.At(100, 45, 1), 4) << "there is one wide picture";
}

TEST(DrawOverview, GivesTheSameForAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = testing::MakeSet(folder.path());
  EXPECT_EQ(DrawOverview(SheetPicturesOf(set), {}).values(),
            DrawOverview(SheetPicturesOf(set), {.num_threads = 3}).values());
}

TEST(DrawOverview, NamesWhatIsWrong) {
  const TemporaryDirectory folder;
  LabelledImageSet set = TwoClasses(folder.path());
  EXPECT_THROWS_MESSAGE(DrawOverview({}, {}), Error, HasSubstr("the set has no pictures"));
  set.items[0].image = "gone.png";
  const std::vector<SheetPicture> pictures = SheetPicturesOf(set);
  EXPECT_THROWS_MESSAGE(DrawOverview(pictures, {}), Error, HasSubstr("gone.png"));
  EXPECT_THROWS_MESSAGE(DrawOverview(pictures, {.images_per_class = 0}),
                        Error,
                        HasSubstr("OverviewOptions.images_per_class is 0"));
  EXPECT_THROWS_MESSAGE(DrawOverview(pictures, {.tile_width_px = 5}),
                        Error,
                        HasSubstr("OverviewOptions.tile_width_px is 5"));
}

// Pictures of one gray each, 10 more than the one before.
std::vector<SheetPicture> Grays(int count, std::vector<int>* drawn = nullptr) {
  std::vector<SheetPicture> pictures;
  pictures.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    pictures.push_back({.row = "gray", .caption = "", .draw = [i, drawn] {
                          if (drawn != nullptr) drawn->push_back(i);
                          return std::vector<Image>{
                              Image(4, 3, 3, static_cast<std::uint8_t>(10 * i))};
                        }});
  }
  return pictures;
}

TEST(DrawPage, ShowsItsPicturesInOrderAndDrawsNoOthers) {
  std::vector<int> drawn;
  const PageOptions options{.page = 2, .columns = 2, .rows = 2, .tile_width_px = 16};
  const Image page = DrawPage(Grays(7, &drawn), options);
  EXPECT_THAT(drawn, ::testing::ElementsAre(4, 5, 6));
  EXPECT_EQ(page.width(), 2 * (16 + 4));
  EXPECT_EQ(page.height(), 2 * (12 + 16 + 4));
  EXPECT_EQ(page.At(8, 6, 0), 44) << "40 ... 47 become 44";
  EXPECT_EQ(page.At(28, 6, 0), 52);
  EXPECT_EQ(page.At(8, 38, 0), 60);
  EXPECT_EQ(page.At(28, 38, 0), 4) << "an empty place is black";
  EXPECT_EQ(NumPages(7, options), 2);
  EXPECT_EQ(NumPages(8, options), 2);
  EXPECT_EQ(NumPages(9, options), 3);
}

TEST(DrawPage, ShowsLabelsAndCaptions) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = TwoClasses(folder.path());
  const PageOptions options{.columns = 5, .tile_width_px = 64, .num_threads = 2};
  const Image page = DrawPage(SheetPicturesOf(set), options);
  EXPECT_GT(page.At(4 * 68 + 32, 24, 1), page.At(4 * 68 + 32, 24, 2) + 50) << "good is green";
  int lit = 0;
  for (int u = 4 * 68; u < 4 * 68 + 64; ++u) {
    for (int v = 48; v < 64; ++v) lit += page.At(u, v, 0) > 100 ? 1 : 0;
  }
  EXPECT_GT(lit, 10) << "its name is written below";
}

TEST(DrawPage, ShowsTheWholePictureBesideTheLast) {
  std::vector<SheetPicture> pictures = Grays(3);
  for (SheetPicture& picture : pictures) {
    picture.draw = [] {
      return std::vector{Image(4, 3, 3, 80), Image(4, 3, 3, 120), Image(4, 3, 3, 160)};
    };
  }
  const Image page =
      DrawPage(pictures, {.columns = 2, .rows = 2, .tile_width_px = 16, .shows_first = true});
  ASSERT_EQ(page.width(), 2 * (2 * 16 + 4));
  ASSERT_EQ(page.height(), 2 * (12 + 16 + 4));
  EXPECT_EQ(page.At(8, 6, 0), 84) << "the first that it draws";
  EXPECT_EQ(page.At(24, 6, 0), 164) << "and the last";
  EXPECT_EQ(page.At(34, 6, 0), 4) << "a gap";
  EXPECT_EQ(page.At(44, 6, 0), 84);
  EXPECT_EQ(page.At(24, 38, 0), 164);
}

TEST(Choose, TakesASplitAndAClass) {
  std::vector<SheetPicture> pictures = Grays(4);
  pictures[1].split = pictures[2].split = "test";
  pictures[2].row = pictures[3].row = "mug";
  EXPECT_EQ(Choose(pictures, "", "").size(), 4U);
  EXPECT_EQ(Choose(pictures, "test", "").size(), 2U);
  EXPECT_EQ(Choose(pictures, "", "mug").size(), 2U);
  EXPECT_EQ(Choose(pictures, "test", "mug").size(), 1U);
  EXPECT_THROWS_MESSAGE(
      Choose(pictures, "", "cup"), Error, HasSubstr("no class 'cup'; there are: 'gray', 'mug'"));
  EXPECT_THROWS_MESSAGE(
      Choose(pictures, "x", ""), Error, HasSubstr("no split 'x'; there are: '', 'test'"));
}

TEST(DrawPage, NamesWhatIsWrong) {
  EXPECT_THROWS_MESSAGE(DrawPage(Grays(7), {.page = 3, .columns = 2, .rows = 2}),
                        Error,
                        HasSubstr("no page 3; the last is page 2 (7 pictures, 4 a page)"));
  EXPECT_THROWS_MESSAGE(DrawPage(Grays(1), {.page = 2}),
                        Error,
                        HasSubstr("no page 2; the last is page 1 (1 picture, 48 a page)"));
  EXPECT_THROWS_MESSAGE(DrawPage(Grays(1), {.page = 0}), Error, HasSubstr("PageOptions.page is 0"));
  EXPECT_THROWS_MESSAGE(
      DrawPage(Grays(1), {.columns = 101}), Error, HasSubstr("PageOptions.columns is 101"));
  EXPECT_THROWS_MESSAGE(DrawPage(Grays(10000), {.columns = 100, .rows = 100, .tile_width_px = 640}),
                        Error,
                        HasSubstr("a sheet of 64400x50000 pixels is too large"));
}

}  // namespace
}  // namespace handcraft::datasets
