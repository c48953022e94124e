// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/view_set_faults.h"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "lib/core/file.h"
#include "tests/datasets/small_scene_file.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MakeViewSet;
using testing::TemporaryDirectory;

TEST(ViewSetFaults, NameEveryFile) {
  const TemporaryDirectory folder;
  ViewSet set = MakeViewSet(folder.path());
  EXPECT_THAT(FindFaults(set), IsEmpty());
  const auto expect_fault = [&](const std::string& path, const std::string& reason) {
    EXPECT_THAT(
        FindFaults(set),
        ElementsAre(AllOf(Field(&Fault::path, path), Field(&Fault::reason, HasSubstr(reason)))));
  };
  WritePcd(folder / "a.pcd", testing::FlatCloud(6, 8));
  expect_fault("a.pcd", "the cloud is 6x8 pixels, its picture 8x6");
  OrganisedCloud blind = testing::FlatCloud(8, 6);
  for (Eigen::Vector3f& point : blind.points) {
    if (point.x() < 0.035F) point.setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  WritePcd(folder / "a.pcd", blind);
  expect_fault("a.pcd", "no point of the object was measured");
  fs::remove(folder / "a.pcd");
  expect_fault("a.pcd", "No such file");
  set.items[0].cloud.clear();
  perception::WritePng(folder / "a_mask.png", Image(8, 6));
  expect_fault("a_mask.png", "no pixel of an object");
  perception::WritePng(folder / "a_mask.png", Image(8, 6, 1, 128));
  expect_fault("a_mask.png", "value 128 at column 0, row 0; 255 (object) or 0");
  perception::WritePng(folder / "a_mask.png", testing::HalfMask(8, 5));
  expect_fault("a_mask.png", "the mask is 8x5 pixels, its picture 8x6");
  perception::WritePng(folder / "a_mask.png", testing::HalfMask(8, 6));
  fs::copy_file(folder / "a.png", folder / "c.png", fs::copy_options::overwrite_existing);
  expect_fault("c.png", "the same picture as a.png, which is in another split");
}

TEST(ViewSetFaults, NameDepthAndScene) {
  const TemporaryDirectory folder;
  ViewSet set = MakeViewSet(folder.path());
  perception::WritePng16(folder / "depth.png", BasicImage<std::uint16_t>(8, 6));
  WriteFileAtomically(folder / "scene.toml", testing::kSmallSceneFile);
  set.items[0].depth = "depth.png";
  set.items[0].scene = "scene.toml";
  EXPECT_THAT(FindFaults(set), IsEmpty());
  fs::resize_file(folder / "depth.png", 40);
  WriteFileAtomically(folder / "scene.toml", "x");
  EXPECT_THAT(FindFaults(set),
              ElementsAre(Field(&Fault::path, "depth.png"),
                          AllOf(Field(&Fault::path, HasSubstr("scene.toml")),
                                Field(&Fault::reason, HasSubstr("not TOML")))));
  fs::remove(folder / "depth.png");
  fs::remove(folder / "scene.toml");
  EXPECT_THAT(FindFaults(set),
              ElementsAre(Field(&Fault::path, "depth.png"), Field(&Fault::path, "scene.toml")));
}

TEST(ViewSetFaults, AreTheSameForAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  ViewSet set = MakeViewSet(folder.path());
  for (int i = 0; i < 12; ++i) {  // every third is there already, every fourth is not there
    ObjectView view = set.items[static_cast<std::size_t>(i % 3)];
    if (i % 4 == 0) view.image = "gone" + std::to_string(i) + ".png";
    set.items.push_back(view);
  }
  const auto text = [&](int num_threads) {
    std::string lines;
    for (const Fault& fault : FindFaults(set, num_threads))
      lines += fault.path + ": " + fault.reason + "\n";
    return lines;
  };
  const std::string one = text(1);
  EXPECT_THAT(one, HasSubstr("gone8.png: "));
  EXPECT_LT(one.find("gone4.png"), one.find("gone8.png")) << "in the order of views.csv";
  EXPECT_EQ(text(4), one);
}

}  // namespace
}  // namespace handcraft::datasets
