// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/cloud_camera.h"

#include <limits>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using Eigen::Vector3f;
using ::testing::HasSubstr;

synthetic::PinholeCamera SmallCamera() {
  return {.width_px = 32,
          .height_px = 24,
          .focal_px = 30.0F,
          .centre_u_px = 14.0F,
          .centre_v_px = 12.5F,
          .base_from_camera = synthetic::LookAt({-0.5F, 0.1F, 0.4F}, {0.1F, 0.0F, 0.0F}, 0.05F)};
}

// What the camera sees of points at drawn depths, `noise_px` off, every third one missing.
OrganisedCloud DrawCloud(const synthetic::PinholeCamera& camera, float noise_px) {
  OrganisedCloud cloud{.width = camera.width_px, .height = camera.height_px};
  cloud.base_from_camera = camera.base_from_camera;
  Rng rng = Rng::Stream(1, "cloud");
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      const float u_px = static_cast<float>(u) + noise_px * static_cast<float>(rng.Normal());
      const float v_px = static_cast<float>(v) + noise_px * static_cast<float>(rng.Normal());
      const auto depth_m = static_cast<float>(0.5 + rng.Uniform());
      const Vector3f point = camera.Origin() + depth_m * camera.Ray(u_px, v_px);
      const bool is_missing = (u + v) % 3 == 0;
      cloud.points.push_back(
          is_missing ? Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()) : point);
    }
  }
  return cloud;
}

TEST(FitCamera, FindsTheCameraOfAnExactCloud) {
  const synthetic::PinholeCamera camera = SmallCamera();
  const synthetic::PinholeCamera fitted = FitCamera(DrawCloud(camera, 0.0F));
  EXPECT_EQ(fitted.width_px, 32);
  EXPECT_EQ(fitted.height_px, 24);
  EXPECT_NEAR(fitted.focal_px, camera.focal_px, 1e-3F);
  EXPECT_NEAR(fitted.centre_u_px, camera.centre_u_px, 1e-3F);
  EXPECT_NEAR(fitted.centre_v_px, camera.centre_v_px, 1e-3F);
  const Vector3f point(0.2F, 0.1F, 0.1F);
  EXPECT_TRUE(fitted.Project(point).isApprox(camera.Project(point), 1e-4F));
}

TEST(FitCamera, AveragesNoiseOut) {
  const synthetic::PinholeCamera camera = SmallCamera();
  const synthetic::PinholeCamera fitted = FitCamera(DrawCloud(camera, 0.5F));
  // 512 points of half a pixel: the centre to 0.5 / √512 = 0.02, the focal length to 0.5 / √(1024 ·
  // 0.06), as the mean square of x / z and y / z is 0.06.
  EXPECT_NEAR(fitted.centre_u_px, camera.centre_u_px, 0.1F);
  EXPECT_NEAR(fitted.focal_px, camera.focal_px, 0.3F);
}

TEST(FitCamera, SaysWhatIsWrongWithACloud) {
  EXPECT_THROWS_MESSAGE(FitCamera({}), Error, HasSubstr("the cloud has 0 points in front"));
  OrganisedCloud behind = DrawCloud(SmallCamera(), 0.0F);
  behind.base_from_camera.linear().col(0) *= -1.0F;
  behind.base_from_camera.linear().col(2) *= -1.0F;
  EXPECT_THROWS_MESSAGE(FitCamera(behind), Error, HasSubstr("0 points in front of its camera"));
  OrganisedCloud one_direction{.width = 20, .height = 1};
  one_direction.points.assign(20, Vector3f(0.0F, 0.0F, 1.0F));
  EXPECT_THROWS_MESSAGE(FitCamera(one_direction), Error, HasSubstr("lie in one direction"));
  EXPECT_THROWS_MESSAGE(FitCamera(DrawCloud(SmallCamera(), 5.0F)),
                        Error,
                        HasSubstr("pixels from where a pinhole camera sees them"));
}

}  // namespace
}  // namespace handcraft::datasets
