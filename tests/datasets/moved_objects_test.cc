// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/moved_objects.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;

// What a camera at the origin that looks along x sees of an upright board, 0.2 m broad and high,
// 0.5 m in front of it, bent so that the fit is of a plane no more than of a line.
MaskedCloud Board(const Eigen::Vector3f& middle, float half) {
  constexpr int kSide = 100;
  MaskedCloud object{.cloud = {.width = kSide, .height = kSide}, .mask = Image(kSide, kSide)};
  Eigen::Matrix3f base_from_camera;
  base_from_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  object.cloud.base_from_camera.linear() = base_from_camera;
  for (int v = 0; v < kSide; ++v) {
    for (int u = 0; u < kSide; ++u) {
      const float x = (static_cast<float>(u) - 49.5F) / 100.0F;  // focal length 100 px
      const float y = (static_cast<float>(v) - 49.5F) / 100.0F;
      const Eigen::Vector3f p = middle.x() * Eigen::Vector3f(1.0F, -x, -y);
      object.cloud.points.push_back(p);
      const bool is_inside =
          std::fabs(p.y() - middle.y()) <= half && std::fabs(p.z() - middle.z()) <= half;
      object.mask.At(u, v) = is_inside ? 255 : 0;
    }
  }
  return object;
}

Eigen::Vector3f MeanOf(const MaskedCloud& object) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float count = 0.0F;
  for (int v = 0; v < object.cloud.height; ++v) {
    for (int u = 0; u < object.cloud.width; ++u) {
      if (!object.View().Has(u, v)) continue;
      sum += object.cloud.At(u, v);
      count += 1.0F;
    }
  }
  return sum / count;
}

TEST(MovedObjects, NotMovedIsTheSameInItsBox) {
  const MaskedCloud board = Board({0.5F, 0.0F, 0.0F}, 0.1F);
  const MaskedCloud same = MoveObject(board, {});
  const features::PixelExtent box = features::FindExtent(board.View());
  ASSERT_EQ(same.cloud.width, box.Width());
  ASSERT_EQ(same.cloud.height, box.Height());
  for (int v = 0; v < box.Height(); ++v) {
    for (int u = 0; u < box.Width(); ++u) {
      EXPECT_TRUE(
          same.cloud.At(u, v).isApprox(board.cloud.At(u + box.u_begin, v + box.v_begin), 1e-5F));
    }
  }
}

TEST(MovedObjects, TwiceAsFarIsHalfAsLargeInThePicture) {
  const MaskedCloud far =
      MoveObject(Board({0.5F, 0.0F, 0.0F}, 0.1F), {.shift_m = Eigen::Vector3f(0.5F, 0.0F, 0.0F)});
  EXPECT_NEAR(far.cloud.width, 20, 1);
  EXPECT_NEAR(far.cloud.height, 20, 1);
  EXPECT_NEAR(MeanOf(far).x(), 1.0F, 1e-5F);
}

TEST(MovedObjects, GrowsAboutItsFoot) {
  const MaskedCloud grown = MoveObject(Board({0.5F, 0.0F, 0.0F}, 0.1F), {.scale = 1.5F});
  EXPECT_NEAR(grown.cloud.width, 60, 2);
  EXPECT_NEAR(MeanOf(grown).y(), 0.0F, 2e-3F);
  EXPECT_NEAR(MeanOf(grown).z(), 0.05F, 5e-3F);  // the foot stayed at −0.1
}

// As if it had been measured there.
TEST(MovedObjects, IsSeenWhereACameraWouldSeeIt) {
  const MaskedCloud there = Board({0.5F, 0.06F, 0.04F}, 0.1F);
  const MaskedCloud moved =
      MoveObject(Board({0.5F, 0.0F, 0.0F}, 0.1F), {.shift_m = Eigen::Vector3f(0.0F, 0.06F, 0.04F)});
  EXPECT_NEAR(moved.cloud.width, features::FindExtent(there.View()).Width(), 1);
  EXPECT_TRUE(MeanOf(moved).isApprox(MeanOf(there), 1e-2F));
}

TEST(MovedObjects, PixelsThatNoCameraExplainsAreRefused) {
  MaskedCloud flat{.cloud = handcraft::testing::FlatCloud(8, 6), .mask = Image(8, 6, 1, 255)};
  EXPECT_THROWS_MESSAGE(static_cast<void>(MoveObject(flat, {})),
                        Error,
                        HasSubstr("not seen from its VIEWPOINT at their pixels"));
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(MoveObject(Board({0.5F, 0.0F, 0.0F}, 0.1F),
                                   {.shift_m = Eigen::Vector3f(-0.6F, 0.0F, 0.0F)})),
      Error,
      HasSubstr("cannot be moved"));
}

TEST(MovedObjects, CopiesDependOnSeedViewAndNumberAlone) {
  const TemporaryDirectory folder;
  ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  const MaskedCloud board = Board({0.5F, 0.0F, 0.0F}, 0.1F);
  for (const char* name : {"a", "c"}) {
    WritePcd(folder / (std::string(name) + ".pcd"), board.cloud);
    perception::WritePng(folder / (std::string(name) + "_mask.png"), board.mask);
  }
  set.items.erase(set.items.begin() + 1);
  const features::CloudDescriptor descriptor{.grid_size = 4};
  MovedCopyOptions options{.num_copies = 2};
  const CloudFeatures one = DescribeMovedCopies(set, descriptor, {}, options);
  EXPECT_EQ(one.num_views, 4U);
  EXPECT_EQ(DescribeMovedCopies(set, descriptor, {}, options, 2).values, one.values);
  options.seed = 2;
  EXPECT_NE(DescribeMovedCopies(set, descriptor, {}, options).values, one.values);
}

TEST(MovedObjects, TheViewThatCannotBeMovedIsNamed) {
  const TemporaryDirectory folder;
  ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  set.items.resize(1);
  EXPECT_THROWS_MESSAGE(static_cast<void>(DescribeMovedCopies(set, {}, {}, {.num_copies = 1})),
                        Error,
                        AllOf(HasSubstr("a.pcd"), HasSubstr("no moved copies")));
}

TEST(MovedObjects, OptionsAreChecked) {
  EXPECT_NO_THROW(MovedCopyOptions().Validate());
  EXPECT_THROWS_MESSAGE(
      (MovedCopyOptions{.num_copies = -1}).Validate(), Error, HasSubstr("num_copies is -1"));
  EXPECT_THROWS_MESSAGE(
      (MovedCopyOptions{.least_scale = 0.0}).Validate(), Error, HasSubstr("least_scale"));
  EXPECT_THROWS_MESSAGE(
      (MovedCopyOptions{.greatest_scale = 0.9}).Validate(), Error, HasSubstr("greatest_scale"));
  EXPECT_THROWS_MESSAGE(
      (MovedCopyOptions{.sideways_m = -1.0}).Validate(), Error, HasSubstr("sideways_m"));
}

}  // namespace
}  // namespace handcraft::datasets
