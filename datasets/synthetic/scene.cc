// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/scene_parts.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;

void PlaceTargets(Scene& scene, std::span<const Object> targets, Rng& rng) {
  const Vector2f apart = DrawDirection(rng);
  float taken_m = 0.0F;
  std::vector<float> offsets_m;
  for (const Object& target : targets) {
    const float radius_m = FootprintRadius(target);
    offsets_m.push_back(taken_m + radius_m);
    taken_m += 2.0F * radius_m + Between(rng, 0.01F, 0.06F);
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Vector2f at = (offsets_m[i] - 0.5F * taken_m) * apart;
    const Eigen::Isometry3f pose =
        UprightPose({at.x(), at.y(), 0.0F}, Between(rng, 0.0F, 2.0F * kPi));
    scene.objects.push_back({targets[i], pose, true});
  }
}

// Thin things may lie anywhere, under the targets too; thick ones beside them and each other.
void AddFlatThings(Scene& scene, float targets_radius_m, Rng& rng) {
  const std::uint64_t count = rng.UniformInt(6);
  std::vector<Eigen::Vector3f> thick;  // place and radius
  for (std::uint64_t i = 0; i < count; ++i) {
    Object thing = DrawFlatThing(rng);
    const bool is_thin = Bounds(thing.mesh).sizes().z() < kThinM;
    const float radius_m = FootprintRadius(thing);
    const float beside_m = targets_radius_m + radius_m;
    const Vector2f at =
        DrawDirection(rng) * Between(rng, is_thin ? 0.0F : beside_m, beside_m + 0.1F);
    const float yaw_rad = Between(rng, 0.0F, 2.0F * kPi);
    const auto touches = [&](const Vector3f& other) {
      return (at - other.head<2>()).norm() < radius_m + other.z();
    };
    if (!is_thin && std::any_of(thick.begin(), thick.end(), touches)) continue;
    if (!is_thin) thick.emplace_back(at.x(), at.y(), radius_m);
    // No two tops at the same height: where sheets overlap, one is seen.
    const float lift_m = 0.0001F * static_cast<float>(i);
    scene.objects.push_back({std::move(thing), UprightPose({at.x(), at.y(), lift_m}, yaw_rad)});
  }
}

void DrawCamera(Scene& scene, float targets_radius_m, Rng& rng) {
  const float distance_m =
      std::clamp(5.0F * targets_radius_m, 0.36F, 0.9F) * Between(rng, 0.85F, 1.25F);
  const float elevation_rad = Between(rng, 0.4F, 1.15F);
  const Vector2f azimuth = DrawDirection(rng);
  const float spread_m = 0.12F * distance_m;
  const Vector3f to_m(Between(rng, -spread_m, spread_m), Between(rng, -spread_m, spread_m), 0.03F);
  const Vector3f from_m = to_m + distance_m * Vector3f(std::cos(elevation_rad) * azimuth.x(),
                                                       std::cos(elevation_rad) * azimuth.y(),
                                                       std::sin(elevation_rad));
  scene.camera.base_from_camera = LookAt(from_m, to_m, Between(rng, -0.06F, 0.06F));
}

}  // namespace

Scene DrawScene(std::span<const Object> targets, Rng& rng) {
  Scene scene;
  AddRoom(scene, 1.0F, rng);
  PlaceTargets(scene, targets, rng);
  float targets_radius_m = 0.0F;
  for (const PlacedObject& placed : scene.objects) {
    if (!placed.is_target) continue;
    const Vector3f extent = Bounds(placed.object.mesh).max();
    const float around_m = std::max(FootprintRadius(placed.object), 0.6F * extent.z());
    targets_radius_m =
        std::max(targets_radius_m, placed.base_from_object.translation().norm() + around_m);
  }
  AddFlatThings(scene, targets_radius_m, rng);
  DrawLight(scene, rng);
  DrawCamera(scene, targets_radius_m, rng);
  scene.sensor = DrawSensor(rng);
  return scene;
}

void MakeBare(Scene& scene) {
  // DrawScene puts the room first, then the targets.
  const auto is_target = [](const PlacedObject& placed) { return placed.is_target; };
  const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), is_target);
  scene.objects.erase(
      std::remove_if(
          first, scene.objects.end(), [&](const auto& placed) { return !is_target(placed); }),
      scene.objects.end());
  for (PlacedObject& placed : scene.objects) {
    if (placed.is_target) continue;
    for (Material& material : placed.object.materials) material.pattern = Pattern::kPlain;
  }
}

}  // namespace handcraft::synthetic
