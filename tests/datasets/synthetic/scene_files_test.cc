// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene_files.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/synthetic/small_scene.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/read_tree.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(WriteSceneFiles, WritesWhatThereIsAndTheSceneLast) {
  const TemporaryDirectory folder;
  for (const char* name : {"images", "object_masks", "scenes"}) fs::create_directory(folder / name);
  const SceneFiles files{
      .image = Image(3, 2, 3, 7), .object_mask = Image(3, 2, 1, 255), .scene = "x"};
  EXPECT_FALSE(IsWhole(folder.path(), "mug"));
  WriteSceneFiles(folder.path(), "mug", files);
  EXPECT_TRUE(IsWhole(folder.path(), "mug"));
  EXPECT_EQ(perception::ReadImage(folder / "images/mug.png").values(), files.image.values());
  EXPECT_EQ(perception::ReadImage(folder / "object_masks/mug.png").At(2, 1), 255);
  EXPECT_FALSE(fs::exists(folder / "images/mug_right.png"));
  // sha256 of "images/mug.png \0 … \n object_masks/mug.png \0 … \n x", from the files' own digests.
  std::string parts;
  for (const std::string path : {"images/mug.png", "object_masks/mug.png"}) {
    parts.append(path).push_back('\0');
    parts.append(Sha256Hex(ReadFile(folder / path))).push_back('\n');
  }
  Sha256 digest;
  digest.Update(parts + "x");
  EXPECT_EQ(ReadTextFile(folder / "scenes/mug.toml"),
            "x\n[files]\nsha256 = \"" + digest.HexDigest() + "\"\n");
}

// A scene of every kind of file, in folders of its own.
class WholeScene : public ::testing::Test {
 protected:
  WholeScene() {
    for (const char* name : {"images", "masks", "object_masks", "clouds", "depth", "scenes"}) {
      fs::create_directory(folder_ / name);
    }
    files_ = {.image = Image(3, 2, 3, 7),
              .right_image = Image(3, 2, 3, 8),
              .mask = Image(3, 2, 1, 128),
              .object_mask = Image(3, 2, 1, 255),
              .cloud = {.width = 1, .height = 1, .points = {Eigen::Vector3f::Ones()}},
              .depth = FloatImage(3, 2),
              .scene = "class = \"mug\"\n\n[[objects]]\n"};
  }

  TemporaryDirectory folder_;
  SceneFiles files_;
};

TEST_F(WholeScene, IsMadeOnce) {
  int num_made = 0;
  const auto make = [&] {
    ++num_made;
    return files_;
  };
  EXPECT_TRUE(WriteUnlessWhole(folder_.path(), "mug", make));
  EXPECT_FALSE(WriteUnlessWhole(folder_.path(), "mug", make));
  EXPECT_EQ(num_made, 1);
}

TEST_F(WholeScene, IsWholeNoMoreWhenAnyFileIsGoneOrEmptyOrCutOrChanged) {
  WriteSceneFiles(folder_.path(), "mug", files_);
  const auto whole = handcraft::testing::ReadTree(folder_.path());
  ASSERT_EQ(whole.size(), 7U);
  for (const auto& file : whole) {
    const fs::path path = folder_ / file.first;
    const std::vector<std::uint8_t>& bytes = file.second;
    fs::remove(path);
    EXPECT_FALSE(IsWhole(folder_.path(), "mug")) << file.first << " is gone";
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, bytes.size() - 1}) {
      WriteFileAtomically(path, std::span(bytes).first(size));
      EXPECT_FALSE(IsWhole(folder_.path(), "mug")) << file.first << " is cut to " << size;
    }
    std::vector<std::uint8_t> changed = bytes;
    changed[bytes.size() / 2] ^= 1U;
    WriteFileAtomically(path, changed);
    EXPECT_FALSE(IsWhole(folder_.path(), "mug")) << file.first << " is changed";
    WriteFileAtomically(path, bytes);
    EXPECT_TRUE(IsWhole(folder_.path(), "mug"));
  }
}

