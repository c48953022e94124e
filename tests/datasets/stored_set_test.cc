// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/stored_set.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/small_demonstration_set.h"
#include "tests/datasets/small_image_set.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

constexpr const char* kManifest =
    "split,note,image,mask,class,instance,licence\n"
    "old,\"a, b\",i.png,m.png,mug,1,\n"
    "old,,j.png,n.png,mug,2,MIT\n";
constexpr const char* kHold =
    "class,instance,view,frame,end_effector,"
    "right_x_m,right_y_m,right_z_m,right_qx,right_qy,right_qz,right_qw,"
    "left_x_m,left_y_m,left_z_m,left_qx,left_qy,left_qz,left_qw\n"
    "mug,mug,mug_0.png,base,grasp_centre,0,0,0,0,0,0,1,0,0,0,0,0,0,2\n";

TEST(OpenSet, TheShippedViewsAreWhole) {
  const std::filesystem::path root = HANDCRAFT_SOURCE_DIR "/datasets/samples/turntable_mini";
  const StoredSet set = OpenSet(root);
  EXPECT_THAT(std::get<ViewSet>(set.pictures).items, SizeIs(12));
  EXPECT_TRUE(set.has_demonstrations);
  const CheckedSet checked = CheckSet(set);
  EXPECT_THAT(checked.faults, IsEmpty());
  EXPECT_EQ(checked.num_demonstrations, 120U);
  std::uintmax_t num_bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) num_bytes += entry.file_size();
  }
  EXPECT_LT(num_bytes, 300000U);
}

TEST(OpenSet, KnowsAllKinds) {
  const TemporaryDirectory labelled;
  WriteFileAtomically(labelled / "manifest.csv", kManifest);
  const StoredSet images = OpenSet(labelled.path());
  EXPECT_THAT(std::get<LabelledImageSet>(images.pictures).items, SizeIs(2));
  EXPECT_EQ(images.root(), labelled.path());
  EXPECT_EQ(images.list(), labelled / "manifest.csv");
  EXPECT_FALSE(images.has_demonstrations || images.has_holds);

  const TemporaryDirectory seen;
  WriteViews(testing::MakeViewSet(seen.path()));
  const StoredSet views = OpenSet(seen.path());
  EXPECT_THAT(std::get<ViewSet>(views.pictures).items, SizeIs(3));
  EXPECT_EQ(views.list(), seen / "views.csv");
  EXPECT_FALSE(views.has_demonstrations || views.has_holds);
  WriteFileAtomically(seen / "holds.csv", "");
  EXPECT_TRUE(OpenSet(seen.path()).has_holds);

  const TemporaryDirectory shown;
  testing::MakeDemonstrationSet(shown.path());
  EXPECT_TRUE(OpenSet(shown.path()).has_demonstrations);
  EXPECT_FALSE(OpenSet(shown.path()).has_holds);
}

TEST(OpenSet, SaysWhatAFolderLacks) {
  const TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(
      OpenSet(folder.path()), Error, HasSubstr("neither manifest.csv nor views.csv"));
  EXPECT_THROWS_MESSAGE(OpenSet("no/such"), Error, HasSubstr("no/such"));
  WriteFileAtomically(folder / "manifest.csv", kManifest);
  WriteViews(testing::MakeViewSet(folder.path()));
  EXPECT_THROWS_MESSAGE(
      OpenSet(folder.path()), Error, HasSubstr("both manifest.csv and views.csv in this folder"));
}

TEST(OpenSet, NamesALinkThatLeadsRoundInACircle) {
  const TemporaryDirectory folder;
  std::filesystem::create_symlink("y", folder / "y");
  EXPECT_THROWS_MESSAGE(
      OpenSet(folder / "y"), Error, HasSubstr("y/manifest.csv: cannot open: Too many levels"));
  for (const std::string name : {"views.csv", "manifest.csv"}) {
    std::filesystem::create_symlink(name, folder / name);
    EXPECT_THROWS_MESSAGE(
        OpenSet(folder.path()), Error, HasSubstr(name + ": cannot open: Too many levels"));
    std::filesystem::remove(folder / name);
  }
  WriteViews(testing::MakeViewSet(folder.path()));
  std::filesystem::create_symlink("holds.csv", folder / "holds.csv");
  const CheckedSet checked = CheckSet(OpenSet(folder.path()));
  ASSERT_FALSE(checked.faults.empty());
  EXPECT_THAT(checked.faults.back().reason, HasSubstr("Too many levels"));
}

