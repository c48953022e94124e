// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/set_lists.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "datasets/formats/listing_rules.h"
#include "lib/core/file.h"
#include "tests/datasets/small_image_set.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

using handcraft::testing::TemporaryDirectory;

template <class Set>
std::size_t NumWritten(Set set) {
  Written written;
  WriteList(set, written);
  return written.num_lists;
}

TEST(WriteList, WritesAManifestOnceAndKeepsSplits) {
  const TemporaryDirectory folder;
  const datasets::LabelledImageSet made = handcraft::testing::MakeSet(folder.path());
  EXPECT_EQ(NumWritten(made), 1U);
  EXPECT_EQ(NumWritten(made), 0U);
  datasets::LabelledImageSet divided = made;
  divided.items[1].split = "test";
  datasets::WriteManifest(divided);
  datasets::LabelledImageSet set = made;
  Written written;
  WriteList(set, written);
  EXPECT_TRUE(written.IsNothing());
  EXPECT_EQ(set.items, divided.items);
}

TEST(WriteList, KeepsAManifestThatPeopleHaveEdited) {
  const TemporaryDirectory folder;
  const datasets::LabelledImageSet made = handcraft::testing::MakeSet(folder.path());
  datasets::LabelledImageSet edited = made;
  edited.items[0].object_class = "cup";
  edited.items[0].others["rating"] = "5";
  std::swap(edited.items[0], edited.items[1]);
  datasets::WriteManifest(edited);
  const std::string text = ReadTextFile(folder / datasets::kManifestFileName);
  datasets::LabelledImageSet set = made;
  Written written;
  WriteList(set, written);
  EXPECT_TRUE(written.IsNothing());
  EXPECT_EQ(set.items, edited.items);
  EXPECT_EQ(ReadTextFile(folder / datasets::kManifestFileName), text);
}

TEST(WriteList, ReplacesAManifestThatIsNotOfThisSet) {
  const TemporaryDirectory folder;
  const datasets::LabelledImageSet made = handcraft::testing::MakeSet(folder.path());
  const auto path = folder / datasets::kManifestFileName;
  WriteManifest(made);
  const std::string whole = ReadTextFile(path);
  datasets::LabelledImageSet shorter = made;
  shorter.items.pop_back();
  datasets::LabelledImageSet renamed = made;
  renamed.items[0].mask = "b_mask.png";
  for (const auto& other : {shorter, renamed}) {
    datasets::WriteManifest(other);
    EXPECT_EQ(NumWritten(made), 1U);
    EXPECT_EQ(ReadTextFile(path), whole);
  }
  for (const std::string& damaged : {std::string(), whole.substr(0, whole.size() / 2)}) {
    WriteFileAtomically(path, damaged);
    EXPECT_EQ(NumWritten(made), 1U);
    EXPECT_EQ(ReadTextFile(path), whole);
  }
}

TEST(WriteList, WritesViewsOnceAndKeepsSplits) {
  const TemporaryDirectory folder;
  datasets::ViewSet made = handcraft::testing::MakeViewSet(folder.path());
  EXPECT_EQ(NumWritten(made), 1U);
  EXPECT_EQ(NumWritten(made), 0U);
  datasets::ViewSet divided = made;
  divided.items[2].split = "train";
  datasets::WriteViews(divided);
  EXPECT_EQ(NumWritten(made), 0U);
  made.items[0].angle_deg = 1.0;
  EXPECT_EQ(NumWritten(made), 1U);
}

TEST(WriteList, WritesPosesAndHoldsOnceInWhateverOrder) {
  const TemporaryDirectory folder;
  const datasets::ViewSet views = handcraft::testing::MakeViewSet(folder.path());
  datasets::WriteViews(views);
  const datasets::ObjectView& view = views.items[0];
  datasets::DemonstrationSet poses{.root = folder.path(), .items = {}};
  datasets::HoldSet holds{.root = folder.path(), .items = {}};
  for (const double x_m : {0.1, 0.2}) {
    datasets::EndEffectorPose pose;
    pose.position_m.x() = x_m;
    poses.items.push_back({view.object_class, view.instance, view.image, view.angle_deg, pose});
    holds.items.push_back({view.object_class, view.instance, view.image, pose, pose});
  }
  const auto expect_writes = [&](std::size_t count) {
    EXPECT_EQ(NumWritten(poses), count);
    EXPECT_EQ(NumWritten(holds), count);
  };
  expect_writes(1);
  std::swap(poses.items[0], poses.items[1]);
  std::swap(holds.items[0], holds.items[1]);
  expect_writes(0);
  poses.items[0].pose.position_m.y() = 0.3;
  holds.items[0].left.position_m.y() = 0.3;
  expect_writes(1);
  for (const char* name : {"demonstrations.csv", "holds.csv"}) {
    std::filesystem::resize_file(folder / name, 100);
  }
  expect_writes(1);
}

}  // namespace
}  // namespace handcraft::synthetic
