// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/taught_objects.h"

#include <array>
#include <cmath>
#include <numbers>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/object_parts.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;

// Coloured liquid behind clear plastic.
Material DrawColouredLiquid(Rng& rng) {
  constexpr std::array<float, 4> kHues = {0.50F, 0.58F, 0.38F, 0.08F};  // mint, blue, green, amber
  Material liquid =
      Painted(FromHsv(kHues[rng.UniformInt(kHues.size())] + Between(rng, -0.02F, 0.02F),
                      Between(rng, 0.6F, 0.9F),
                      Between(rng, 0.35F, 0.75F)),
              Between(rng, 0.07F, 0.1F));
  liquid.second = 0.7F * liquid.base;
  liquid.scale_m = 0.05F;
  liquid.shininess = Between(rng, 200.0F, 500.0F);
  return liquid;
}

// From the vessel's wall out, down along a half circle, and back.
Mesh RoundHandle(float wall_m, const Vector2f& heights_m, float reach_m, Surface surface) {
  constexpr int kSteps = 24;
  const float middle_m = heights_m.mean();
  const float radius_m = 0.5F * (heights_m.y() - heights_m.x());
  std::vector<PathPoint> path;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle_rad = kPi * (static_cast<float>(i) / kSteps - 0.5F);
    const float thick = 1.0F + 0.25F * std::abs(std::sin(angle_rad));
    path.push_back(
        {{wall_m + reach_m * std::cos(angle_rad), 0.0F, middle_m + radius_m * std::sin(angle_rad)},
         {0.0075F * thick, 0.0050F * thick},
         surface});
  }
  return Sweep(path, Vector3f::UnitY());
}

// A jug's body: full below, and above a column about x = −shift that leaves room for a hand.
std::vector<BodySection> JugSections(const Vector2f& half_m, float height_m, float shift_m) {
  const Vector2f column_m(half_m.x() - shift_m, 0.86F * half_m.y());
  const Vector2f neck_m(0.021F, 0.021F);
  return {{0.0F, 0.90F * half_m, 4.0F, 0.0F, {}},
          {0.02F * height_m, half_m, 4.0F, 0.0F, {}},
          {0.20F * height_m, half_m, 4.0F, 0.0F, {}},
          {0.40F * height_m, half_m, 4.0F, 0.0F, {}},
          {0.47F * height_m, 0.97F * half_m, 3.6F, -0.03F * shift_m, {}},
          {0.54F * height_m, {column_m.x() * 1.08F, column_m.y()}, 3.0F, -0.92F * shift_m, {}},
          {0.70F * height_m, column_m, 2.8F, -shift_m, {}},
          {0.84F * height_m, 0.92F * column_m, 2.6F, -shift_m, {}},
          {0.93F * height_m, neck_m, 2.0F, -shift_m, {}},
          {height_m, neck_m, 2.0F, -shift_m, {}}};
}

}  // namespace

Object DrawCoffeeCan(Rng& rng) {
  const Vector2f half_m(Between(rng, 0.036F, 0.043F), Between(rng, 0.050F, 0.058F));
  const float height_m = Between(rng, 0.135F, 0.165F);
  const float lid_m = Between(rng, 0.012F, 0.017F);
  const float power = Between(rng, 4.5F, 6.5F);
  const Vector2f bead_m = half_m + Vector2f::Constant(0.0016F);
  const Vector2f cap_m = half_m + Vector2f::Constant(0.0024F);
  const float body_m = height_m - lid_m;
  std::vector<BodySection> sections = {{0.0F, half_m, power, 0.0F, {2, false}},
                                       {0.001F, bead_m, power, 0.0F, {2, false}},
                                       {0.004F, bead_m, power, 0.0F, {2, false}},
                                       {0.005F, half_m, power, 0.0F, {0, false}}};
  constexpr int kSpans = 24;
  for (int i = 1; i <= kSpans; ++i) {
    const float along = static_cast<float>(i) / kSpans;
    const bool is_held = along > 0.2F && along < 0.88F;
    sections.push_back({0.005F + along * (body_m - 0.005F), half_m, power, 0.0F, {0, is_held}});
  }
  for (const Vector2f& step :
       {Vector2f(0.0F, 0.0F), Vector2f(0.9F, 0.0F), Vector2f(1.0F, 0.002F)}) {
    const Vector2f lip_m = cap_m - Vector2f::Constant(0.0024F * step.y() / 0.002F);
    sections.push_back({body_m + step.x() * lid_m + 1e-5F, lip_m, power, 0.0F, {1, false}});
  }
  sections.push_back({height_m, 0.93F * half_m, power, 0.0F, {1, false}});
  sections.push_back({height_m - 0.0025F, 0.91F * half_m, power, 0.0F, {1, false}});
  Object can{.mesh = LoftBody(sections),
             .materials = {DrawLabel(rng), DrawVividPlastic(rng), DrawMetal(rng)}};
  if (Chance(rng, 0.5)) can.materials[1] = Painted(Colour::Constant(0.75F), 0.04F);
  return can;
}

