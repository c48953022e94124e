// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/washington.h"

#include <cmath>
#include <numbers>
#include <string>

#include "datasets/importers/view_set_import.h"
#include "datasets/view_set_faults.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Pictures of 4 × 3, one metre away but for the first pixel.
class ListWashingtonTest : public ImporterTest {
 protected:
  void AddView(const std::string& name, const std::string& location = "319,239") const {
    WriteImage(name + "_crop.png", 4, 3);
    WriteImage(name + "_maskcrop.png", Image(4, 3, 1, 1));
    BasicImage<std::uint16_t> depth(4, 3, 1, 1000);
    depth.At(0, 0) = 0;
    perception::WritePng16(tree_ / (name + "_depthcrop.png"), depth);
    WriteText(name + "_loc.txt", location);
  }
  [[nodiscard]] std::string Refusal() const {
    try {
      ImportViews(ListWashington(tree_), out_, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "(nothing was thrown)";
  }
};

TEST_F(ListWashingtonTest, ReadsATree) {
  AddView("apple/apple_1/apple_1_1_1");
  AddView("apple/apple_1/apple_1_2_1");
  AddView("cereal_box/cereal_box_12/cereal_box_12_4_35");
  WriteText("apple/apple_1/apple_1_1_1_pose.txt", "-90.5\n");
  WriteText("apple/apple_1/apple_1_2_1_pose.txt", "360");
  WriteImage("apple/apple_1/apple_1_1_6_crop.png", 4, 3);  // the original lacks some masks
  fs::remove(tree_ / "apple/apple_1/apple_1_2_1_depthcrop.png");
  const SourceSet source = ListWashington(tree_);
  ASSERT_THAT(source.pictures, SizeIs(3));
  EXPECT_EQ(source.pictures[0].image, "apple/apple_1/apple_1_1_1_crop.png");
  EXPECT_EQ(source.pictures[0].object_class, "apple");
  EXPECT_EQ(source.pictures[0].instance, "apple_1");
  EXPECT_EQ(source.pictures[0].angle_deg, 269.5);
  EXPECT_EQ(source.pictures[1].angle_deg, 0.0);
  EXPECT_FALSE(source.pictures[1].make_cloud);
  EXPECT_EQ(source.pictures[2].object_class, "cereal_box");
  EXPECT_EQ(source.pictures[2].instance, "cereal_box_12");
  EXPECT_EQ(source.pictures[2].angle_deg, std::nullopt);
  ImportViews(source, out_, {});
  EXPECT_THAT(FindFaults(ReadViewSet(out_)), IsEmpty());
}

// As depthToCloud.m has it: column 2 of the crop (from 1) at x = 319 is column 320 of the picture,
// on the axis.
TEST_F(ListWashingtonTest, LevelsTheCloud) {
  AddView("a_1_9_1");
  AddView("a_1_1_1");
  const SourceSet source = ListWashington(tree_);
  const OrganisedCloud tilted = source.pictures[0].make_cloud(4, 3);
  EXPECT_FALSE(IsMeasured(tilted.At(0, 0)));
  const auto cosine = static_cast<float>(std::numbers::sqrt3 / 2);
  EXPECT_TRUE(tilted.At(1, 1).isApprox(Eigen::Vector3f(cosine, 0, -0.5F), 1e-6F)) << "30 degrees";
  const OrganisedCloud level = source.pictures[1].make_cloud(4, 3);
  EXPECT_TRUE(level.At(1, 1).isApprox(Eigen::Vector3f(1, 0, 0), 1e-6F));
  EXPECT_TRUE(level.At(2, 2).isApprox(Eigen::Vector3f(1, -1 / 570.3F, -1 / 570.3F), 1e-6F));
  EXPECT_FLOAT_EQ(tilted.base_from_camera.linear().determinant(), 1.0F);
}

TEST_F(ListWashingtonTest, RefusesWhatDoesNotFit) {
  AddView("a_1_1_1", "319");
  EXPECT_THAT(Refusal(), HasSubstr("a_1_1_1_loc.txt at byte 3: no number where \"x,y\""));
  WriteText("a_1_1_1_loc.txt", "319,239,1");
  EXPECT_THAT(Refusal(), HasSubstr("more than \"x,y\""));
  WriteText("a_1_1_1_loc.txt", "319,nan");
  EXPECT_THAT(Refusal(), HasSubstr("no number where"));
  WriteText("a_1_1_1_loc.txt", "1,1");
  perception::WritePng16(tree_ / "a_1_1_1_depthcrop.png", BasicImage<std::uint16_t>(3, 4));
  EXPECT_THAT(Refusal(), HasSubstr("the depth is 3x4 pixels, its picture 4x3"));
  WriteImage("a_1_1_1_depthcrop.png", 4, 3);
  EXPECT_THAT(Refusal(), HasSubstr("a_1_1_1_depthcrop.png"));
  fs::remove(tree_ / "a_1_1_1_maskcrop.png");
  EXPECT_THAT(Refusal(), HasSubstr("with a _maskcrop.png; found 3 files"));
}

}  // namespace
}  // namespace handcraft::datasets
