// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/drills.h"

#include <vector>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/object_parts.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// The drills' materials.
enum : std::uint8_t { kHousing, kRubber, kSteel, kTrigger };

// The chuck and what turns with it, from x = 0 along +x: collar, jaws' sleeve, tip.
Mesh Chuck(float radius_m, float length_m) {
  const Surface collar{kRubber, false};
  const Surface steel{kSteel, false};
  return TurnedAlongX(Revolve({{0.92F * radius_m, -0.004F, collar},
                               {radius_m, 0.0F, collar},
                               {radius_m, 0.46F * length_m, collar},
                               {0.88F * radius_m, 0.50F * length_m, collar},
                               {0.84F * radius_m, 0.80F * length_m, collar},
                               {0.48F * radius_m, 0.95F * length_m, steel},
                               {0.36F * radius_m, length_m, steel}},
                              Ends::kCapped,
                              40));
}

// A bit in the chuck, from x = 0 along +x.
Mesh Bit(float radius_m, float length_m) {
  const Surface steel{kSteel, false};
  return TurnedAlongX(Revolve({{radius_m, -0.01F, steel},
                               {radius_m, 0.9F * length_m, steel},
                               {0.3F * radius_m, length_m, steel}},
                              Ends::kCapped,
                              16));
}

// A finger's lever, from below the housing down the front of the handle.
Mesh Trigger(const Vector3f& top_m, float length_m) {
  const Surface surface{kTrigger, false};
  const std::vector<PathPoint> path = {
      {top_m, {0.0075F, 0.008F}, surface},
      {top_m + Vector3f(0.003F, 0.0F, -0.35F * length_m), {0.0070F, 0.008F}, surface},
      {top_m + Vector3f(-0.004F, 0.0F, -0.75F * length_m), {0.0065F, 0.008F}, surface},
      {top_m + Vector3f(-0.006F, 0.0F, -length_m), {0.0060F, 0.006F}, surface}};
  return Sweep(SmoothPath(path, 5), Vector3f::UnitY());
}

std::vector<Material> DrawDrillMaterials(Rng& rng) {
  std::vector<Material> materials = {
      DrawVividPlastic(rng), DrawDarkRubber(rng), DrawMetal(rng), DrawDarkRubber(rng)};
  if (Chance(rng, 0.4)) materials[kTrigger] = DrawVividPlastic(rng);
  return materials;
}

// Motor and gears, along x from the rear to `length_m`; the gears' part is dark.
Mesh Housing(const Vector2f& half_m, float length_m) {
  const Surface held{kHousing, true};
  const Surface free{kHousing, false};
  const Surface dark{kRubber, false};
  const std::vector<BodySection> outline = {{0.0F, 0.62F * half_m, 2.4F, 0.0F, dark},
                                            {0.004F, 0.80F * half_m, 2.6F, 0.0F, dark},
                                            {0.10F * length_m, 0.96F * half_m, 2.8F, 0.0F, free},
                                            {0.18F * length_m, half_m, 2.8F, 0.0F, held},
                                            {0.45F * length_m, half_m, 2.8F, 0.0F, held},
                                            {0.62F * length_m, 0.97F * half_m, 2.6F, 0.0F, held},
                                            {0.70F * length_m, 0.90F * half_m, 2.4F, 0.0F, free},
                                            {0.74F * length_m, 0.82F * half_m, 2.2F, 0.0F, dark},
                                            {0.92F * length_m, 0.76F * half_m, 2.0F, 0.0F, dark},
                                            {length_m, 0.66F * half_m, 2.0F, 0.0F, dark}};
  return TurnedAlongX(LoftBody(SmoothSections(outline, 4)));
}

}  // namespace

