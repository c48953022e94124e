// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/depth_cloud.h"

#include <numbers>

#include <gtest/gtest.h>

namespace handcraft::datasets {
namespace {

TEST(CloudOfDepth, PutsPointsOnTheirRays) {
  BasicImage<std::uint16_t> depth(3, 2);
  depth.At(1, 0) = 500;
  depth.At(2, 1) = 1000;
  const OrganisedCloud cloud =
      CloudOfDepth(depth, 0.001, {100, 50, 1, 0}, Eigen::Isometry3d::Identity());
  EXPECT_EQ(cloud.width, 3);
  EXPECT_EQ(cloud.height, 2);
  ASSERT_EQ(cloud.points.size(), 6U);
  EXPECT_FALSE(IsMeasured(cloud.At(0, 0)));
  EXPECT_TRUE(cloud.At(1, 0).isApprox(Eigen::Vector3f(0, 0, 0.5F)));
  EXPECT_TRUE(cloud.At(2, 1).isApprox(Eigen::Vector3f(0.01F, 0.02F, 1)));
}

TEST(CloudOfDepth, PutsPointsIntoTheBaseFrame) {
  BasicImage<std::uint16_t> depth(1, 1, 1, 20);
  Eigen::Isometry3d base_from_camera = Eigen::Isometry3d::Identity();
  base_from_camera.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  base_from_camera.translation() << 1, 2, 3;
  const OrganisedCloud cloud = CloudOfDepth(depth, 0.1, {1, 1, 0, 0}, base_from_camera);
  EXPECT_TRUE(cloud.At(0, 0).isApprox(Eigen::Vector3f(1, 0, 3), 1e-6F));
  EXPECT_TRUE(cloud.base_from_camera.isApprox(base_from_camera.cast<float>()));
}

}  // namespace
}  // namespace handcraft::datasets
