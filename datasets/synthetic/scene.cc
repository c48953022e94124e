// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/loft.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kTableThicknessM = 0.03F;
constexpr float kFloorM = -0.74F;
constexpr float kRoomM = 2.8F;  // from the middle to a wall

Vector2f DrawDirection(Rng& rng) {
  const float angle_rad = Between(rng, 0.0F, 2.0F * kPi);
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Eigen::Isometry3f Pose(const Vector3f& at_m, float yaw_rad) {
  return Eigen::Translation3f(at_m) *
         Eigen::Isometry3f(Eigen::AngleAxisf(yaw_rad, Vector3f::UnitZ()));
}

// Distance from the z axis to the farthest vertex.
float Footprint(const Object& object) {
  float radius_m = 0.0F;
  for (const Vector3f& vertex : object.mesh.vertices) {
    radius_m = std::max(radius_m, vertex.head<2>().norm());
  }
  return radius_m;
}

Object Box(const Vector3f& size_m, float radius_m, const Material& material) {
  return {.mesh = RoundedBox(size_m, radius_m, {}), .materials = {material}};
}

void AddRoom(Scene& scene, Rng& rng) {
  const Vector3f table_m(Between(rng, 0.9F, 1.8F), Between(rng, 0.7F, 1.0F), kTableThicknessM);
  const Vector3f at_m(Between(rng, -0.2F, 0.2F), Between(rng, -0.12F, 0.12F), -kTableThicknessM);
  scene.objects.push_back(
      {Box(table_m, 0.004F, DrawTableTop(rng)), Pose(at_m, Between(rng, 0.0F, 2.0F * kPi))});
  scene.objects.push_back({Box({2.2F * kRoomM, 2.2F * kRoomM, 0.1F}, 0.01F, DrawBackground(rng)),
                           Pose({0.0F, 0.0F, kFloorM - 0.1F}, 0.0F)});
  const Material wall = DrawBackground(rng);
  for (int side = 0; side < 4; ++side) {
    const float yaw_rad = 0.5F * kPi * static_cast<float>(side);
    const Vector3f middle_m(kRoomM * std::cos(yaw_rad), kRoomM * std::sin(yaw_rad), kFloorM);
    scene.objects.push_back(
        {Box({0.1F, 2.2F * kRoomM, 3.5F}, 0.01F, wall), Pose(middle_m, yaw_rad)});
  }
}

void PlaceTargets(Scene& scene, std::span<const Object> targets, Rng& rng) {
  const Vector2f apart = DrawDirection(rng);
  float taken_m = 0.0F;
  std::vector<float> offsets_m;
  for (const Object& target : targets) {
    const float radius_m = Footprint(target);
    offsets_m.push_back(taken_m + radius_m);
    taken_m += 2.0F * radius_m + Between(rng, 0.01F, 0.06F);
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Vector2f at = (offsets_m[i] - 0.5F * taken_m) * apart;
    const Eigen::Isometry3f pose = Pose({at.x(), at.y(), 0.0F}, Between(rng, 0.0F, 2.0F * kPi));
    scene.objects.push_back({targets[i], pose, true});
  }
}

Material Paper(Rng& rng) {
  Material paper;
  paper.base = FromHsv(0.12F, Between(rng, 0.0F, 0.1F), Between(rng, 0.85F, 0.97F));
  paper.second =
      FromHsv(Between(rng, 0.0F, 1.0F), Between(rng, 0.0F, 0.6F), Between(rng, 0.05F, 0.35F));
  paper.pattern = Chance(rng, 0.8) ? Pattern::kPrint : Pattern::kPlain;
  if (paper.pattern == Pattern::kPlain) paper.second = 0.95F * paper.base;
  paper.scale_m = Between(rng, 0.003F, 0.007F);
  paper.specular = 0.0F;
  paper.seed = Between(rng, 0.0F, 500.0F);
  return paper;
}

Object DrawFlatThing(Rng& rng) {
  switch (rng.UniformInt(4)) {
    case 0:
      return Box({0.21F, 0.297F, 0.0006F}, 0.0002F, Paper(rng));
    case 1: {
      Material cover = DrawGlaze(rng);
      cover.pattern = Chance(rng, 0.6) ? Pattern::kPrint : Pattern::kPlain;
      cover.scale_m = Between(rng, 0.01F, 0.03F);
      return Box(
          {Between(rng, 0.11F, 0.17F), Between(rng, 0.17F, 0.24F), Between(rng, 0.006F, 0.03F)},
          0.001F,
          cover);
    }
    case 2: {
      Material cloth = DrawTableTop(rng);
      cloth.pattern = Pattern::kChecks;
      cloth.scale_m = Between(rng, 0.008F, 0.03F);
      cloth.specular = 0.0F;
      return Box({Between(rng, 0.15F, 0.42F), Between(rng, 0.12F, 0.3F), 0.0015F}, 0.0006F, cloth);
    }
    default: {
      Material metal = DrawPlastic(rng);
      metal.base = Colour(0.4F, Between(rng, 0.25F, 0.38F), Between(rng, 0.15F, 0.3F));
      metal.specular = 0.3F;
      const float radius_m = Between(rng, 0.009F, 0.013F);
      return {.mesh = Revolve({{radius_m, 0.0F, {}}, {radius_m, 0.0019F, {}}}, Ends::kCapped, 40),
              .materials = {metal}};
    }
  }
}

// Thin things may lie anywhere, under the targets too; thick ones beside them and each other.
void AddFlatThings(Scene& scene, float targets_radius_m, Rng& rng) {
  const std::uint64_t count = rng.UniformInt(6);
  std::vector<Eigen::Vector3f> thick;  // place and radius
  for (std::uint64_t i = 0; i < count; ++i) {
    Object thing = DrawFlatThing(rng);
    const bool is_thin = Bounds(thing.mesh).sizes().z() < 0.0018F;
    const float radius_m = Footprint(thing);
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
    scene.objects.push_back({std::move(thing), Pose({at.x(), at.y(), lift_m}, yaw_rad)});
  }
}

void DrawLight(Scene& scene, Rng& rng) {
  const float elevation_rad = Between(rng, 0.6F, 1.4F);
  const float distance_m = Between(rng, 1.2F, 2.0F);
  const Vector2f azimuth = DrawDirection(rng);
  const Vector3f towards(std::cos(elevation_rad) * azimuth.x(),
                         std::cos(elevation_rad) * azimuth.y(),
                         std::sin(elevation_rad));
  const Vector3f side = towards.cross(Vector3f::UnitZ()).normalized();
  scene.light.centre_m = distance_m * towards;
  scene.light.half_u_m = Between(rng, 0.06F, 0.3F) * side;
  scene.light.half_v_m = Between(rng, 0.06F, 0.3F) * side.cross(towards);
  const float warmth = Between(rng, -0.12F, 0.2F);
  const Colour tint(1.0F + warmth, 1.0F, 1.0F - warmth);
  scene.light.intensity = distance_m * distance_m * tint;
  scene.ambient =
      Between(rng, 0.22F, 0.55F) * Colour(1.0F - 0.3F * warmth, 1.0F, 1.0F + 0.3F * warmth);
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
  AddRoom(scene, rng);
  PlaceTargets(scene, targets, rng);
  float targets_radius_m = 0.0F;
  for (const PlacedObject& placed : scene.objects) {
    if (!placed.is_target) continue;
    const Vector3f extent = Bounds(placed.object.mesh).max();
    const float around_m = std::max(Footprint(placed.object), 0.6F * extent.z());
    targets_radius_m =
        std::max(targets_radius_m, placed.base_from_object.translation().norm() + around_m);
  }
  AddFlatThings(scene, targets_radius_m, rng);
  DrawLight(scene, rng);
  DrawCamera(scene, targets_radius_m, rng);
  scene.sensor = {.mean_exposure = Between(rng, 0.14F, 0.3F),
                  .read_noise = Between(rng, 0.6F, 2.0F),
                  .shot_noise = Between(rng, 0.0F, 0.02F),
                  .blur_px = Between(rng, 0.35F, 0.7F)};
  return scene;
}

}  // namespace handcraft::synthetic
