// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/labelled_image_faults.h"

#include <map>
#include <string>

#include <gmock/gmock.h>

#include "lib/core/file.h"
#include "tests/datasets/small_image_set.h"
#include "tests/datasets/small_scene_file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using testing::AddPicture;
using ::testing::AllOf;
using testing::CountedMask;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::NoiseImage;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

// Two sound pictures in "train", one in "test".
LabelledImageSet MakeSet(const std::filesystem::path& root) {
  LabelledImageSet set{.root = root, .items = {}};
  AddPicture(set, "a", NoiseImage(8, 6, 3, 1), CountedMask(8, 6, 5, 7));
  AddPicture(set, "b", NoiseImage(8, 6, 1, 2), CountedMask(8, 6, 1, 1));
  AddPicture(set, "c", NoiseImage(4, 4, 3, 3), CountedMask(4, 4, 2, 2), "test");
  return set;
}

std::map<std::string, std::string> ReasonsByPath(const LabelledImageSet& set) {
  std::map<std::string, std::string> reasons;
  for (const Fault& fault : FindFaults(set, 2)) reasons[fault.path] += fault.reason + ";";
  return reasons;
}

TEST(FindFaults, FindsNothingInASoundSet) {
  const TemporaryDirectory folder;
  EXPECT_THAT(FindFaults(MakeSet(folder.path())), IsEmpty());
}

TEST(FindFaults, FindsEveryFaultAndItsFile) {
  const TemporaryDirectory folder;
  LabelledImageSet set = MakeSet(folder.path());
  AddPicture(set, "mis_sized", NoiseImage(4, 4, 1, 11), CountedMask(4, 5, 1, 1));
  AddPicture(set, "missing", NoiseImage(4, 4, 1, 12), CountedMask(4, 4, 1, 1));
  AddPicture(set, "twin", NoiseImage(4, 4, 3, 3), CountedMask(4, 4, 1, 1));  // as c.png
  std::filesystem::remove(folder / "missing.png");
  std::map<std::string, std::string> reasons = ReasonsByPath(set);
  EXPECT_THAT(reasons, SizeIs(3));
  EXPECT_THAT(reasons["mis_sized_mask.png"], HasSubstr("4x5"));
  EXPECT_THAT(reasons["missing.png"], HasSubstr("No such file"));
  EXPECT_THAT(reasons["twin.png"], HasSubstr("same picture as c.png, which is in another split"));
}

TEST(FindFaults, NotesMasksOfOneKindAlone) {
  const TemporaryDirectory folder;
  LabelledImageSet set = MakeSet(folder.path());
  AddPicture(set, "no_label", NoiseImage(4, 4, 1, 9), CountedMask(4, 4, 0, 0));
  AddPicture(set, "no_bad", NoiseImage(4, 4, 1, 10), CountedMask(4, 4, 16, 0));
  AddPicture(set, "no_good", NoiseImage(4, 4, 1, 11), CountedMask(4, 4, 0, 16));
  std::map<std::string, std::string> reasons = ReasonsByPath(set);
  EXPECT_THAT(reasons, SizeIs(3));
  EXPECT_THAT(reasons["no_label_mask.png"], AllOf(HasSubstr("no good"), HasSubstr("no bad")));
  EXPECT_EQ(reasons["no_bad_mask.png"],
            "no bad pixel (0): training draws nothing from the picture;");
  EXPECT_EQ(reasons["no_good_mask.png"],
            "no good pixel (255): training draws nothing from the picture;");
  for (const Fault& fault : FindFaults(set)) EXPECT_EQ(fault.gravity, Gravity::kNote);
}

TEST(FindFaults, LooksAtCompanions) {
  const TemporaryDirectory folder;
  LabelledImageSet set = MakeSet(folder.path());
  perception::WritePng(folder / "object.png", Image(8, 6, 1, 255));
  perception::WritePng16(folder / "depth.png", BasicImage<std::uint16_t>(8, 6));
  WriteFileAtomically(folder / "scene.toml", testing::kSmallSceneFile);
  set.items[0].others = {
      {"object_mask", "object.png"}, {"depth", "depth.png"}, {"scene", "scene.toml"}};
  EXPECT_THAT(FindFaults(set), IsEmpty());

  Image gray(8, 6);
  gray.At(2, 3) = 7;
  perception::WritePng(folder / "gray.png", gray);
  WriteFileAtomically(folder / "cloud.pcd", "");
  set.items[0].others = {{"object_mask", "gray.png"},
                         {"depth", "object.png"},
                         {"cloud", "cloud.pcd"},
                         {"scene", "gone.toml"},
                         {"right_image", "c.png"}};
  std::map<std::string, std::string> reasons = ReasonsByPath(set);
  EXPECT_THAT(reasons, SizeIs(5));
  EXPECT_THAT(reasons["gray.png"], HasSubstr("value 7 at column 2, row 3; 255 (object) or 0"));
  EXPECT_THAT(reasons["object.png"], HasSubstr("8 bits a channel; 16 bits are due"));
  EXPECT_THAT(reasons["cloud.pcd"], HasSubstr("ends before a line DATA"));
  EXPECT_THAT(reasons["gone.toml"], HasSubstr("No such file"));
  EXPECT_THAT(reasons["c.png"], HasSubstr("4x4 pixels, its picture 8x6"));
}

}  // namespace
}  // namespace handcraft::datasets
