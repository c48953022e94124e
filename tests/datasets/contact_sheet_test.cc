// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/contact_sheet.h"

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

TEST(MakeContactSheet, HasARowAClassAndEachPictureTwice) {
  const TemporaryDirectory folder;
  const Image sheet =
      MakeContactSheet(TwoClasses(folder.path()), {.images_per_class = 3, .tile_width_px = 40});
  ASSERT_EQ(sheet.width(), 2 * 3 * 40);
  ASSERT_EQ(sheet.height(), 2 * 30);
  EXPECT_EQ(sheet.At(20, 15, 0), 100) << "96 ... 103 become 100";
  EXPECT_EQ(sheet.At(60, 15, 1), 100) << "no label, no colour";
  EXPECT_EQ(sheet.At(20, 45, 1), 204) << "the second class, 200 ... 207";
  EXPECT_GT(sheet.At(60, 45, 1), sheet.At(60, 45, 2) + 50) << "good is green";
  EXPECT_EQ(sheet.At(20, 32, 1), 4) << "above a wide picture it is black";
  EXPECT_EQ(sheet.At(100, 45, 1), 4) << "there is one wide picture";
}

TEST(MakeContactSheet, GivesTheSameAgain) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = testing::MakeSet(folder.path());
  EXPECT_EQ(MakeContactSheet(set, {}).values(), MakeContactSheet(set, {}).values());
}

TEST(MakeContactSheet, NamesWhatIsWrong) {
  const TemporaryDirectory folder;
  LabelledImageSet set = TwoClasses(folder.path());
  EXPECT_THROWS_MESSAGE(MakeContactSheet({.root = "here", .items = {}}, {}),
                        Error,
                        HasSubstr("here: the set has no pictures"));
  set.items[0].image = "gone.png";
  EXPECT_THROWS_MESSAGE(MakeContactSheet(set, {}), Error, HasSubstr("gone.png"));
  EXPECT_THROWS_MESSAGE(MakeContactSheet(set, {.images_per_class = 0}),
                        Error,
                        HasSubstr("ContactSheetOptions.images_per_class is 0"));
  EXPECT_THROWS_MESSAGE(MakeContactSheet(set, {.tile_width_px = 5}),
                        Error,
                        HasSubstr("ContactSheetOptions.tile_width_px is 5"));
}

}  // namespace
}  // namespace handcraft::datasets