TEST(CheckSet, LooksAtEveryList) {
  const TemporaryDirectory folder;
  testing::MakeDemonstrationSet(folder.path());
  const CheckedSet sound = CheckSet(OpenSet(folder.path()));
  EXPECT_EQ(sound.num_images, 3U);
  EXPECT_EQ(sound.num_demonstrations, 3U);
  EXPECT_EQ(sound.num_holds, std::nullopt);
  // the three views show the same gray
  EXPECT_THAT(sound.faults, SizeIs(2));

  WriteFileAtomically(folder / "holds.csv", kHold);
  std::string rows = ReadTextFile(folder / "demonstrations.csv");
  WriteFileAtomically(folder / "demonstrations.csv", rows + rows.substr(rows.find("\nmug") + 1));
  const CheckedSet checked = CheckSet(OpenSet(folder.path()), 2);
  EXPECT_EQ(checked.num_demonstrations, 6U);
  EXPECT_EQ(checked.num_holds, 1U);
  ASSERT_THAT(checked.faults, SizeIs(2 + 3 + 1));
  EXPECT_EQ(checked.faults[2].path, "demonstrations.csv");
  EXPECT_EQ(checked.faults[2].line, 5U);
  EXPECT_EQ(checked.faults[2].reason, "the same row as on line 2");
  EXPECT_EQ(checked.faults[5].path, "holds.csv");
  EXPECT_EQ(checked.faults[5].line, 2U);
  EXPECT_THAT(checked.faults[5].reason, HasSubstr("the quaternion has length 2"));
}

TEST(CheckSet, FindsNothingInASoundViewSet) {
  const TemporaryDirectory folder;
  WriteViews(testing::MakeViewSet(folder.path()));
  const CheckedSet checked = CheckSet(OpenSet(folder.path()));
  EXPECT_THAT(checked.faults, IsEmpty());
  EXPECT_EQ(checked.num_demonstrations, std::nullopt);
}

TEST(CheckSet, MissesTheListOfAMadeUpKind) {
  const TemporaryDirectory folder;
  WriteViews(testing::MakeViewSet(folder.path()));
  for (const auto& [kind, list] :
       {std::pair("demonstrations", "demonstrations.csv"), std::pair("regrasp", "holds.csv")}) {
    WriteFileAtomically(folder / "dataset.toml", "kind = \"" + std::string(kind) + "\"\n");
    const CheckedSet checked = CheckSet(OpenSet(folder.path()));
    ASSERT_THAT(checked.faults, SizeIs(1)) << kind;
    EXPECT_EQ(checked.faults[0].path, list);
    EXPECT_EQ(checked.faults[0].reason,
              "is not there; dataset.toml tells of a set of the kind " + std::string(kind));
  }
  WriteFileAtomically(folder / "holds.csv", kHold);
  WriteFileAtomically(folder / "dataset.toml", "kind = \"regrasp\"\n");
  const CheckedSet holds_alone = CheckSet(OpenSet(folder.path()));
  ASSERT_FALSE(holds_alone.faults.empty());
  EXPECT_EQ(holds_alone.faults[0].path, "demonstrations.csv");
  std::filesystem::remove(folder / "holds.csv");
  WriteFileAtomically(folder / "dataset.toml", "kind = \"turntable\"\n");
  EXPECT_THAT(CheckSet(OpenSet(folder.path())).faults, IsEmpty());
  WriteFileAtomically(folder / "dataset.toml", "[camera]\n");
  EXPECT_THAT(CheckSet(OpenSet(folder.path())).faults, IsEmpty());
  WriteFileAtomically(folder / "dataset.toml", "kind = ");
  const CheckedSet damaged = CheckSet(OpenSet(folder.path()));
  ASSERT_THAT(damaged.faults, SizeIs(1));
  EXPECT_EQ(damaged.faults[0].path, "dataset.toml");
}

TEST(CheckSet, NotesPicturesThatNoRowNames) {
  const TemporaryDirectory folder;
  LabelledImageSet set = testing::MakeSet(folder.path());
  WriteManifest(set);
  EXPECT_THAT(CheckSet(OpenSet(folder.path())).notes, SizeIs(1)) << "d has no good pixel";
  set.items.erase(set.items.begin());
  WriteManifest(set);
  WriteFileAtomically(folder / "notes.txt", "no picture");
  std::filesystem::create_directory(folder / "other");
  WriteFileAtomically(folder / "other/a.png", "in no folder of the set");
  const CheckedSet checked = CheckSet(OpenSet(folder.path()));
  EXPECT_THAT(checked.faults, IsEmpty());
  ASSERT_THAT(checked.notes, SizeIs(2));
  EXPECT_EQ(checked.notes[1].path, "a.png");
  EXPECT_EQ(checked.notes[1].reason, "is in no row of the list, the first of 2: nothing reads it");
}

TEST(RewriteSplits, WritesThatColumnAlone) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "manifest.csv", kManifest);
  StoredSet set = OpenSet(folder.path());
  std::get<LabelledImageSet>(set.pictures).items[1].split = "new";
  RewriteSplits(set);
  EXPECT_EQ(ReadTextFile(folder / "manifest.csv"),
            "split,note,image,mask,class,instance,licence\n"
            "old,\"a, b\",i.png,m.png,mug,1,\n"
            "new,,j.png,n.png,mug,2,MIT\n");
  std::get<LabelledImageSet>(set.pictures).items.pop_back();
  EXPECT_THROWS_MESSAGE(RewriteSplits(set), Error, HasSubstr("2 rows; 1 are due"));
}

}  // namespace
}  // namespace handcraft::datasets
