// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/image_set_import.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "datasets/labelled_image_faults.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::NoiseImage;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

Image HalfGood(int width, int height) {
  return testing::CountedMask(width, height, width, width * (height - 1));
}

// Pictures of 40 × 30 in folder/source with these names; each is its own instance.
SourceSet MakeSource(const fs::path& folder, const std::vector<std::string>& names) {
  SourceSet source;
  fs::create_directories(folder / "source");
  for (const std::string& name : names) {
    const fs::path path = folder / "source" / (name + ".png");
    fs::create_directories(path.parent_path());
    perception::WritePng(path, NoiseImage(40, 30, 3, source.pictures.size()));
    source.pictures.push_back({.path = path,
                               .image = name + ".png",
                               .mask = name + ".png",
                               .instance = name,
                               .make_mask = HalfGood});
  }
  return source;
}

std::vector<std::string> InstancesOf(const LabelledImageSet& set, const std::string& split) {
  std::vector<std::string> names;
  for (const LabelledImage& item : set.items) {
    if (item.split == split) names.push_back(item.instance);
  }
  return names;
}

std::ptrdiff_t NumEntries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(ImportPictures, WritesASetWithoutFaults) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"a", "b", "cups/red/c"});
  source.pictures[2].object_class = "cups";
  const LabelledImageSet set =
      ImportPictures(std::move(source), folder / "out", {.licence = "CC0-1.0"});
  EXPECT_EQ(set.root, folder / "out");
  ASSERT_THAT(set.items, SizeIs(3));
  EXPECT_EQ(set.items[2].image, "images/cups/red/c.png");
  EXPECT_EQ(set.items[2].mask, "masks/cups/red/c.png");
  EXPECT_EQ(set.items[2].object_class, "cups");
  EXPECT_EQ(set.items[2].licence, "CC0-1.0");
  EXPECT_EQ(ReadFile(folder / "out/images/a.png"), ReadFile(folder / "source/a.png"));
  EXPECT_EQ(ReadMask(set, 0).values(), HalfGood(40, 30).values());
  EXPECT_THAT(FindFaults(ReadLabelledImageSet(folder / "out")), IsEmpty());
}

TEST(ImportPictures, PutsTheLastInstancesIntoTheTest) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"d", "b", "a", "c", "e", "f"});
  source.pictures[0].instance = "b";  // b twice: instances a b c e f
  const auto split = [&](double share, const std::string& out) {
    return InstancesOf(ImportPictures(source, folder / out, {.test_share = share}), "test");
  };
  EXPECT_THAT(split(0.4, "a"), ElementsAre("e", "f"));
  EXPECT_THAT(split(0.8, "b"), ElementsAre("b", "b", "c", "e", "f"));
  EXPECT_THAT(split(0.0, "c"), IsEmpty());
  EXPECT_THAT(split(0.01, "d"), ElementsAre("f")) << "at least one";
  EXPECT_THAT(split(0.99, "e"), SizeIs(5)) << "never all";
  source.pictures.resize(1);
  EXPECT_THAT(split(0.5, "f"), IsEmpty()) << "a single instance is for training";
}

TEST(ImportPictures, TakesTheInstanceFromAPattern) {
  const TemporaryDirectory folder;
  const SourceSet source = MakeSource(folder.path(), {"mug1/a", "mug1/b", "mug2/a"});
  const auto instances = [&](const std::string& pattern, const std::string& out) {
    return InstancesOf(
        ImportPictures(source, folder / out, {.test_share = 0.0, .instance_pattern = pattern}),
        "train");
  };
  EXPECT_THAT(instances("^([^/]*)/", "a"), ElementsAre("mug1", "mug1", "mug2"));
  EXPECT_THAT(instances("mug.", "b"), ElementsAre("mug1", "mug1", "mug2"));
  EXPECT_THROWS_MESSAGE(instances("mug1", "c"),
                        Error,
                        HasSubstr("the instance pattern 'mug1' finds nothing in 'mug2/a.png'"));
  EXPECT_THROWS_MESSAGE(instances("x*", "d"), Error, HasSubstr("finds nothing"));
}

TEST(ImportPictures, LeavesOutTheNeighboursOfTheTest) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"a", "b", "c", "d"});
  source.split_gap = 5;
  source.pictures[0].number = 10;
  source.pictures[1].number = 16;
  source.pictures[3].number = 20;  // d is the test; c has no number
  EXPECT_THAT(InstancesOf(ImportPictures(source, folder / "out", {.test_share = 0.25}), "train"),
              ElementsAre("a", "c"));
}

TEST(ImportPictures, KeepsFewPicturesEvenlySpread) {
  const TemporaryDirectory folder;
  const SourceSet source = MakeSource(folder.path(), {"1", "2", "3", "4", "5", "6", "7", "8", "9"});
  const auto kept = [&](int count) {
    const fs::path out = folder / ("out" + std::to_string(count));
    return InstancesOf(ImportPictures(source, out, {.test_share = 0.0, .max_images = count}),
                       "train");
  };
  EXPECT_THAT(kept(1), ElementsAre("1"));
  EXPECT_THAT(kept(3), ElementsAre("1", "5", "9"));
  EXPECT_THAT(kept(5), ElementsAre("1", "3", "5", "7", "9"));
  EXPECT_THAT(kept(20), SizeIs(9));
}

