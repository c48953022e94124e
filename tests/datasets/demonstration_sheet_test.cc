// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/demonstration_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_demonstration_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using testing::FromAbove;
using ::testing::HasSubstr;
using testing::Reaching;
using testing::TemporaryDirectory;

// Pixels of the stem's colour, which lines of one pixel blend with what lies below.
int NumYellow(const Image& image) {
  int count = 0;
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      count += std::min(image.At(u, v, 1), image.At(u, v, 2)) > image.At(u, v, 0) + 40 ? 1 : 0;
    }
  }
  return count;
}

TEST(DrawHands, PutsFingersAndThumbOnTheirSides) {
  Image picture(80, 60, 3);
  EndEffectorPose pose = Reaching({0.0, 0.0, 0.1});
  pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitY()));
  // z of the hand now points to +x of the base (up in the picture), x of the hand down to the
  // table.
  DrawHands(picture, FromAbove(), std::array{pose});
  EXPECT_GT(NumYellow(picture), 5) << "the stem, along the approach axis";
  Image sideways(80, 60, 3);
  pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitX()));
  // z of the hand points to −y (right in the picture), x of the hand to +x (up).
  DrawHands(sideways, FromAbove(), std::array{pose});
  const auto centre = FromAbove().Project({0.0F, 0.0F, 0.1F});
  const int u = static_cast<int>(std::lround(centre.x())) - 5;  // between palm and grasp centre
  const auto channel_at = [&](float x_m, int channel) {
    const int v = static_cast<int>(std::lround(FromAbove().Project({x_m, 0.0F, 0.1F}).y()));
    return static_cast<int>(sideways.At(u, v, channel));
  };
  EXPECT_GT(channel_at(0.02F, 2), channel_at(0.02F, 0)) << "the fingers' prong is orange";
  EXPECT_GT(channel_at(-0.02F, 0), channel_at(-0.02F, 2)) << "the thumb's is blue";
}

TEST(DrawHands, LeavesOutWhatIsBehindTheCamera) {
  Image picture(80, 60, 3);
  DrawHands(picture, FromAbove(), std::array{Reaching({0.0, 0.0, 0.6})});
  EXPECT_EQ(picture.values(), Image(80, 60, 3).values());
  DrawHands(picture, FromAbove(), {});
  EXPECT_EQ(picture.values(), Image(80, 60, 3).values());
  DrawHands(picture, FromAbove(), std::array{Reaching({50.0, 50.0, 0.1})});
  EXPECT_EQ(picture.values(), Image(80, 60, 3).values()) << "far outside the picture";
}

// On white a yellow line can hardly be seen without its rim.
TEST(DrawHands, GivesWideLinesABlackRim) {
  const EndEffectorPose pose = Reaching({0.0, 0.0, 0.1});
  const auto darkest = [&](int width_px) {
    Image picture(80, 60, 3, 255);
    DrawHands(picture, FromAbove(), std::array{pose}, Hand::kRight, width_px);
    int least = 255;
    for (int v = 0; v < picture.height(); ++v) {
      for (int u = 0; u < picture.width(); ++u) {
        least = std::min<int>(
            least, std::max({picture.At(u, v, 0), picture.At(u, v, 1), picture.At(u, v, 2)}));
      }
    }
    return least;
  };
  EXPECT_GT(darkest(1), 100);
  EXPECT_LT(darkest(3), 20);
}

TEST(PartAbout, SeesTheSamePointsLarger) {
  Image picture(80, 60);
  picture.At(55, 25) = 255;
  const PicturePart part =
      PartAbout(picture, {.u_px = 50, .v_px = 20, .width = 10, .height = 10}, FromAbove(), 260);
  EXPECT_EQ(part.picture.channels(), 3);
  EXPECT_EQ(part.picture.width(), 260);
  EXPECT_EQ(part.picture.height(), 195);
  // The white pixel, where the point that it shows is seen now.
  const Eigen::Vector2f before = {55.0F, 25.0F};
  const Eigen::Vector3f ray((before.x() - FromAbove().centre_u_px) / FromAbove().focal_px,
                            (before.y() - FromAbove().centre_v_px) / FromAbove().focal_px,
                            1.0F);
  const Eigen::Vector2f after = part.camera.Project(FromAbove().base_from_camera * ray);
  const int u = static_cast<int>(std::lround(after.x()));
  const int v = static_cast<int>(std::lround(after.y()));
  EXPECT_GT(part.picture.At(u, v), 150);
  EXPECT_LT(part.picture.At(u + 20, v), 50);
}

