// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/jacquard.h"

#include <cmath>
#include <string>

#include "lib/core/rng.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

std::vector<GraspRectangle> ReadText(const std::string& text) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "0_a_grasps.txt", text);
  return ReadJacquardGrasps(folder / "0_a_grasps.txt");
}

class ListJacquardTest : public ImporterTest {
 protected:
  // A picture of 40 × 30, its grasp opens along u from 11 to 29.
  void AddScene(const fs::path& folder, const std::string& scene) const {
    WriteImage(folder / (scene + "_RGB.png"), 40, 30);
    WriteText(folder / (scene + "_grasps.txt"), "20;15;0;18;4\n");
  }
};

TEST(ReadJacquardGrasps, PutsTheOpeningOnTheFirstEdge) {
  const auto grasps = ReadText("20.0;15.0;0.0;18.0;4.0\r\n20;15;90;18;4\n\n");
  ASSERT_THAT(grasps, SizeIs(2));
  EXPECT_EQ(grasps[0], (GraspRectangle{{{11, 13}, {29, 13}, {29, 17}, {11, 17}}}));
  const GraspRectangle down = {{{22, 6}, {22, 24}, {18, 24}, {18, 6}}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(grasps[1][i][0], down[i][0], 1e-12);
    EXPECT_NEAR(grasps[1][i][1], down[i][1], 1e-12);
  }
}

// A positive angle turns towards v: to the right and down.
TEST(ReadJacquardGrasps, KeepsMiddleEdgesAndAngle) {
  Rng rng(4);
  for (int round = 0; round < 50; ++round) {
    const double x = 100 * rng.Uniform();
    const double y = 100 * rng.Uniform();
    const double theta = 180 * rng.Uniform() - 90;
    const double opening = 5 + 50 * rng.Uniform();
    const double jaw = 5 + 20 * rng.Uniform();
    std::string text;
    for (const double number : {x, y, theta, opening}) text += std::to_string(number) + ';';
    const auto grasps = ReadText(text + std::to_string(jaw));
    ASSERT_THAT(grasps, SizeIs(1));
    const auto& [a, b, c, d] = grasps[0];
    constexpr double kRounding = 1e-4;  // the text has six decimals
    EXPECT_NEAR((a[0] + b[0] + c[0] + d[0]) / 4, x, kRounding);
    EXPECT_NEAR((a[1] + b[1] + c[1] + d[1]) / 4, y, kRounding);
    EXPECT_NEAR(std::hypot(b[0] - a[0], b[1] - a[1]), opening, kRounding);
    EXPECT_NEAR(std::hypot(c[0] - b[0], c[1] - b[1]), jaw, kRounding);
    EXPECT_NEAR(std::atan2(b[1] - a[1], b[0] - a[0]) * 180 / M_PI, theta, kRounding * 10);
  }
}

TEST(ReadJacquardGrasps, LeavesOutWhatHasNoArea) {
  EXPECT_THAT(ReadText(""), IsEmpty());
  EXPECT_THAT(ReadText("1;2;3;0;5\n1;2;3;0.5;1\n1;2;3;4;5\n"), SizeIs(1));
}

TEST(ReadJacquardGrasps, NamesTheLine) {
  for (const std::string line : {"1;2;3;4",
                                 "1;2;3;4;5;6",
                                 "1,2,3,4,5",
                                 "1;2;x;4;5",
                                 "1;2;nan;4;5",
                                 "1;2;3;inf;5",
                                 "1;2;3;4;1e9",
                                 ";;;;",
                                 "1;2;3;4;5 px"}) {
    EXPECT_THROWS_MESSAGE(ReadText("1;2;3;4;5\n" + line),
                          Error,
                          AllOf(HasSubstr("grasps.txt:2: '" + line + "' where a grasp")));
  }
}

TEST_F(ListJacquardTest, ReadsATree) {
  AddScene("Jacquard_Dataset_0/1a2b", "0_1a2b");
  AddScene("Jacquard_Dataset_0/1a2b", "1_1a2b");
  AddScene("Jacquard_Dataset_1/x_y", "12_x_y");
  AddScene("odd", "_z");
  WriteText("odd/0_1a2b_mask.png", "not read");
  const SourceSet source = ListJacquard(tree_, {.dont_care_margin_px = 3});
  ASSERT_THAT(source.pictures, SizeIs(4));
  EXPECT_EQ(source.pictures[0].image, "Jacquard_Dataset_0/1a2b/0_1a2b_RGB.png");
  EXPECT_EQ(source.pictures[0].mask, "Jacquard_Dataset_0/1a2b/0_1a2b.png");
  EXPECT_EQ(source.pictures[0].object_class, "object");
  EXPECT_EQ(source.pictures[0].instance, "1a2b");
  EXPECT_EQ(source.pictures[1].instance, "1a2b");
  EXPECT_EQ(source.pictures[2].instance, "x_y");
  EXPECT_EQ(source.pictures[3].instance, "_z");
  const LabelledImageSet set = ImportPictures(source, out_, {});
  EXPECT_THAT(FindFaults(ReadLabelledImageSet(out_)), IsEmpty());
  const Image mask = ReadMask(set, 0);
  EXPECT_EQ(mask.At(20, 15), kMaskGood);
  EXPECT_EQ(mask.At(24, 15), kMaskDontCare) << "outer third";
  EXPECT_EQ(mask.At(20, 19), kMaskDontCare) << "margin";
  EXPECT_EQ(mask.At(20, 20), kMaskBad);
}

TEST_F(ListJacquardTest, SaysWhatWasExpectedAndFound) {
  AddScene("", "0_a");
  AddScene("", "0_b");
  fs::remove(tree_ / "0_a_grasps.txt");
  WriteText("0_b_grasps.txt", "1;2;3;0;5\n");
  EXPECT_THROWS_MESSAGE(ListJacquard(tree_, {}),
                        Error,
                        AllOf(HasSubstr("no *_RGB.png with grasps in its *_grasps.txt"),
                              HasSubstr("found 2 pictures and 1 files of grasps"),
                              HasSubstr("0_a_RGB.png: left out: no *_grasps.txt beside it"),
                              HasSubstr("0_b_grasps.txt: left out: no usable rectangle in it")));
  EXPECT_THROWS_MESSAGE(ListJacquard(tree_ / "no", {}), Error, HasSubstr("cannot read the folder"));
  EXPECT_THROWS_MESSAGE(
      ListJacquard(tree_, {.good_share = 2}), Error, HasSubstr("good_share is 2"));
}

}  // namespace
}  // namespace handcraft::datasets
