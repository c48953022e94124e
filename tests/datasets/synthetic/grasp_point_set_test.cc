// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_point_set.h"

#include <set>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "datasets/labelled_image_faults.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/synthetic/small_camera.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/read_tree.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using handcraft::testing::ReadTree;
using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::SmallCamera;

const PinholeCamera kSmallCamera = SmallCamera();

TEST(MakeGraspPointSet, MakesASoundSet) {
  const TemporaryDirectory folder;
  const MadeImages made = MakeGraspPointSet(
      folder / "set", {.num_images = 3, .camera = kSmallCamera, .num_threads = 2});
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(folder / "set");
  ASSERT_EQ(set.items.size(), 3U);
  EXPECT_THAT(datasets::FindFaults(set), IsEmpty());
  EXPECT_EQ(datasets::Fingerprint(set), datasets::Fingerprint(made.set));
  std::set<std::string> classes;
  for (const datasets::LabelledImage& item : set.items) classes.insert(item.object_class);
  EXPECT_EQ(classes.size(), 3U);
}

TEST(MakeGraspPointSet, LabelsOnlyTheObjectsAndKnowsTheirDepth) {
  const TemporaryDirectory folder;
  const datasets::LabelledImageSet set =
      MakeGraspPointSet(folder / "set", {.num_images = 1, .camera = kSmallCamera}).set;
  const cv::Mat depth =
      cv::imread((folder / "set/depth/cereal_bowl_0000_0.png").string(), cv::IMREAD_UNCHANGED);
  const cv::Mat object = cv::imread((folder / "set/object_masks/cereal_bowl_0000_0.png").string(),
                                    cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_16U);
  ASSERT_EQ(object.type(), CV_8U);
  const Image mask = datasets::ReadMask(set, 0);
  int num_good = 0;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      if (mask.At(u, v) != datasets::kMaskGood) continue;
      ++num_good;
      EXPECT_EQ(object.at<std::uint8_t>(v, u), 255);
      EXPECT_GT(depth.at<std::uint16_t>(v, u), 200) << "millimetres";
      EXPECT_LT(depth.at<std::uint16_t>(v, u), 1500);
    }
  }
  EXPECT_GT(num_good, 20);
}

TEST(MakeGraspPointSet, GivesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  MakeGraspPointSet(folder / "one", {.num_images = 2, .camera = kSmallCamera, .num_threads = 1});
  MakeGraspPointSet(folder / "two", {.num_images = 2, .camera = kSmallCamera, .num_threads = 2});
  EXPECT_TRUE(ReadTree(folder / "one") == ReadTree(folder / "two"));
}

TEST(MakeGraspPointSet, GoesOnWhereItWasStopped) {
  const TemporaryDirectory folder;
  MakeGraspPointSet(folder / "whole", {.num_images = 2, .camera = kSmallCamera});
  const auto whole = ReadTree(folder / "whole");
  // As a kill leaves it: no manifest, one picture of two without its last files, one half-written.
  fs::copy(folder / "whole", folder / "stopped", fs::copy_options::recursive);
  fs::remove(folder / "stopped/manifest.csv");
  fs::remove(folder / "stopped/scenes/eraser_0000_0.toml");
  fs::remove(folder / "stopped/depth/eraser_0000_0.png");
  WriteFileAtomically(folder / "stopped/depth/eraser_0000_0.png.aB3xYz", "half");
  const auto kept = fs::last_write_time(folder / "stopped/images/cereal_bowl_0000_0.png");
  MakeGraspPointSet(folder / "stopped", {.num_images = 2, .camera = kSmallCamera});
  EXPECT_TRUE(ReadTree(folder / "stopped") == whole);
  EXPECT_EQ(fs::last_write_time(folder / "stopped/images/cereal_bowl_0000_0.png"), kept);
}

TEST(MakeGraspPointSet, MakesAPictureAgainOfWhichAnyFileIsNotWhole) {
  const TemporaryDirectory folder;
  const GraspPointSetOptions options{.num_images = 2, .with_right = true, .camera = kSmallCamera};
  EXPECT_EQ(MakeGraspPointSet(folder / "set", options).written.num_pictures, 2U);
  const auto whole = ReadTree(folder / "set");
  const auto repairs = [&](std::size_t num_pictures) {
    const Written written = MakeGraspPointSet(folder / "set", options).written;
    EXPECT_EQ(written.num_pictures, num_pictures);
    EXPECT_EQ(written.num_lists, 0U);
    EXPECT_TRUE(ReadTree(folder / "set") == whole);
  };
  fs::remove(folder / "set/masks/eraser_0000_0.png");
  WriteFileAtomically(folder / "set/object_masks/cereal_bowl_0000_0.png", "");
  repairs(2);
  fs::resize_file(folder / "set/images/eraser_0000_0_right.png", 1000);
  repairs(1);
}