Object DrawDrill(Rng& rng) {
  const float axis_m = Between(rng, 0.170F, 0.190F);  // height of the chuck's axis
  const float length_m = Between(rng, 0.130F, 0.150F);
  const float radius_m = Between(rng, 0.029F, 0.034F);
  const Vector3f battery_m(
      Between(rng, 0.112F, 0.130F), Between(rng, 0.068F, 0.078F), Between(rng, 0.046F, 0.058F));
  const float rear_m = -0.5F * length_m;
  Object drill{.mesh = RoundedBox(battery_m, 0.007F, {kRubber, false}),
               .materials = DrawDrillMaterials(rng)};
  Mesh foot =
      RoundedBox({0.86F * battery_m.x(), 0.88F * battery_m.y(), 0.020F}, 0.006F, {kHousing, false});
  Append(drill.mesh, MovedBy(foot, {-0.004F, 0.0F, battery_m.z() - 0.003F}));
  const float top_m = axis_m - 0.3F * radius_m;
  const float low_m = battery_m.z() + 0.010F;
  const float tilt_m = Between(rng, 0.008F, 0.016F);  // the handle leans back downwards
  const Vector2f grip_m(Between(rng, 0.0155F, 0.0180F), Between(rng, 0.0200F, 0.0235F));
  const float handle_m = rear_m + 0.040F;
  const std::vector<PathPoint> handle = {
      {{handle_m - tilt_m, 0.0F, low_m}, 1.15F * grip_m, {kHousing, false}},
      {{handle_m - 0.9F * tilt_m, 0.0F, low_m + 0.014F}, grip_m, {kRubber, true}},
      {{handle_m - 0.5F * tilt_m, 0.0F, 0.5F * (low_m + top_m)}, 1.04F * grip_m, {kRubber, true}},
      {{handle_m, 0.0F, top_m - 0.030F}, 1.02F * grip_m, {kHousing, false}},
      {{handle_m + 0.004F, 0.0F, top_m}, 1.2F * grip_m, {kHousing, false}}};
  Append(drill.mesh, Sweep(SmoothPath(handle, 6), Vector3f::UnitY(), 32));
  const Vector3f trigger_m(handle_m + grip_m.y() - 0.002F, 0.0F, axis_m - 0.90F * radius_m);
  Append(drill.mesh, Trigger(trigger_m, Between(rng, 0.028F, 0.036F)));
  const Vector2f half_m(radius_m, 1.08F * radius_m);
  Append(drill.mesh, MovedBy(Housing(half_m, length_m), {rear_m, 0.0F, axis_m}));
  const float chuck_m = Between(rng, 0.040F, 0.050F);
  const Vector3f front_m(rear_m + length_m, 0.0F, axis_m);
  Append(drill.mesh, MovedBy(Chuck(0.66F * radius_m, chuck_m), front_m));
  if (Chance(rng, 0.4)) {
    const Vector3f tip_m = front_m + Vector3f(chuck_m, 0.0F, 0.0F);
    Append(drill.mesh,
           MovedBy(Bit(Between(rng, 0.002F, 0.0035F), Between(rng, 0.03F, 0.06F)), tip_m));
  }
  CentreOnTable(drill.mesh);
  return drill;
}

Object DrawOtherDrill(Rng& rng) {
  const float axis_m = Between(rng, 0.150F, 0.168F);
  const float length_m = Between(rng, 0.150F, 0.172F);
  const float radius_m = Between(rng, 0.0245F, 0.0285F);
  const float rear_m = -0.58F * length_m;
  const Vector2f foot_m(Between(rng, 0.027F, 0.031F), Between(rng, 0.034F, 0.040F));
  const Vector2f grip_m(Between(rng, 0.0165F, 0.0190F), Between(rng, 0.0190F, 0.0220F));
  const float lean_m = Between(rng, 0.012F, 0.022F);
  const float top_m = axis_m - 0.2F * radius_m;
  const std::vector<PathPoint> handle = {
      {{-lean_m, 0.0F, 0.0F}, 0.94F * foot_m, {kRubber, false}},
      {{-lean_m, 0.0F, 0.006F}, foot_m, {kRubber, false}},
      {{-lean_m, 0.0F, 0.026F}, 0.97F * foot_m, {kHousing, false}},
      {{-0.8F * lean_m, 0.0F, 0.044F}, 1.08F * grip_m, {kHousing, true}},
      {{-0.4F * lean_m, 0.0F, 0.55F * top_m}, grip_m, {kRubber, true}},
      {{-0.1F * lean_m, 0.0F, top_m - 0.026F}, 1.05F * grip_m, {kHousing, false}},
      {{0.0F, 0.0F, top_m}, 1.15F * grip_m, {kHousing, false}}};
  Object drill{.mesh = Sweep(SmoothPath(handle, 5), Vector3f::UnitY(), 36),
               .materials = DrawDrillMaterials(rng)};
  Append(drill.mesh,
         Trigger({grip_m.y() - 0.001F, 0.0F, axis_m - 0.92F * radius_m},
                 Between(rng, 0.024F, 0.030F)));
  const Mesh housing = Housing({radius_m, radius_m}, length_m);
  Append(drill.mesh, MovedBy(housing, {rear_m, 0.0F, axis_m}));
  const Vector3f front_m(rear_m + length_m, 0.0F, axis_m);
  Append(drill.mesh, MovedBy(Chuck(0.72F * radius_m, Between(rng, 0.032F, 0.040F)), front_m));
  CentreOnTable(drill.mesh);
  return drill;
}

}  // namespace handcraft::synthetic