TEST(ImportPictures, GivesTheSameFilesForAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  std::vector<std::string> names;
  for (int i = 10; i < 40; ++i) names.push_back(std::to_string(i));
  const SourceSet source = MakeSource(folder.path(), names);
  std::vector<std::size_t> done;
  ImportOptions options{.num_threads = 3};
  options.progress = [&](std::string_view, std::size_t count, std::size_t) {
    done.push_back(count);
  };
  const LabelledImageSet one = ImportPictures(source, folder / "one", {});
  const LabelledImageSet three = ImportPictures(source, folder / "three", options);
  EXPECT_EQ(Fingerprint(one), Fingerprint(three));
  EXPECT_EQ(ReadFile(folder / "one/manifest.csv"), ReadFile(folder / "three/manifest.csv"));
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.back(), 30U);
}

TEST(ImportPictures, WritesEmbeddedPictures) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"a"});
  const std::vector<std::uint8_t> bytes = ReadFile(source.pictures[0].path);
  source.pictures[0].path = folder / "source/a.json";
  source.pictures[0].embedded = [&bytes] {
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  };
  ImportPictures(source, folder / "out", {});
  EXPECT_EQ(ReadFile(folder / "out/images/a.png"), bytes);
  source.pictures[0].embedded = [] { return std::vector<std::uint8_t>{1, 2, 3}; };
  EXPECT_THROWS_MESSAGE(ImportPictures(source, folder / "no", {}),
                        Error,
                        HasSubstr("a.json: the embedded picture: "));
}

TEST(ImportPictures, TakesUnusualNames) {
  const TemporaryDirectory folder;
  const std::vector<std::string> names = {"a b", "comma,name", "line\nend", "quote\"d", "ü"};
  ImportPictures(MakeSource(folder.path(), names), folder / "out", {.test_share = 0.0});
  const LabelledImageSet set = ReadLabelledImageSet(folder / "out");
  EXPECT_EQ(InstancesOf(set, "train"), names);
  EXPECT_THAT(FindFaults(set), IsEmpty());
}

TEST(ImportPictures, RefusesTwoPicturesOfOneName) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"a", "b"});
  source.pictures[1].mask = "a.png";
  EXPECT_THROWS_MESSAGE(ImportPictures(source, folder / "out", {}),
                        Error,
                        HasSubstr("b.png: stands for the same picture as"));
  source.pictures[1].mask = "b.png";
  source.pictures[1].image = "a.png";
  EXPECT_THROWS_MESSAGE(ImportPictures(source, folder / "out", {}),
                        Error,
                        HasSubstr("b.png: stands for the same picture as"));
}

TEST(ImportPictures, RefusesAMaskOfAnotherSize) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"a"});
  source.pictures[0].make_mask = [](int, int) { return Image(40, 29); };
  EXPECT_THROWS_MESSAGE(ImportPictures(source, folder / "out", {}),
                        Error,
                        HasSubstr("a.png: the mask is 40x29 pixels, its picture 40x30"));
}

TEST(ImportPictures, LeavesNothingBehindOnFailure) {
  const TemporaryDirectory folder;
  const SourceSet source = MakeSource(folder.path(), {"a", "b"});
  WriteFileAtomically(folder / "source/b.png", "not a picture");
  EXPECT_THROWS_MESSAGE(
      ImportPictures(source, folder / "out", {}), Error, HasSubstr("b.png: not a picture"));
  EXPECT_EQ(NumEntries(folder.path()), 1);
  WriteFileAtomically(folder / "out", "a file");
  EXPECT_THROWS_MESSAGE(
      ImportPictures(source, folder / "out", {}), Error, HasSubstr("is there already"));
}

TEST(ImportPictures, LeavesNothingBehindWhenTheDiskIsFull) {
  const TemporaryDirectory folder;
  const SourceSet source = MakeSource(folder.path(), {"a"});
  {
    const testing::FullDisk full_disk;
    EXPECT_THROWS_MESSAGE(
        ImportPictures(source, folder / "out", {}), Error, HasSubstr("a.png: cannot write"));
  }
  EXPECT_EQ(NumEntries(folder.path()), 1);
}

TEST(ImportPictures, TellsWhatIsWorthKnowingInTheOrderOfThePictures) {
  const TemporaryDirectory folder;
  SourceSet source = MakeSource(folder.path(), {"a", "b", "c"});
  source.pictures[0].make_mask = [](int width, int height) {
    return Image(width, height, 1, kMaskGood);
  };
  source.pictures[2].make_mask = [](int width, int height) { return Image(width, height); };
  source.pictures[2].find_notes = [](int width, int height) {
    return std::vector<Fault>{{.path = "c.json", .reason = std::to_string(width * height)}};
  };
  std::vector<std::string> told;
  const auto tell = [&](const Fault& note) { told.push_back(note.path + ": " + note.reason); };
  ImportPictures(std::move(source), folder / "out", {.num_threads = 2, .on_note = tell});
  EXPECT_THAT(told,
              ::testing::ElementsAre(
                  "masks/a.png: no bad pixel (0): training draws nothing from the picture",
                  "c.json: 1200",
                  "masks/c.png: no good pixel (255): training draws nothing from the picture"));
}

}  // namespace
}  // namespace handcraft::datasets
