// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell.h"

#include <map>
#include <string>

#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::string_view kRectangle = "4 4\n10 4\n10 8\n4 8\n";

class ImportCornellTest : public ImporterTest {
 protected:
  // A picture of 40 × 30 with one rectangle, both in `folder`.
  void AddPicture(const fs::path& folder, const std::string& number) const {
    WriteImage(folder / ("pcd" + number + "r.png"), 40, 30);
    WriteText(folder / ("pcd" + number + "cpos.txt"), kRectangle);
  }
  [[nodiscard]] LabelledImageSet Import(const CornellOptions& options = {},
                                        const ImportOptions& import = {}) const {
    fs::remove_all(out_);
    return ImportPictures(ListCornell(tree_, options), out_, import);
  }
};

std::vector<std::string> NumbersOf(const LabelledImageSet& set, const std::string& split) {
  std::vector<std::string> numbers;
  for (const LabelledImage& item : set.items) {
    if (item.split == split) numbers.push_back(item.image.substr(10, 4));
  }
  return numbers;
}

TEST(CornellOptions, HasTheDocumentedDefaults) {
  const CornellOptions options;
  EXPECT_DOUBLE_EQ(options.mask.good_share, 1.0 / 3.0);
  EXPECT_EQ(options.mask.dont_care_margin_px, 12);
  EXPECT_TRUE(options.use_negative_rectangles);
  EXPECT_EQ(options.instance_span, 10);
  EXPECT_EQ(options.split_gap, 10);
}

TEST_F(ImportCornellTest, ReadsTheOriginalTree) {
  AddPicture("01", "0100");
  AddPicture("02", "0250");
  WriteText("02/pcd0250cneg.txt", "0 0\r\n3 0\r\n3 3\r\n0 3\r\n");
  WriteText("01/pcd0100.txt",
            "FIELDS x y z rgb index\nSIZE 4 4 4 4 4\nTYPE F F F F U\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
            "DATA ascii\n1500 0 -250 0 41\n");
  WriteText("pcdb0002r.png", "a background, not read");
  const LabelledImageSet set = Import();

  ASSERT_THAT(set.items, SizeIs(2));
  EXPECT_EQ(set.items[0].image, "images/pcd0100r.png");
  EXPECT_EQ(set.items[0].mask, "masks/pcd0100.png");
  EXPECT_EQ(set.items[0].object_class, "object");
  EXPECT_EQ(set.items[0].instance, "0100-0109");
  EXPECT_EQ(set.items[0].split, "train");
  EXPECT_EQ(set.items[1].split, "test");
  EXPECT_EQ(set.items[0].Companion(kCloud), "clouds/pcd0100.pcd");
  EXPECT_EQ(set.items[1].Companion(kCloud), "");
  const OrganisedCloud cloud = ReadPcd(out_ / "clouds/pcd0100.pcd");
  EXPECT_TRUE(cloud.At(1, 1).isApprox(Eigen::Vector3f(1.5F, 0, -0.25F)));
  EXPECT_EQ(ReadTextFile(out_ / "rectangles.csv"),
            "image,good,u1_px,v1_px,u2_px,v2_px,u3_px,v3_px,u4_px,v4_px\n"
            "images/pcd0100r.png,1,4,4,10,4,10,8,4,8\n"
            "images/pcd0250r.png,1,4,4,10,4,10,8,4,8\n"
            "images/pcd0250r.png,0,0,0,3,0,3,3,0,3\n");
  EXPECT_EQ(ReadFile(out_ / "images/pcd0250r.png"), ReadFile(tree_ / "02/pcd0250r.png"));
  const Image mask = ReadMask(set, 1);
  EXPECT_EQ(mask.At(7, 6), kMaskGood);
  EXPECT_EQ(mask.At(5, 6), kMaskDontCare) << "outer third";
  EXPECT_EQ(mask.At(12, 12), kMaskDontCare) << "margin";
  EXPECT_EQ(mask.At(1, 1), kMaskBad) << "negative rectangle inside the margin";
  EXPECT_EQ(mask.At(39, 29), kMaskBad);
  EXPECT_THAT(FindFaults(ReadLabelledImageSet(out_)), IsEmpty());
}

TEST_F(ImportCornellTest, ReadsImagesBesideRecoveredLabelsAndGraspTypes) {
  AddPicture("images", "0100");
  fs::create_directories(tree_ / "labels");
  fs::rename(tree_ / "images/pcd0100cpos.txt", tree_ / "labels/pcd0100cpos_recovered.txt");
  WriteText("grasp_type.csv", "image,grasp_type\npcd0100r.png,2\n");
  const LabelledImageSet set = Import({}, {.licence = "GPL-3.0"});
  ASSERT_THAT(set.items, SizeIs(1));
  EXPECT_EQ(set.items[0].object_class, "palmar_pinch");
  EXPECT_EQ(set.items[0].licence, "GPL-3.0");
  EXPECT_EQ(set.items[0].split, "train") << "a single instance is for training";
}

