// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/robot_table.h"

#include <cmath>

#include "datasets/synthetic/loft.h"
#include "datasets/synthetic/scene_parts.h"
#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;
using ::testing::HasSubstr;

Object Can() { return {.mesh = RoundedBox({0.1F, 0.1F, 0.2F}, 0.005F, {}), .materials = {{}}}; }

TEST(RobotCameraPose, LooksForwardAndDownAtTheOrigin) {
  PinholeCamera camera;
  camera.base_from_camera = RobotCameraPose();
  EXPECT_LT(camera.Origin().x(), 0.0F) << "the robot stands on the -x side";
  EXPECT_NEAR(camera.Project({0.0F, 0.0F, 0.08F}).x(), 319.5F, 1e-2F);
  EXPECT_NEAR((camera.base_from_camera.inverse() * Vector3f(0.0F, 0.0F, 0.08F)).z(), 0.622F, 1e-3F);
  EXPECT_LT(camera.Project({0.0F, 0.1F, 0.0F}).x(), 319.5F) << "left is +y";
}

TEST(DrawRobotTable, HasATableUnderEveryPlaceAndNothingThickOnIt) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    Rng rng = Rng::Stream(1, "table", i);
    const Scene scene = DrawRobotTable({.focal_px = 500.0F}, rng);
    EXPECT_EQ(scene.camera.focal_px, 500.0F);
    const PlacedObject& table = scene.objects[0];
    const Eigen::AlignedBox3f top = Bounds(table.object.mesh);
    for (const float x : {-0.2F, 0.2F}) {
      for (const float y : {-0.32F, 0.32F}) {
        const Vector3f at = table.base_from_object.inverse() * Vector3f(x, y, -0.01F);
        EXPECT_TRUE(top.contains(at)) << i;
      }
    }
    for (std::size_t thing = 6; thing < scene.objects.size(); ++thing) {
      EXPECT_LT(Bounds(scene.objects[thing].object.mesh).max().z(), kThinM);
      EXPECT_FALSE(scene.objects[thing].is_target);
    }
  }
}

TEST(DrawNear, HasTheDeviationAsked) {
  double squares_m = 0.0;
  double squares_rad = 0.0;
  constexpr int kDraws = 4000;
  for (std::uint64_t i = 0; i < kDraws; ++i) {
    Rng rng = Rng::Stream(1, "camera", i);
    const Eigen::Isometry3f pose = DrawNear(RobotCameraPose(), {0.01F, 1.0F}, rng);
    squares_m +=
        static_cast<double>((pose.translation() - RobotCameraPose().translation()).squaredNorm());
    const Eigen::AngleAxisf turned(RobotCameraPose().linear().transpose() * pose.linear());
    squares_rad += static_cast<double>(turned.angle()) * static_cast<double>(turned.angle());
  }
  EXPECT_NEAR(std::sqrt(squares_m / kDraws / 3.0), 0.01, 0.0004);
  EXPECT_NEAR(std::sqrt(squares_rad / kDraws / 3.0) * 57.29578, 1.0, 0.04);
  Rng rng = Rng::Stream(1, "camera");
  EXPECT_TRUE(DrawNear(RobotCameraPose(), {}, rng).isApprox(RobotCameraPose()));
}

TEST(IsSeenWhole, AsksForEveryVertex) {
  PinholeCamera camera;
  camera.base_from_camera = RobotCameraPose();
  const Mesh mesh = Can().mesh;
  EXPECT_TRUE(IsSeenWhole(mesh, UprightPose(Vector3f::Zero(), 0.3F), camera));
  EXPECT_FALSE(IsSeenWhole(mesh, UprightPose({0.0F, 0.35F, 0.0F}, 0.3F), camera)) << "cut";
  EXPECT_FALSE(IsSeenWhole(mesh, UprightPose({-0.3F, 0.0F, 0.0F}, 0.3F), camera)) << "too near";
  EXPECT_FALSE(IsSeenWhole(mesh, UprightPose({-2.0F, 0.0F, 0.0F}, 0.3F), camera)) << "behind";
}

TEST(DrawMoved, StaysWithinReachAndView) {
  PinholeCamera camera;
  camera.base_from_camera = RobotCameraPose();
  float least = 2.0F;
  float most = 0.0F;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = Rng::Stream(1, "place", i);
    const MovedObject moved = DrawMoved(Can(), camera, rng);
    EXPECT_TRUE(IsSeenWhole(moved.object.mesh, moved.base_from_object, camera));
    const Vector3f at = moved.base_from_object.translation();
    EXPECT_LE(std::abs(at.x()), 0.1F);
    EXPECT_LE(std::abs(at.y()), 0.22F);
    EXPECT_EQ(at.z(), 0.0F);
    EXPECT_NEAR(Bounds(moved.object.mesh).max().z(), 0.2F * moved.scale, 1e-5F);
    EXPECT_TRUE(moved.angle_deg >= 0.0 && moved.angle_deg < 360.0);
    const float yaw_rad = static_cast<float>(moved.angle_deg) / 57.29578F;
    EXPECT_TRUE(moved.base_from_object.linear().isApprox(UprightPose(at, yaw_rad).linear(), 1e-4F));
    least = std::min(least, moved.scale);
    most = std::max(most, moved.scale);
  }
  EXPECT_NEAR(least, 0.8F, 0.02F);
  EXPECT_NEAR(most, 1.25F, 0.02F);
}

TEST(DrawMoved, GivesUpOnALensTooLong) {
  PinholeCamera camera{.focal_px = 4000.0F};
  camera.base_from_camera = RobotCameraPose();
  Rng rng = Rng::Stream(1, "place");
  EXPECT_THROWS_MESSAGE(
      DrawMoved(Can(), camera, rng), Error, HasSubstr("does not see an object on the table whole"));
}

}  // namespace
}  // namespace handcraft::synthetic
