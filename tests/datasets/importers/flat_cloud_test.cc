// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/flat_cloud.h"

#include <gmock/gmock.h>

namespace handcraft::datasets {
namespace {

TEST(FlatCloudOf, PutsThePixelsOfTheMaskAMillimetreApartOneMetreAhead) {
  Image mask(3, 2);
  mask.At(0, 0) = 255;
  mask.At(2, 1) = 1;
  const OrganisedCloud cloud = FlatCloudOf(mask);
  ASSERT_EQ(cloud.points.size(), 6U);
  EXPECT_TRUE(cloud.At(0, 0).isApprox(Eigen::Vector3f(1, 0.001F, 0.0005F), 1e-6F));
  EXPECT_TRUE(cloud.At(2, 1).isApprox(Eigen::Vector3f(1, -0.001F, -0.0005F), 1e-6F));
  EXPECT_FALSE(IsMeasured(cloud.At(1, 0)));
  EXPECT_TRUE((cloud.base_from_camera * Eigen::Vector3f(-0.001F, -0.0005F, 1))
                  .isApprox(cloud.At(0, 0), 1e-6F));
}

TEST(FlatCloudOf, TakesAnEmptyMask) {
  const OrganisedCloud cloud = FlatCloudOf(Image(2, 2));
  for (const Eigen::Vector3f& point : cloud.points) EXPECT_FALSE(IsMeasured(point));
  EXPECT_THAT(FlatCloudOf(Image()).points, ::testing::IsEmpty());
}

TEST(AddFlatClouds, LeavesMeasuredClouds) {
  SourceSet source;
  source.pictures.resize(2);
  for (SourcePicture& picture : source.pictures) {
    picture.make_mask = [](int width, int height) { return Image(width, height, 1, 255); };
  }
  source.pictures[1].make_cloud = [](int, int) { return OrganisedCloud{.width = 7}; };
  AddFlatClouds(source);
  EXPECT_TRUE(IsMeasured(source.pictures[0].make_cloud(2, 1).At(1, 0)));
  EXPECT_EQ(source.pictures[1].make_cloud(2, 1).width, 7);
}

}  // namespace
}  // namespace handcraft::datasets
