// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/robot_table.h"

#include <algorithm>
#include <numbers>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/scene_parts.h"
#include "lib/core/error.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

constexpr float kRadPerDeg = std::numbers::pi_v<float> / 180.0F;
constexpr float kTableScale = 1.8F;  // every place within reach lies on it
constexpr float kThingsWithinM = 0.4F;
constexpr float kMarginPx = 2.0F;
constexpr float kNearestM = 0.4F;
constexpr int kMaxDraws = 1000;

void AddThinThings(Scene& scene, Rng& rng) {
  const std::uint64_t count = rng.UniformInt(6);
  for (std::uint64_t i = 0; i < count; ++i) {
    Object thing = DrawFlatThing(rng);
    const Eigen::Vector2f at = DrawDirection(rng) * Between(rng, 0.0F, kThingsWithinM);
    const float yaw_rad = Between(rng, 0.0F, 360.0F) * kRadPerDeg;
    if (Bounds(thing.mesh).sizes().z() >= kThinM) continue;
    // No two tops at the same height: where sheets overlap, one is seen.
    const float lift_m = 0.0001F * static_cast<float>(i);
    scene.objects.push_back({std::move(thing), UprightPose({at.x(), at.y(), lift_m}, yaw_rad)});
  }
}

}  // namespace

Eigen::Isometry3f RobotCameraPose() {
  return LookAt({-0.5F, 0.0F, 0.45F}, {0.0F, 0.0F, 0.08F}, 0.0F);
}

Scene DrawRobotTable(const PinholeCamera& lens, Rng& rng) {
  Scene scene;
  AddRoom(scene, kTableScale, rng);
  AddThinThings(scene, rng);
  DrawLight(scene, rng);
  scene.sensor = DrawSensor(rng);
  scene.camera = lens;
  scene.camera.base_from_camera = RobotCameraPose();
  return scene;
}

Eigen::Isometry3f DrawNear(const Eigen::Isometry3f& base_from_camera,
                           const CameraNoise& noise,
                           Rng& rng) {
  Eigen::Isometry3f moved = base_from_camera;
  for (int axis = 0; axis < 3; ++axis) {
    moved.translation()[axis] += noise.position_m * static_cast<float>(rng.Normal());
  }
  for (int axis = 0; axis < 3; ++axis) {
    const float angle_rad = noise.angle_deg * kRadPerDeg * static_cast<float>(rng.Normal());
    moved.rotate(Eigen::AngleAxisf(angle_rad, Vector3f::Unit(axis)));
  }
  return moved;
}

bool IsSeenWhole(const Mesh& mesh,
                 const Eigen::Isometry3f& base_from_object,
                 const PinholeCamera& camera) {
  const Eigen::Isometry3f camera_from_object = camera.base_from_camera.inverse() * base_from_object;
  const Eigen::Vector2f last(static_cast<float>(camera.width_px - 1),
                             static_cast<float>(camera.height_px - 1));
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vector3f& vertex) {
    if ((camera_from_object * vertex).z() < kNearestM) return false;
    const Eigen::Vector2f at = camera.Project(base_from_object * vertex);
    return at.minCoeff() >= kMarginPx && (last - at).minCoeff() >= kMarginPx;
  });
}

MovedObject DrawMoved(const Object& object, const PinholeCamera& camera, Rng& rng) {
  for (int i = 0; i < kMaxDraws; ++i) {
    MovedObject moved{.object = object};
    const Vector3f at_m(Between(rng, -0.1F, 0.1F), Between(rng, -0.22F, 0.22F), 0.0F);
    moved.angle_deg = static_cast<double>(rng.UniformInt(36000)) / 100.0;
    moved.scale = Between(rng, 0.8F, 1.25F);
    moved.base_from_object = UprightPose(at_m, static_cast<float>(moved.angle_deg) * kRadPerDeg);
    for (Vector3f& vertex : moved.object.mesh.vertices) vertex *= moved.scale;
    if (IsSeenWhole(moved.object.mesh, moved.base_from_object, camera)) return moved;
  }
  throw Error({.kind = Error::Kind::kUsage,
               .reason = "the camera does not see an object on the table whole",
               .remedy = "give a camera with a wider view"});
}

}  // namespace handcraft::synthetic