TEST_F(WholeScene, IsMadeAgainWhereALinkLeadsRoundInACircle) {
  WriteSceneFiles(folder_.path(), "mug", files_);
  const auto whole = handcraft::testing::ReadTree(folder_.path());
  for (const auto& file : whole) {
    const fs::path path = folder_ / file.first;
    fs::remove(path);
    fs::create_symlink(path.filename(), path);
    EXPECT_FALSE(IsWhole(folder_.path(), "mug")) << file.first;
    WriteSceneFiles(folder_.path(), "mug", files_);
    EXPECT_FALSE(fs::is_symlink(path));
    EXPECT_EQ(handcraft::testing::ReadTree(folder_.path()), whole);
  }
}

TEST_F(WholeScene, IsNotThatOfAnOlderVersionWithoutADigest) {
  WriteSceneFiles(folder_.path(), "mug", files_);
  WriteFileAtomically(folder_ / "scenes/mug.toml", files_.scene);
  EXPECT_FALSE(IsWhole(folder_.path(), "mug"));
}

TEST(CountWritten, CountsWhatWasWritten) {
  for (const int num_threads : {1, 3}) {
    EXPECT_EQ(CountWritten(10, num_threads, {}, "", [](std::size_t i) { return i % 3 == 0; }), 4U);
  }
}

TEST(WriteSceneFiles, LeavesASceneUnwrittenWhenAPictureCannotBe) {
  const TemporaryDirectory folder;
  fs::create_directory(folder / "scenes");
  EXPECT_THROWS_MESSAGE(
      WriteSceneFiles(folder.path(), "mug", {.image = Image(3, 2, 3), .scene = "x"}),
      Error,
      HasSubstr("images"));
  EXPECT_FALSE(IsWhole(folder.path(), "mug"));
}

TEST(WriteSceneFiles, WritesDepthInMillimetres) {
  const TemporaryDirectory folder;
  fs::create_directory(folder / "depth");
  fs::create_directory(folder / "scenes");
  FloatImage depth(4, 1);
  depth.At(1, 0) = 0.6124F;
  depth.At(2, 0) = 0.6126F;
  depth.At(3, 0) = 70.0F;
  WriteSceneFiles(folder.path(), "mug", {.depth = depth, .scene = "x"});
  const cv::Mat read = cv::imread((folder / "depth/mug.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.type(), CV_16U);
  EXPECT_EQ(read.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(read.at<std::uint16_t>(0, 1), 612);
  EXPECT_EQ(read.at<std::uint16_t>(0, 2), 613);
  EXPECT_EQ(read.at<std::uint16_t>(0, 3), 65535) << "as far as 16 bits go";
}

TEST(PoseToToml, WritesPositionAndQuaternionByHand) {
  const Eigen::Isometry3f pose = Eigen::Translation3f(0.5F, 0.0F, -0.25F) *
                                 Eigen::Isometry3f(Eigen::Quaternionf(
                                     0.0F, 0.0F, 0.0F, 1.0F));  // w x y z: half a turn about z
  EXPECT_EQ(PoseToToml("base_from_camera", pose),
            "base_from_camera_position_m = [0.5, 0, -0.25]\n"
            "base_from_camera_quaternion_xyzw = [0, 0, 1, 0]\n");
}

TEST(CameraToToml, WritesFloatsThatReadBackTheSame) {
  const PinholeCamera camera{.focal_px = 525.3712F};
  EXPECT_EQ(CameraToToml(camera, std::nullopt),
            "\n[camera]\nwidth_px = 640\nheight_px = 480\nfocal_px = 525.3712\n"
            "centre_u_px = 319.5\ncentre_v_px = 239.5\n\n[depth]\nunit_m = 0.001\n");
  EXPECT_THAT(CameraToToml({}, 0.12F), HasSubstr("focal_px = 525.0\n"));
  EXPECT_THAT(CameraToToml({}, 0.12F), HasSubstr("baseline_m = 0.12\n"));
}

TEST(SceneToToml, TellsTheTargetsAlone) {
  const Scene scene = testing::SmallScene();
  const std::string text = SceneToToml("box", 3, scene);
  EXPECT_THAT(text, StartsWith("class = \"box\"\ninstance = 3\n\n[camera]\nbase_from_camera_pos"));
  std::size_t count = 0;
  for (std::size_t at = text.find("[[objects]]"); at != std::string::npos;
       at = text.find("[[objects]]", at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, 1U) << "the slab is no target";
}

}  // namespace
}  // namespace handcraft::synthetic