Object DrawMouthwashBottle(Rng& rng) {
  const Vector2f half_m(Between(rng, 0.025F, 0.031F), Between(rng, 0.042F, 0.049F));
  const float body_m = Between(rng, 0.140F, 0.170F);
  const float neck_m = Between(rng, 0.0125F, 0.015F);
  const float waist = Between(rng, 0.90F, 0.97F);
  const std::vector<BodySection> outline = {
      {0.0F, 0.86F * half_m, 3.6F, 0.0F, {}},
      {0.006F, half_m, 3.6F, 0.0F, {}},
      {0.25F * body_m, half_m, 3.8F, 0.0F, {}},
      {0.50F * body_m, waist * half_m, 3.8F, 0.0F, {}},
      {0.76F * body_m, half_m, 3.6F, 0.0F, {}},
      {0.90F * body_m, 0.86F * half_m, 3.0F, 0.0F, {}},
      {body_m, Vector2f::Constant(neck_m), 2.0F, 0.0F, {}},
      {body_m + 0.008F, Vector2f::Constant(neck_m), 2.0F, 0.0F, {}}};
  Object bottle{.mesh = LoftBody(SmoothSections(outline, 8)),
                .materials = {DrawColouredLiquid(rng), DrawLabel(rng), DrawVividPlastic(rng)}};
  Resurface(bottle.mesh, {1, false}, [&](const Vector3f& at, const Vector3f& normal) {
    return at.z() > 0.2F * body_m && at.z() < 0.72F * body_m && std::abs(normal.x()) > 0.75F;
  });
  MarkHeights(bottle.mesh, 0.25F * body_m, 0.80F * body_m);
  const float cap_m = neck_m + Between(rng, 0.003F, 0.005F);
  const Mesh cap = RidgedCap(cap_m, Between(rng, 0.024F, 0.034F), 30, {2, false});
  Append(bottle.mesh, MovedBy(cap, {0.0F, 0.0F, body_m + 0.004F}));
  RestOnTable(bottle.mesh);
  return bottle;
}

Object DrawBelliedMug(Rng& rng) {
  const float rim_m = Between(rng, 0.037F, 0.042F);
  const float belly_m = rim_m + Between(rng, 0.004F, 0.008F);
  const float height_m = Between(rng, 0.092F, 0.108F);
  const float wall_m = Between(rng, 0.0035F, 0.005F);
  const Profile outside = SmoothProfile({{0.72F * rim_m, 0.0F, {}},
                                         {0.82F * rim_m, 0.004F, {}},
                                         {belly_m, 0.38F * height_m, {}},
                                         {0.5F * (belly_m + rim_m), 0.75F * height_m, {}},
                                         {rim_m, 0.92F * height_m, {}},
                                         {rim_m, height_m, {}}},
                                        8);
  Profile wall = WalledProfile(outside, wall_m);
  MarkBetween(wall, height_m - 0.012F, height_m + wall_m);
  Object mug{.mesh = Revolve(wall, Ends::kCapped), .materials = {DrawGlaze(rng)}};
  mug.materials.push_back(Chance(rng, 0.5) ? Painted(Colour::Constant(0.8F), 0.05F)
                                           : mug.materials[0]);
  for (Face& face : mug.mesh.faces) {
    const Vector3f& a = mug.mesh.vertices[face.vertices[0]];
    const Vector3f normal =
        (mug.mesh.vertices[face.vertices[1]] - a).cross(mug.mesh.vertices[face.vertices[2]] - a);
    if (normal.head<2>().dot(a.head<2>()) < 0.0F) face.surface.material = 1;
  }
  const Vector2f heights_m(height_m * Between(rng, 0.18F, 0.24F),
                           height_m * Between(rng, 0.78F, 0.86F));
  Append(mug.mesh, RoundHandle(rim_m, heights_m, Between(rng, 0.030F, 0.038F), {0, true}));
  RestOnTable(mug.mesh);
  return mug;
}

