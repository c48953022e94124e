// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene_parts.h"

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

Object Box(const Vector3f& size_m, float radius_m, const Material& material) {
  return {.mesh = RoundedBox(size_m, radius_m, {}), .materials = {material}};
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

}  // namespace

Vector2f DrawDirection(Rng& rng) {
  const float angle_rad = Between(rng, 0.0F, 2.0F * kPi);
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Eigen::Isometry3f UprightPose(const Vector3f& at_m, float yaw_rad) {
  return Eigen::Translation3f(at_m) *
         Eigen::Isometry3f(Eigen::AngleAxisf(yaw_rad, Vector3f::UnitZ()));
}

float FootprintRadius(const Object& object) {
  float radius_m = 0.0F;
  for (const Vector3f& vertex : object.mesh.vertices) {
    radius_m = std::max(radius_m, vertex.head<2>().norm());
  }
  return radius_m;
}

void AddRoom(Scene& scene, float table_scale, Rng& rng) {
  const Vector2f drawn_m(Between(rng, 0.9F, 1.8F), Between(rng, 0.7F, 1.0F));
  const Vector3f table_m(table_scale * drawn_m.x(), table_scale * drawn_m.y(), kTableThicknessM);
  const Vector3f at_m(Between(rng, -0.2F, 0.2F), Between(rng, -0.12F, 0.12F), -kTableThicknessM);
  scene.objects.push_back(
      {Box(table_m, 0.004F, DrawTableTop(rng)), UprightPose(at_m, Between(rng, 0.0F, 2.0F * kPi))});
  scene.objects.push_back({Box({2.2F * kRoomM, 2.2F * kRoomM, 0.1F}, 0.01F, DrawBackground(rng)),
                           UprightPose({0.0F, 0.0F, kFloorM - 0.1F}, 0.0F)});
  const Material wall = DrawBackground(rng);
  for (int side = 0; side < 4; ++side) {
    const float yaw_rad = 0.5F * kPi * static_cast<float>(side);
    const Vector3f middle_m(kRoomM * std::cos(yaw_rad), kRoomM * std::sin(yaw_rad), kFloorM);
    scene.objects.push_back(
        {Box({0.1F, 2.2F * kRoomM, 3.5F}, 0.01F, wall), UprightPose(middle_m, yaw_rad)});
  }
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

SensorModel DrawSensor(Rng& rng) {
  return {.mean_exposure = Between(rng, 0.14F, 0.3F),
          .read_noise = Between(rng, 0.6F, 2.0F),
          .shot_noise = Between(rng, 0.0F, 0.02F),
          .blur_px = Between(rng, 0.35F, 0.7F)};
}

}  // namespace handcraft::synthetic
