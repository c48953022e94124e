// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/sheet_pictures.h"

#include <limits>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "tests/datasets/small_demonstration_set.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

std::array<int, 3> ColourAt(const Image& image, int u, int v) {
  return {image.At(u, v, 0), image.At(u, v, 1), image.At(u, v, 2)};
}

TEST(SheetPicturesOf, ShowsAPictureAndItsLabels) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  testing::AddPicture(set, "a", Image(4, 3, 1, 100), testing::CountedMask(4, 3, 1, 2), "mine");
  const std::vector<SheetPicture> pictures = SheetPicturesOf(set);
  ASSERT_THAT(pictures, SizeIs(1));
  EXPECT_EQ(pictures[0].row, "object");
  EXPECT_EQ(pictures[0].split, "mine");
  EXPECT_EQ(pictures[0].caption, "a");
  const std::vector<Image> drawn = pictures[0].draw();
  ASSERT_THAT(drawn, SizeIs(2));
  EXPECT_THAT(ColourAt(drawn[0], 0, 0), ElementsAre(100, 100, 100));
  EXPECT_GT(drawn[1].At(0, 0, 1), drawn[1].At(0, 0, 2) + 50) << "good is green";
  EXPECT_THAT(ColourAt(drawn[1], 1, 0), ElementsAre(100, 100, 100)) << "bad is as it was";
}

TEST(SheetPicturesOf, GoesNearToWhatIsGood) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  Image mask(100, 80);
  mask.At(70, 40) = kMaskGood;
  testing::AddPicture(set, "a", testing::NoiseImage(100, 80, 3, 1), mask);
  testing::AddPicture(set, "b", Image(100, 80, 1, 100), Image(100, 80));
  const std::vector<SheetPicture> pictures = SheetPicturesOf(set, Framing::kCloseUp);
  const std::vector<Image> drawn = pictures[0].draw();
  ASSERT_THAT(drawn, SizeIs(3));
  EXPECT_EQ(drawn[0].width(), 100);
  for (const Image& close_up : {drawn[1], drawn[2]}) {
    EXPECT_EQ(close_up.width(), 22);
    EXPECT_EQ(close_up.height(), 17);
  }
  EXPECT_EQ(ColourAt(drawn[1], 10, 8), ColourAt(drawn[0], 70, 40));
  EXPECT_GT(drawn[2].At(10, 8, 1), drawn[1].At(10, 8, 1)) << "good is green";
  EXPECT_EQ(pictures[1].draw()[2].width(), 100) << "nothing is good: all of it";
}

TEST(SheetPicturesOf, GoesNearToTheObjectOfAnObjectMask) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  testing::AddPicture(set, "a", Image(100, 80, 1, 100), Image(100, 80, 1, kMaskGood));
  Image object(100, 80);
  object.At(10, 10) = kObject;
  perception::WritePng(folder / "object.png", object);
  set.items[0].others[std::string(kObjectMask)] = "object.png";
  EXPECT_EQ(SheetPicturesOf(set, Framing::kCloseUp)[0].draw()[2].width(), 22);
  perception::WritePng(folder / "object.png", Image(99, 80));
  EXPECT_THROWS_MESSAGE(
      SheetPicturesOf(set, Framing::kCloseUp)[0].draw(), Error, HasSubstr("object.png"));
  EXPECT_EQ(SheetPicturesOf(set)[0].draw().size(), 2U) << "which is not read without close-ups";
}

TEST(SheetPicturesOf, GoesNearToTheObjectOfAView) {
  const TemporaryDirectory folder;
  testing::MakeDemonstrationSet(folder.path());
  const ViewSet set = ReadViewSet(folder.path());
  const std::vector<Image> whole = SheetPicturesOf(set)[0].draw();
  const std::vector<Image> near = SheetPicturesOf(set, Framing::kCloseUp)[0].draw();
  ASSERT_THAT(near, SizeIs(3));
  EXPECT_EQ(near[0].values(), whole[0].values());
  EXPECT_LT(near[1].width(), whole[1].width());
  EXPECT_EQ(near[1].width(), near[2].width());
}

TEST(SheetPicturesOf, ShowsAViewItsDepthsAndItsObject) {
  const TemporaryDirectory folder;
  testing::MakeDemonstrationSet(folder.path());
  ViewSet set = ReadViewSet(folder.path());
  set.items[1].cloud.clear();
  const std::vector<SheetPicture> pictures = SheetPicturesOf(set);
  ASSERT_THAT(pictures, SizeIs(3));
  EXPECT_EQ(pictures[2].row, "can");
  const std::vector<Image> drawn = pictures[0].draw();
  ASSERT_THAT(drawn, SizeIs(3));
  EXPECT_THAT(ColourAt(drawn[0], 40, 30), ElementsAre(100, 100, 100));
  EXPECT_NE(ColourAt(drawn[1], 0, 0), ColourAt(Image(1, 1, 3), 0, 0)) << "measured";
  EXPECT_GT(drawn[2].At(40, 30, 1), drawn[2].At(40, 30, 2) + 50) << "the object is green";
  EXPECT_EQ(pictures[1].draw()[1].values(), Image(80, 60, 3).values()) << "no cloud: black";
}

TEST(DrawDepths, IsRedNearBlueFarAndBlackWhereNothingIsMeasured) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  OrganisedCloud cloud{.width = 4, .height = 1};
  cloud.base_from_camera.translation() = Eigen::Vector3f(0.0F, 0.0F, -1.0F);
  for (const float z_m : {0.0F, 0.1F, 5.0F, kNone})
    cloud.points.emplace_back(z_m == z_m ? 0.0F : kNone, 0.0F, z_m);
  Image object(4, 1);
  object.At(0, 0) = kObject;
  object.At(1, 0) = kObject;
  const Image drawn = DrawDepths(cloud, object);
  EXPECT_GT(drawn.At(0, 0, 2), drawn.At(0, 0, 0) + 50) << "near: red";
  EXPECT_GT(drawn.At(1, 0, 0), drawn.At(1, 0, 2)) << "far: blue";
  EXPECT_EQ(ColourAt(drawn, 2, 0), ColourAt(drawn, 1, 0)) << "behind the object: as its far end";
  EXPECT_THAT(ColourAt(drawn, 3, 0), ElementsAre(0, 0, 0));
  EXPECT_GT(DrawDepths(cloud, Image(4, 1)).At(0, 0, 2), 100) << "no object: the whole cloud";
}

TEST(DrawDepths, IsBlackForAnEmptyCloud) {
  OrganisedCloud cloud{.width = 2, .height = 1};
  cloud.points.assign(2, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(DrawDepths(cloud, Image(2, 1)).values(), Image(2, 1, 3).values());
  EXPECT_THROW(static_cast<void>(DrawDepths(cloud, Image(3, 1))), std::logic_error);
}

}  // namespace
}  // namespace handcraft::datasets
