// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/umd.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tests/datasets/importers/importer_test.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Words = std::vector<std::uint32_t>;

// A MAT-file with the matrix `name` of 8-bit numbers, given column after column.
std::string MatFile(const std::string& name, const Words& dimensions, const std::string& values) {
  const auto words = [](const Words& numbers) {
    std::string text(numbers.size() * 4, '\0');
    std::memcpy(text.data(), numbers.data(), text.size());
    return text;
  };
  const auto element = [&](std::uint32_t type, std::string data) {
    const auto size = static_cast<std::uint32_t>(data.size());
    data.resize((data.size() + 7) / 8 * 8);
    return words({type, size}) + data;
  };
  return std::string(124, ' ') + words({0x4D490100}) +
         element(14,
                 element(6, words({9, 0})) + element(5, words(dimensions)) + element(1, name) +
                     element(2, values));
}

// The pictures are turned JPEGs, 3 wide and 4 high as they are seen.
class ListUmdTest : public ImporterTest {
 protected:
  void SetUp() override { AddPicture("tools/mug_01", "mug_01_00000001"); }

  void AddPicture(const fs::path& folder, const std::string& name) const {
    fs::create_directories(tree_ / folder);
    testing::WriteTurnedJpeg(tree_ / folder / (name + "_rgb.jpg"), 4, 3);
    std::string values(12, '\0');
    for (std::size_t i = 0; i < 8; ++i) values[i] = static_cast<char>(i);
    WriteText(folder / (name + "_label.mat"), MatFile("gt_label", {4, 3}, values));
  }
  void WriteLabels(const Words& dimensions, const std::string& values) const {
    WriteText(kLabels, MatFile("gt_label", dimensions, values));
  }
  [[nodiscard]] Image Mask(const LabelRoles& roles = UmdRoles()) const {
    return ListUmd(tree_, roles).pictures.at(0).make_mask(3, 4);
  }
  [[nodiscard]] std::string Refusal(const LabelRoles& roles = UmdRoles()) const {
    return RefusalOf([&] { return ListUmd(tree_, roles); });
  }

  static constexpr const char* kLabels = "tools/mug_01/mug_01_00000001_label.mat";
};

TEST_F(ListUmdTest, ReadsATree) {
  AddPicture("tools/mug_01", "mug_01_00000004");
  AddPicture("tools/wood_spoon_12", "x");
  WriteText("tools/mug_01/mug_01_00000001_depth.png", "not read");
  const SourceSet source = ListUmd(tree_, UmdRoles());
  ASSERT_THAT(source.pictures, SizeIs(3));
  EXPECT_EQ(source.pictures[0].image, "tools/mug_01/mug_01_00000001_rgb.jpg");
  EXPECT_EQ(source.pictures[0].mask, "tools/mug_01/mug_01_00000001.png");
  EXPECT_EQ(source.pictures[0].object_class, "mug");
  EXPECT_EQ(source.pictures[0].instance, "mug_01");
  EXPECT_EQ(source.pictures[1].instance, "mug_01");
  EXPECT_EQ(source.pictures[2].object_class, "wood_spoon");
  EXPECT_EQ(source.pictures[2].instance, "wood_spoon_12");
  const LabelledImageSet set = ImportPictures(source, out_, {});
  EXPECT_THAT(set.Only("test").items, SizeIs(1));
  // Column after column: 0 1 2 3, 4 5 6 7, 0 0 0 0.
  const Image mask = ReadMask(set, 0);
  EXPECT_EQ(mask.values(), (std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 255, 0}));
}

TEST_F(ListUmdTest, TakesTheFolderForTheObject) {
  const SourceSet source = ListUmd(tree_ / "tools/mug_01", UmdRoles());
  EXPECT_EQ(source.pictures.at(0).instance, "mug_01");
  EXPECT_EQ(source.pictures.at(0).object_class, "mug");
}

TEST_F(ListUmdTest, GivesAffordancesTheirRoles) {
  const Image mask = Mask({.good = {"contain", "pound"}, .bad = {"cut"}, .dont_care = {"support"}});
  EXPECT_EQ(mask.At(0, 1), kMaskBad) << "grasp";
  EXPECT_EQ(mask.At(1, 0), kMaskGood) << "contain";
  EXPECT_EQ(mask.At(1, 1), kMaskGood) << "pound";
  EXPECT_EQ(mask.At(1, 2), kMaskDontCare) << "support";
  EXPECT_THAT(Refusal({.good = {"grasps"}}),
              HasSubstr("nothing is labelled 'grasps'; there are: 'contain', 'cut', 'grasp'"));
}

TEST_F(ListUmdTest, TakesTheFirstOfRankedAffordances) {
  fs::remove(tree_ / kLabels);
  std::string ranks(3 * 4 * 7, '\0');
  ranks[0] = 2;           // the first pixel: grasp comes second,
  ranks[3 * 12] = 1;      // contain first
  ranks[6 * 12 + 1] = 1;  // the next one down: wrap-grasp
  WriteText("tools/mug_01/mug_01_00000001_label_rank.mat", MatFile("gt_label", {4, 3, 7}, ranks));
  const Image mask = Mask();
  EXPECT_EQ(mask.At(0, 0), kMaskBad);
  EXPECT_EQ(mask.At(0, 1), kMaskGood);
  EXPECT_EQ(mask.At(2, 3), kMaskBad);
  EXPECT_EQ(Mask({.good = {"contain"}}).At(0, 0), kMaskGood);
}

TEST_F(ListUmdTest, RefusesMatricesThatDoNotFit) {
  WriteLabels({3, 4}, std::string(12, '\0'));
  EXPECT_THAT(Refusal(), HasSubstr("matrix gt_label is 4x3 pixels, its picture 3x4"));
  WriteLabels({4, 3, 2}, std::string(24, '\0'));
  EXPECT_THAT(Refusal(), HasSubstr("gt_label has 2 layers; one for each of 7"));
  WriteLabels({4, 3, 1, 2}, std::string(24, '\0'));
  EXPECT_THAT(Refusal(), HasSubstr("gt_label has 2 layers; one is due"));
  WriteLabels({4, 3}, std::string(11, '\0') + '\x08');
  EXPECT_THAT(Refusal(), HasSubstr("_label.mat: a label beyond 0 ... 7 at column 2, row 3"));
  WriteText(kLabels, MatFile("labels", {1, 1}, "0"));
  EXPECT_THAT(Refusal(), HasSubstr("no array 'gt_label'; there are: 'labels'"));
  WriteText(kLabels, "MATLAB");
  EXPECT_THAT(Refusal(), HasSubstr("not a MAT-file of level 5"));
}

TEST_F(ListUmdTest, SaysWhatWasExpectedAndFound) {
  fs::remove(tree_ / kLabels);
  EXPECT_THAT(Refusal(),
              AllOf(HasSubstr("mug_01_00000001_rgb.jpg: left out: no *_label.mat or"),
                    HasSubstr("no *_rgb.jpg with labels; found 1 files")));
  fs::rename(tree_ / "tools/mug_01/mug_01_00000001_rgb.jpg", tree_ / "tools/a.jpg");
  EXPECT_THAT(Refusal(), HasSubstr("no *_rgb.jpg with labels; found 1 files"));
  EXPECT_THAT(Refusal({.good = {"handle"}}), HasSubstr("no *_rgb.jpg with labels; found 1 files"))
      << "labels are asked of the right tree alone";
  fs::remove_all(tree_);
  EXPECT_THAT(Refusal(), HasSubstr("cannot read the folder"));
}

}  // namespace
}  // namespace handcraft::datasets