TEST_F(ImportCornellTest, SplitsByRangesOfNumbers) {
  for (const char* number : {"0100", "0105", "0111", "0120", "0124", "0129", "0131"}) {
    AddPicture("", number);
  }
  const LabelledImageSet set = Import({.split_gap = 0}, {.test_share = 0.25});
  EXPECT_THAT(NumbersOf(set, "train"), ElementsAre("0100", "0105", "0111", "0120", "0124", "0129"));
  EXPECT_THAT(NumbersOf(set, "test"), ElementsAre("0131"));
  // 0129 and 0124 are within ten of 0131.
  const LabelledImageSet apart = Import({}, {.test_share = 0.25});
  EXPECT_THAT(NumbersOf(apart, "train"), ElementsAre("0100", "0105", "0111", "0120"));
  const LabelledImageSet half = Import({.split_gap = 0}, {.test_share = 0.5});
  EXPECT_THAT(NumbersOf(half, "test"), ElementsAre("0120", "0124", "0129", "0131"));
  const LabelledImageSet none = Import({}, {.test_share = 0.0});
  EXPECT_THAT(NumbersOf(none, "train"), SizeIs(7));
  const LabelledImageSet single =
      Import({.instance_span = 1, .split_gap = 0}, {.test_share = 0.15});
  EXPECT_THAT(NumbersOf(single, "test"), ElementsAre("0131"));
  EXPECT_EQ(single.items[0].instance, "0100");
}

TEST_F(ImportCornellTest, LeavesOutPicturesWithoutUsableRectangles) {
  AddPicture("", "0100");
  AddPicture("", "0200");
  AddPicture("", "0300");
  WriteText("pcd0200cpos.txt", "NaN NaN\nNaN 1\n2 3\n4 5\n");
  fs::remove(tree_ / "pcd0300cpos.txt");
  EXPECT_THAT(Import().items, SizeIs(1));
}

TEST_F(ImportCornellTest, SaysWhatWasExpectedAndFound) {
  EXPECT_THROWS_MESSAGE(Import(), Error, HasSubstr("cannot read the folder"));
  AddPicture("", "0100");
  AddPicture("", "0200");
  fs::remove(tree_ / "pcd0100r.png");
  fs::remove(tree_ / "pcd0200cpos.txt");
  EXPECT_THROWS_MESSAGE(Import(),
                        Error,
                        AllOf(HasSubstr("no pcdNNNNr.png with grasp rectangles"),
                              HasSubstr("found 1 pictures and 1 files of rectangles")));
  AddPicture("01", "0200");
  EXPECT_THROWS_MESSAGE(Import(), Error, HasSubstr("pcd0200r.png: stands for the same picture as"));
}

TEST_F(ImportCornellTest, RefusesAWrongGraspType) {
  AddPicture("", "0100");
  WriteText("grasp_type.csv", "image,grasp_type\npcd0100r.png,6\n");
  EXPECT_THROWS_MESSAGE(Import(), Error, HasSubstr("grasp_type.csv:2: grasp type '6'"));
}

TEST(CornellOptions, NamesTheFieldAtFault) {
  const std::map<std::string, CornellOptions> cases = {
      {"GraspMaskOptions.good_share is 0", {.mask = {.good_share = 0.0}}},
      {"CornellOptions.instance_span is 0", {.instance_span = 0}},
      {"CornellOptions.split_gap is -1", {.split_gap = -1}}};
  for (const auto& [message, options] : cases) {
    EXPECT_THROWS_MESSAGE((options.Validate(), 0), Error, HasSubstr(message));
  }
}

// The shipped sample is what the importer makes of the pictures it was made from.
TEST_F(ImportCornellTest, MadeTheSampleSet) {
  const fs::path sample = fs::path(HANDCRAFT_SOURCE_DIR) / "datasets/samples/cornell_mini";
  const LabelledImageSet set = ReadLabelledImageSet(sample);
  EXPECT_THAT(set.Only("train").items, SizeIs(16));
  EXPECT_THAT(set.Only("test").items, SizeIs(8));
  EXPECT_THAT(FindFaults(set), IsEmpty());

  const fs::path source = fs::path(HANDCRAFT_SOURCE_DIR) / "../shared/data/cornell_grasp";
  if (!fs::exists(source)) GTEST_SKIP() << "the full Cornell pictures are not at " << source;
  const LabelledImageSet again = ImportPictures(
      ListCornell(source, {}), out_, {.max_images = 24, .licence = "GPL-3.0", .num_threads = 2});
  EXPECT_EQ(Fingerprint(again), Fingerprint(set));
  EXPECT_EQ(ReadFile(out_ / "manifest.csv"), ReadFile(sample / "manifest.csv"));
  EXPECT_EQ(ReadFile(out_ / "rectangles.csv"), ReadFile(sample / "rectangles.csv"));
}

}  // namespace
}  // namespace handcraft::datasets
