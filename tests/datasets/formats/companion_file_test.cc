// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/companion_file.h"

#include <cstdint>
#include <stdexcept>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_scene_file.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr PixelSize kSize = {8, 6};

class CheckCompanionTest : public ::testing::Test {
 protected:
  CheckCompanionTest() {
    perception::WritePng(folder_ / "mask.png", testing::HalfMask(8, 6));
    perception::WritePng16(folder_ / "depth.png", BasicImage<std::uint16_t>(8, 6));
    WritePcd(folder_ / "cloud.pcd", testing::FlatCloud(8, 6));
    WriteFileAtomically(folder_ / "scene.toml", testing::kSmallSceneFile);
  }

  void Refuses(std::string_view column, const std::string& name, const std::string& message) const {
    EXPECT_THROWS_MESSAGE(
        (CheckCompanion(column, folder_ / name, kSize), 0), Error, HasSubstr(name + message));
  }

  TemporaryDirectory folder_;
};

TEST_F(CheckCompanionTest, PassesWhatFits) {
  CheckCompanion(kObjectMask, folder_ / "mask.png", kSize);
  CheckCompanion(kDepth, folder_ / "depth.png", kSize);
  CheckCompanion(kCloud, folder_ / "cloud.pcd", kSize);
  CheckCompanion(kScene, folder_ / "scene.toml", kSize);
  CheckCompanion(kRightImage, folder_ / "mask.png", kSize);
}

TEST_F(CheckCompanionTest, RefusesOtherSizes) {
  perception::WritePng(folder_ / "mask.png", testing::HalfMask(4, 6));
  perception::WritePng16(folder_ / "depth.png", BasicImage<std::uint16_t>(8, 5));
  WritePcd(folder_ / "cloud.pcd", testing::FlatCloud(6, 8));
  Refuses(kObjectMask, "mask.png", ": the object_mask is 4x6 pixels, its picture 8x6");
  Refuses(kDepth, "depth.png", ": the depth is 8x5 pixels, its picture 8x6");
  Refuses(kCloud, "cloud.pcd", ": the cloud is 6x8 pixels, its picture 8x6");
  Refuses(kRightImage, "mask.png", ": the right_image is 4x6 pixels, its picture 8x6");
}

TEST_F(CheckCompanionTest, RefusesWhatIsNotOfItsKind) {
  Refuses(kDepth, "mask.png", " at byte 24: a PNG of 8 bits a channel; 16 bits are due");
  WriteFileAtomically(folder_ / "scene.toml", "class = 1\nx\n");
  Refuses(kScene, "scene.toml", ":2: not TOML: ");
  WriteFileAtomically(folder_ / "scene.toml", "");
  Refuses(kScene, "scene.toml", ": the file is empty");
  WriteFileAtomically(folder_ / "cloud.pcd", "");
  Refuses(kCloud, "cloud.pcd", ":1: the PCD header ends before a line DATA");
  Refuses(kScene, "gone.toml", ": cannot open: No such file");
}

TEST_F(CheckCompanionTest, KnowsNoOtherColumn) {
  EXPECT_THROW(CheckCompanion("mask", folder_ / "mask.png", kSize), std::logic_error);
}

}  // namespace
}  // namespace handcraft::datasets
