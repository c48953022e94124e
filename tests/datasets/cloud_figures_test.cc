// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/cloud_figures.h"

#include <cstdint>
#include <limits>

#include "lib/core/error.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

// Views "a" and "c" of the small set with true depth: 0.6 m everywhere but for the first pixel,
// which has none.
class CompareCloudsTest : public ::testing::Test {
 protected:
  CompareCloudsTest() {
    set_ = testing::MakeViewSet(folder_.path());
    set_.items.erase(set_.items.begin() + 1);
    BasicImage<std::uint16_t> depth(8, 6, 1, 600);
    depth.At(0, 0) = 0;
    for (ObjectView& view : set_.items) {
      view.depth = view.instance + "_depth.png";
      perception::WritePng16(folder_ / view.depth, depth);
      SetDepths(view, {});
    }
  }

  // Writes a cloud 0.6 m away but for the object's pixels from the second on, in order of rows.
  void SetDepths(const ObjectView& view, const std::vector<float>& depths_m) const {
    OrganisedCloud cloud = testing::FlatCloud(8, 6);
    for (Eigen::Vector3f& point : cloud.points) point.z() = 0.6F;
    for (std::size_t i = 0; i < depths_m.size(); ++i) {
      const std::size_t nth = i + 1;
      cloud.points[nth / 4 * 8 + nth % 4].z() = depths_m[i];
    }
    WritePcd(folder_ / view.cloud, cloud);
  }

  TemporaryDirectory folder_;
  ViewSet set_;
};

TEST_F(CompareCloudsTest, CountsByHand) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  // Of 23 pixels with a depth 3 are not measured and 20 are; 10 errors are 0, and so is the 10th.
  SetDepths(
      set_.items[0],
      {nan, nan, nan, 0.601F, 0.602F, 0.603F, 0.604F, 0.605F, 0.594F, 0.593F, 0.592F, 0.63F, 0.5F});
  const std::vector<CloudFigures> figures = CompareClouds(set_, 2, {});
  ASSERT_EQ(figures.size(), 3U);
  const CloudFigures& mug = figures[0];
  EXPECT_EQ(mug.object_class, "mug");
  EXPECT_EQ(mug.num_views, 1U);
  EXPECT_EQ(mug.num_pixels, 23U);
  EXPECT_EQ(mug.num_measured, 20U);
  EXPECT_NEAR(mug.median_error_m, 0.0, 1e-6);
  EXPECT_NEAR(mug.percentile90_error_m, 0.008, 1e-6) << "the 18th of 20";
  EXPECT_DOUBLE_EQ(mug.share_beyond, 0.1);
  EXPECT_EQ(figures[1].object_class, "can");
  EXPECT_EQ(figures[1].num_measured, 23U);
  EXPECT_NEAR(figures[1].percentile90_error_m, 0.0, 1e-6);
  EXPECT_EQ(figures[2].object_class, "");
  EXPECT_EQ(figures[2].num_views, 2U);
  EXPECT_EQ(figures[2].num_measured, 43U);
  EXPECT_DOUBLE_EQ(figures[2].share_beyond, 2.0 / 43.0);
}

TEST_F(CompareCloudsTest, SaysNothingOfErrorsWhereNothingIsMeasured) {
  SetDepths(set_.items[0], std::vector<float>(23, std::numeric_limits<float>::quiet_NaN()));
  const CloudFigures mug = CompareClouds(set_, 1, {})[0];
  EXPECT_EQ(mug.num_pixels, 23U);
  EXPECT_EQ(mug.num_measured, 0U);
  EXPECT_EQ(mug.median_error_m, 0.0);
}

TEST_F(CompareCloudsTest, TellsTexturedGroundApart) {
  // A step between columns 4 and 5 has gradients of half its height at both; of the object's
  // columns 0 to 3 the windows of 2 (√(20² / 5) gray levels) and of 3 (√(2 · 20² / 5)) reach it.
  const auto write_step = [&](std::uint8_t height) {
    Image picture(8, 6);
    for (int v = 0; v < 6; ++v) {
      for (int u = 5; u < 8; ++u) picture.At(u, v) = height;
    }
    perception::WritePng(folder_ / set_.items[0].image, picture);
  };
  std::vector<float> depths_m;
  for (int nth = 1; nth < 24; ++nth) depths_m.push_back(nth % 4 < 2 ? 0.61F : 0.604F);
  SetDepths(set_.items[0], depths_m);
  write_step(40);
  const CloudFigures mug = CompareClouds(set_, 1, {})[0];
  EXPECT_EQ(mug.num_textured, 12U);
  EXPECT_NEAR(mug.textured_median_error_m, 0.004, 1e-6);
  EXPECT_NEAR(mug.percentile90_error_m, 0.01, 1e-6);

  write_step(9);  // √(2 · 4.5² / 5) = 2.8 at column 3
  const CloudFigures bare = CompareClouds(set_, 1, {})[0];
  EXPECT_EQ(bare.num_textured, 0U);
  EXPECT_EQ(bare.textured_median_error_m, 0.0);
}

TEST_F(CompareCloudsTest, NeedsCloudAndDepthOfOneSize) {
  const auto refuses = [&](const std::string& message) {
    EXPECT_THROWS_MESSAGE(CompareClouds(set_, 1, {}), Error, HasSubstr(message));
  };
  perception::WritePng16(folder_ / set_.items[1].depth, BasicImage<std::uint16_t>(6, 8, 1, 600));
  refuses("can_0_depth.png: the depth is 6x8 pixels, its picture 8x6");
  set_.items[1].depth.clear();
  refuses("views.csv: 'c.png' has no true depth");
  set_.items[0].cloud.clear();
  refuses("views.csv: 'a.png' has no cloud");
}

}  // namespace
}  // namespace handcraft::datasets