Object DrawDetergentBottle(Rng& rng) {
  const Vector2f half_m(Between(rng, 0.056F, 0.064F), Between(rng, 0.034F, 0.040F));
  const float height_m = Between(rng, 0.215F, 0.250F);
  const float shift_m = Between(rng, 0.024F, 0.028F);
  Object bottle{.mesh = LoftBody(SmoothSections(JugSections(half_m, height_m, shift_m), 6)),
                .materials = {DrawVividPlastic(rng), DrawLabel(rng), DrawVividPlastic(rng)}};
  Resurface(bottle.mesh, {1, false}, [&](const Vector3f& at, const Vector3f& normal) {
    return at.z() > 0.08F * height_m && at.z() < 0.42F * height_m && std::abs(normal.y()) > 0.8F;
  });
  const float grip_m = Between(rng, 0.0105F, 0.0130F);
  const Vector2f thick_m(1.25F * grip_m, grip_m);
  const float out_m = half_m.x() - grip_m;
  const std::vector<PathPoint> path = {
      {{-shift_m, 0.0F, 0.86F * height_m}, thick_m, {0, false}},
      {{0.25F * out_m, 0.0F, 0.855F * height_m}, thick_m, {0, true}},
      {{0.80F * out_m, 0.0F, 0.80F * height_m}, thick_m, {0, true}},
      {{out_m, 0.0F, 0.66F * height_m}, thick_m, {0, true}},
      {{1.01F * out_m, 0.0F, 0.52F * height_m}, thick_m, {0, false}},
      {{0.95F * out_m, 0.0F, 0.40F * height_m}, thick_m, {0, false}}};
  Append(bottle.mesh, Sweep(SmoothPath(path, 6), Vector3f::UnitY(), 24));
  const Mesh cap = RidgedCap(Between(rng, 0.025F, 0.029F), Between(rng, 0.034F, 0.046F), 36, {2});
  Append(bottle.mesh, MovedBy(cap, {-shift_m, 0.0F, height_m - 0.012F}));
  RestOnTable(bottle.mesh);
  return bottle;
}

Object DrawPlasticBottle(Rng& rng) {
  const float radius_m = Between(rng, 0.0330F, 0.0385F);
  const float height_m = Between(rng, 0.205F, 0.240F);
  const float neck_m = Between(rng, 0.0125F, 0.0140F);
  const float waist = Between(rng, 0.86F, 0.94F);
  const Profile body = SmoothProfile({{0.70F * radius_m, 0.0F, {}},
                                      {0.97F * radius_m, 0.010F, {}},
                                      {radius_m, 0.16F * height_m, {}},
                                      {waist * radius_m, 0.30F * height_m, {}},
                                      {radius_m, 0.42F * height_m, {1, false}},
                                      {radius_m, 0.60F * height_m, {}},
                                      {0.93F * radius_m, 0.68F * height_m, {}},
                                      {0.55F * radius_m, 0.83F * height_m, {}},
                                      {neck_m, 0.90F * height_m, {}},
                                      {neck_m, 0.97F * height_m, {}}},
                                     8);
  Object bottle{.mesh = Revolve(body, Ends::kCapped),
                .materials = {DrawColouredLiquid(rng), DrawLabel(rng), DrawVividPlastic(rng)}};
  MarkHeights(bottle.mesh, 0.16F * height_m, 0.62F * height_m);
  const Mesh ring =
      Revolve({{neck_m + 0.004F, 0.0F, {}}, {neck_m + 0.004F, 0.002F, {}}}, Ends::kCapped);
  Append(bottle.mesh, MovedBy(ring, {0.0F, 0.0F, 0.925F * height_m}));
  const Mesh cap = RidgedCap(neck_m + 0.002F, 0.055F * height_m, 36, {2, false});
  Append(bottle.mesh, MovedBy(cap, {0.0F, 0.0F, 0.945F * height_m}));
  RestOnTable(bottle.mesh);
  return bottle;
}

}  // namespace handcraft::synthetic
