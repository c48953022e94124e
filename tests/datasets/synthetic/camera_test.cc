// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/camera.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using ::testing::HasSubstr;

TEST(PinholeCamera, LooksAlongItsAxisThroughTheMiddleOfThePicture) {
  const PinholeCamera camera;
  EXPECT_TRUE(camera.Ray(319.5F, 239.5F).isApprox(Vector3f::UnitZ()));
  EXPECT_TRUE(camera.Ray(319.5F + 525.0F, 239.5F).isApprox(Vector3f(1.0F, 0.0F, 1.0F)));
}

TEST(PinholeCamera, SeesAPointOfARayWhereTheRayBegan) {
  Rng rng = Rng::Stream(1, "rays");
  const auto draw = [&] { return static_cast<float>(rng.Uniform()); };
  for (int i = 0; i < 100; ++i) {
    PinholeCamera camera;
    camera.base_from_camera = LookAt(
        {1.0F + draw(), draw(), 0.2F + draw()}, {0.1F * draw(), draw(), 0.0F}, draw() - 0.5F);
    const Vector2f pixel(640.0F * draw(), 480.0F * draw());
    const float depth_m = 0.3F + draw();
    const Vector3f point = camera.Origin() + depth_m * camera.Ray(pixel.x(), pixel.y());
    EXPECT_TRUE(camera.Project(point).isApprox(pixel, 1e-3F)) << "single precision";
    EXPECT_NEAR((camera.base_from_camera.inverse() * point).z(), depth_m, 1e-5F);
  }
}

TEST(LookAt, PutsTheTargetInTheMiddleAndUpUpwards) {
  PinholeCamera camera;
  camera.base_from_camera = LookAt({0.5F, 0.3F, 0.6F}, {0.1F, -0.1F, 0.05F}, 0.0F);
  EXPECT_TRUE(camera.Project({0.1F, -0.1F, 0.05F}).isApprox(Vector2f(319.5F, 239.5F), 1e-4F));
  EXPECT_LT(camera.Project({0.1F, -0.1F, 0.15F}).y(), 239.5F);
  EXPECT_NEAR(camera.Project({0.1F, -0.1F, 0.15F}).x(), 319.5F, 1e-2F);
  EXPECT_NEAR(camera.base_from_camera.linear().determinant(), 1.0F, 1e-5F);
}

TEST(RightOf, ShiftsByTheDisparityOfTheDepth) {
  PinholeCamera left;
  left.base_from_camera = LookAt({0.5F, 0.3F, 0.6F}, {0.0F, 0.0F, 0.0F}, 0.1F);
  const PinholeCamera right = RightOf(left, 0.12F);
  const Vector3f point = left.Origin() + 0.7F * left.Ray(200.0F, 100.0F);
  EXPECT_NEAR(right.Project(point).x(), 200.0F - 525.0F * 0.12F / 0.7F, 1e-2F);
  EXPECT_NEAR(right.Project(point).y(), 100.0F, 1e-2F);
}

TEST(PinholeCamera, RefusesIntrinsicsOfNoCamera) {
  const auto refuses = [](const PinholeCamera& camera, const std::string& message) {
    EXPECT_THROWS_MESSAGE(camera.Validate(), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(PinholeCamera().Validate());
  refuses({.width_px = 15}, "PinholeCamera.width_px is 15; it must be from 16 to 4096");
  refuses({.height_px = 5000}, "PinholeCamera.height_px is 5000");
  refuses({.focal_px = 0.0F}, "PinholeCamera.focal_px is 0; it must be 1 or more");
  refuses({.focal_px = std::nanf("")}, "PinholeCamera.focal_px is nan");
  refuses({.centre_u_px = 6401.0F},
          "PinholeCamera.centre_u_px is 6401; it must be up to 6400, ten times");
  refuses({.centre_v_px = std::nanf("")}, "PinholeCamera.centre_v_px is nan");
}

}  // namespace
}  // namespace handcraft::synthetic