class SheetOfThreeViews : public ::testing::Test {
 protected:
  TemporaryDirectory folder_;
  DemonstrationSet poses_ = testing::MakeDemonstrationSet(folder_.path());
  ViewSet views_ = ReadViewSet(folder_.path());
};

TEST_F(SheetOfThreeViews, HasAHandInEachViewWithPoses) {
  views_.items.push_back(views_.items[0]);
  views_.items.back().image = "without_poses.png";
  const std::vector<SheetPicture> pictures = SheetPicturesOf(poses_, views_, {.tile_width_px = 64});
  ASSERT_EQ(pictures.size(), 3U);
  EXPECT_EQ(pictures[0].row, "mug");
  EXPECT_EQ(pictures[0].caption, "mug_0");
  EXPECT_EQ(pictures[2].row, "can");
  for (const SheetPicture& picture : pictures) {
    const std::vector<Image> drawn = picture.draw();
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0].width(), 64);
    EXPECT_EQ(drawn[0].height(), 48);
    EXPECT_GT(NumYellow(drawn[0]), 3) << picture.caption;
  }
}

// Violet, the left hand's, has little green in it.
int NumViolet(const Image& image) {
  int count = 0;
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      count += std::min(image.At(u, v, 0), image.At(u, v, 2)) > image.At(u, v, 1) + 40 ? 1 : 0;
    }
  }
  return count;
}

TEST_F(SheetOfThreeViews, HasBothHandsOfEachHold) {
  const HoldSet holds{.root = folder_.path(),
                      .items = {{.object_class = "mug",
                                 .instance = "mug",
                                 .view = "mug_1.png",
                                 .right = Reaching({0.03, 0.0, 0.1}),
                                 .left = Reaching({-0.03, 0.0, 0.1})}}};
  const std::vector<SheetPicture> pictures = SheetPicturesOf(holds, views_, {});
  ASSERT_EQ(pictures.size(), 1U);
  EXPECT_EQ(pictures[0].caption, "mug_1");
  const Image drawn = pictures[0].draw().at(0);
  EXPECT_GT(NumYellow(drawn), 3) << "the right hand";
  EXPECT_GT(NumViolet(drawn), 3) << "the left hand";
  EXPECT_EQ(NumViolet(SheetPicturesOf(poses_, views_, {})[1].draw().at(0)), 0);
}

TEST_F(SheetOfThreeViews, NamesTheViewThatCannotBeDrawn) {
  const auto draw = [&] {
    for (const SheetPicture& picture : SheetPicturesOf(poses_, views_, {})) picture.draw();
  };
  views_.items[2].cloud.clear();
  EXPECT_THROWS_MESSAGE(draw(), Error, HasSubstr("can_0.png: the view has no cloud"));
  views_.items[2].cloud = "can_0.pcd";
  perception::WritePng(folder_ / "can_0_mask.png", Image(80, 60));
  EXPECT_THROWS_MESSAGE(draw(), Error, HasSubstr("can_0_mask.png: the mask shows no object"));
  WritePcd(folder_ / "can_0.pcd",
           {.width = 80,
            .height = 60,
            .points = std::vector<Eigen::Vector3f>(80 * 60, Eigen::Vector3f::Zero())});
  EXPECT_THROWS_MESSAGE(draw(), Error, HasSubstr("can_0.pcd: the cloud has 0 points in front"));
}

TEST(DemonstrationSheetOptions, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(DemonstrationSheetOptions{.poses_per_view = 0}.Validate(),
                        Error,
                        HasSubstr("poses_per_view"));
  EXPECT_THROWS_MESSAGE(DemonstrationSheetOptions{.tile_width_px = 8}.Validate(),
                        Error,
                        HasSubstr("tile_width_px is 8; it must be from 16 to 640"));
}

}  // namespace
}  // namespace handcraft::datasets
