// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/depth_cloud.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/datasets/synthetic/small_scene.h"

namespace handcraft::synthetic {
namespace {

TEST(CloudFromDepth, PutsAPlaneByHand) {
  PinholeCamera camera{
      .width_px = 3, .height_px = 2, .focal_px = 10.0F, .centre_u_px = 1.0F, .centre_v_px = 0.0F};
  camera.base_from_camera.translation() = Eigen::Vector3f(0.5F, 0.0F, -1.0F);
  FloatImage depth(3, 2, 1, 2.0F);
  depth.At(0, 0) = 0.0F;
  depth.At(1, 0) = std::numeric_limits<float>::infinity();
  depth.At(2, 0) = std::numeric_limits<float>::quiet_NaN();
  const datasets::OrganisedCloud cloud = CloudFromDepth(depth, camera);
  for (int u = 0; u < 3; ++u) EXPECT_FALSE(datasets::IsMeasured(cloud.At(u, 0))) << u;
  EXPECT_TRUE(cloud.At(0, 1).isApprox(Eigen::Vector3f(0.3F, 0.2F, 1.0F)));
  EXPECT_TRUE(cloud.At(2, 1).isApprox(Eigen::Vector3f(0.7F, 0.2F, 1.0F)));
  EXPECT_TRUE(cloud.base_from_camera.isApprox(camera.base_from_camera));
}

TEST(CloudFromDepth, PutsThePointsBackOnTheirPixels) {
  const Scene scene = testing::SmallScene();
  const FloatImage depth(160, 120, 1, 0.8F);
  const datasets::OrganisedCloud cloud = CloudFromDepth(depth, scene.camera);
  for (int v = 0; v < 120; v += 7) {
    for (int u = 0; u < 160; u += 7) {
      const Eigen::Vector2f seen = scene.camera.Project(cloud.At(u, v));
      EXPECT_NEAR(seen.x(), static_cast<float>(u), 1e-2F);
      EXPECT_NEAR(seen.y(), static_cast<float>(v), 1e-2F);
    }
  }
}

}  // namespace
}  // namespace handcraft::synthetic