TEST(MakeGraspPointSet, WritesNothingIntoAFinishedSet) {
  const TemporaryDirectory folder;
  const GraspPointSetOptions options{.num_images = 2, .camera = kSmallCamera};
  MadeImages made = MakeGraspPointSet(folder / "set", options);
  EXPECT_EQ(made.written.num_lists, 1U);
  made.set.items[0].split = "held_out";  // as handcraft data split may leave it
  datasets::WriteManifest(made.set);
  const auto whole = ReadTree(folder / "set");
  const MadeImages again = MakeGraspPointSet(folder / "set", options);
  EXPECT_TRUE(again.written.IsNothing());
  EXPECT_EQ(again.set.items, made.set.items) << "its splits are kept";
  EXPECT_TRUE(ReadTree(folder / "set") == whole);
}

TEST(MakeGraspPointSet, RefusesToGoOnWithOtherOptions) {
  const TemporaryDirectory folder;
  MakeGraspPointSet(folder / "set", {.num_images = 1, .camera = kSmallCamera});
  const auto refuses = [&](const GraspPointSetOptions& options) {
    EXPECT_THROWS_MESSAGE(MakeGraspPointSet(folder / "set", options),
                          Error,
                          HasSubstr("tells of a set made with other options"));
  };
  refuses({.num_images = 1, .camera = kSmallCamera, .seed = 2});
  refuses({.num_images = 1});
}

// A catalogue of two meshes: one of a class that is there, one of a new class.
void WriteCatalogue(const fs::path& folder, float height) {
  fs::create_directory(folder);
  WriteFileAtomically(folder / "a.obj",
                      "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv 0 0 " + std::to_string(height) +
                          "\no foot\nf 1 3 2\no rest\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  std::string text;
  for (const std::string name : {"coffee_can", "wedge"}) {
    text += "[[mesh]]\nfile = \"a.obj\"\nclass = \"" + name +
            "\"\nfamily = \"regrasp\"\nlicence = \"MIT\"\ngraspable_names = [\"rest\"]\n";
  }
  WriteFileAtomically(folder / "meshes.toml", text);
}

TEST(MakeGraspPointSet, TakesEveryThirdInstanceFromTheMeshes) {
  const TemporaryDirectory folder;
  WriteCatalogue(folder / "meshes", 0.1F);
  const GraspPointSetOptions options{.family = Family::kRegrasp,
                                     .num_images = 45,
                                     .meshes = folder / "meshes",
                                     .camera = kSmallCamera};
  const datasets::LabelledImageSet set = MakeGraspPointSet(folder / "set", options).set;
  std::map<std::string, std::string> licences;
  std::map<std::string, std::string> splits;
  for (const datasets::LabelledImage& item : set.items) {
    licences[item.instance] = item.licence;
    splits[item.instance] = item.split;
  }
  EXPECT_EQ(licences["coffee_can_0000"], "MIT");
  EXPECT_EQ(licences["coffee_can_0001"], "CC0-1.0");
  EXPECT_EQ(licences["drill_0000"], "CC0-1.0");
  EXPECT_EQ(licences["wedge_0002"], "MIT");
  EXPECT_EQ(splits["coffee_can_0002"], "test");
  EXPECT_EQ(splits["wedge_0002"], "train") << "the same shape as wedge_0000";
  EXPECT_THAT(ReadTextFile(folder / "set/dataset.toml"), HasSubstr("\nmeshes = \""));
  WriteCatalogue(folder / "meshes", 0.12F);
  EXPECT_THROWS_MESSAGE(MakeGraspPointSet(folder / "set", options),
                        Error,
                        HasSubstr("tells of a set made with other options"));
}

TEST(GraspPointSetOptions, RefusesWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(GraspPointSetOptions{.num_images = -1}.Validate(),
                        Error,
                        HasSubstr("GraspPointSetOptions.num_images is -1"));
  EXPECT_THROWS_MESSAGE(GraspPointSetOptions{.baseline_m = 0.0F}.Validate(),
                        Error,
                        HasSubstr("GraspPointSetOptions.baseline_m is 0"));
  EXPECT_THROWS_MESSAGE(GraspPointSetOptions{.camera = {.width_px = 0}}.Validate(),
                        Error,
                        HasSubstr("PinholeCamera.width_px is 0"));
  EXPECT_THROWS_MESSAGE(GraspPointSetOptions{.num_threads = 0}.Validate(),
                        Error,
                        HasSubstr("GraspPointSetOptions.num_threads is 0"));
}

}  // namespace
}  // namespace handcraft::synthetic
