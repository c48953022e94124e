// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/trained_objects.h"

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
constexpr float kRimDepthM = 0.010F;  // what fingers hold of a rim

// What a handle is, in the plane of x (away from the vessel) and z.
struct HandleShape {
  Vector2f bottom_m, top_m;  ///< where its middle line meets the vessel
  float reach_m = 0.0F;      ///< how far it stands out beyond those
  Vector2f semi_axes_m;      ///< of its section: along y, and across
  float power = 1.0F;        ///< < 1: angular; 1: half an ellipse
};

Mesh Handle(const HandleShape& shape, Surface surface) {
  constexpr int kSteps = 24;
  std::vector<PathPoint> path;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle_rad = kPi * static_cast<float>(i) / kSteps;
    const float out = std::pow(std::max(std::sin(angle_rad), 0.0F), shape.power);
    const float up = 0.5F * (1.0F - std::cos(angle_rad));
    const Vector2f at = shape.bottom_m + up * (shape.top_m - shape.bottom_m);
    path.push_back({{at.x() + out * shape.reach_m, 0.0F, at.y()}, shape.semi_axes_m, surface});
  }
  return Sweep(path, Vector3f::UnitY());
}

void PaintInside(Mesh& mesh, std::uint8_t material) {
  for (Face& face : mesh.faces) {
    const Vector3f a = mesh.vertices[face.vertices[0]];
    const Vector3f normal =
        (mesh.vertices[face.vertices[1]] - a).cross(mesh.vertices[face.vertices[2]] - a);
    const bool is_floor = a.head<2>().isZero(1e-4F) && normal.z() > 0.0F;
    if (is_floor || normal.head<2>().dot(a.head<2>()) < 0.0F) face.surface.material = material;
  }
}

Mesh Vessel(const Profile& outside, float wall_m) {
  Profile profile = WalledProfile(SmoothProfile(outside, 8), wall_m);
  const float top_m = outside.back().height_m;
  MarkBetween(profile, top_m - kRimDepthM, top_m + wall_m);
  Mesh mesh = Revolve(profile, Ends::kCapped);
  RestOnTable(mesh);  // the smooth foot may reach a tenth of a millimetre below its points
  return mesh;
}

// A plate under a cup; its foot stands on z = 0. Returns the height of its floor.
float AddSaucer(Mesh& mesh, float radius_m) {
  constexpr float kWallM = 0.003F;
  const Profile outside = {{0.5F * radius_m, 0.0F, {}},
                           {0.55F * radius_m, 0.003F, {}},
                           {0.8F * radius_m, 0.006F, {}},
                           {radius_m, 0.014F, {}}};
  Append(mesh, Revolve(WalledProfile(SmoothProfile(outside, 6), kWallM), Ends::kCapped));
  RestOnTable(mesh);
  return kWallM;
}

// A pencil's point, end and body, along z. Materials: paint, wood, graphite, metal, rubber.
std::vector<Station> PencilStations(float length_m, float radius_m, float cone_m) {
  const float ferrule_m = 0.014F;
  const float body_m = length_m - cone_m - ferrule_m - 0.006F;
  const float first_m = 0.22F * body_m;
  const float last_m = 0.80F * body_m;
  return {{-cone_m, radius_m - 0.0004F, {2, false}},
          {-0.75F * cone_m, 0.75F * radius_m, {1, false}},
          {0.0F, 0.0F, {0, false}},
          {first_m, 0.0F, {0, true}},
          {0.5F * (first_m + last_m), 0.0F, {0, true}},
          {last_m, 0.0F, {0, false}},
          {body_m, 0.0F, {0, false}},
          {body_m, -0.0002F, {3, false}},
          {body_m + ferrule_m, -0.0002F, {3, false}},
          {body_m + ferrule_m, 0.0003F, {4, false}},
          {body_m + ferrule_m + 0.005F, 0.0003F, {4, false}},
          {body_m + ferrule_m + 0.006F, 0.0012F, {4, false}}};
}

}  // namespace

Object DrawCerealBowl(Rng& rng) {
  const float rim_m = Between(rng, 0.065F, 0.090F);
  const float height_m = Between(rng, 0.045F, 0.075F);
  const float foot_m = rim_m * Between(rng, 0.40F, 0.55F);
  const float belly = Between(rng, 0.78F, 0.94F);
  const Profile outside = {{foot_m, 0.0F, {}},
                           {foot_m * 1.02F, 0.004F, {}},
                           {rim_m * belly, 0.45F * height_m, {}},
                           {rim_m, height_m, {}}};
  Object bowl{.mesh = Vessel(outside, Between(rng, 0.003F, 0.005F)), .materials = {DrawGlaze(rng)}};
  bowl.materials.push_back(Chance(rng, 0.5) ? DrawGlaze(rng) : bowl.materials[0]);
  PaintInside(bowl.mesh, 1);
  return bowl;
}

Object DrawEraser(Rng& rng) {
  const float length_m = Between(rng, 0.045F, 0.065F);
  const Vector2f size_m(Between(rng, 0.018F, 0.026F), Between(rng, 0.010F, 0.014F));
  const float radius_m = Between(rng, 0.0015F, 0.003F);
  std::vector<Station> stations = RoundedStations(length_m, radius_m, {0, false}, 20);
  const float sleeve_m = length_m * Between(rng, 0.35F, 0.55F);
  for (Station& station : stations) {
    station.surface.graspable =
        station.height_m > 0.2F * length_m && station.height_m < 0.77F * length_m;
    if (station.height_m < sleeve_m && station.inset_m <= 0.0F) {
      station.surface.material = 1;
      station.inset_m -= 0.0004F;
    }
  }
  Object eraser{.mesh = Extrude(RoundedRectangle(size_m, radius_m * 1.3F), stations),
                .materials = {DrawPlastic(rng), DrawPlastic(rng)}};
  eraser.materials[0].specular = 0.01F;
  if (Chance(rng, 0.6)) eraser.materials[0].base = FromHsv(0.97F, Between(rng, 0.0F, 0.35F), 0.9F);
  LieAlongX(eraser.mesh);
  return eraser;
}

Object DrawMartiniGlass(Rng& rng) {
  const float foot_m = Between(rng, 0.030F, 0.039F);
  const float stem_m = Between(rng, 0.0035F, 0.0052F);
  const float stem_top_m = Between(rng, 0.070F, 0.095F);
  const float rim_m = Between(rng, 0.045F, 0.060F);
  const float top_m = stem_top_m + rim_m * Between(rng, 0.85F, 1.1F);
  const float wall_m = Between(rng, 0.0015F, 0.0022F);
  Profile profile = {{foot_m, 0.0F, {}},
                     {foot_m, 0.0015F, {}},
                     {0.5F * foot_m, 0.0035F, {}},
                     {1.3F * stem_m, 0.009F, {}}};
  for (int i = 0; i <= 10; ++i) {
    profile.push_back({stem_m, 0.014F + static_cast<float>(i) * 0.1F * (stem_top_m - 0.016F), {}});
  }
  MarkBetween(profile, 0.008F, stem_top_m);
  profile.back().surface.graspable = false;
  profile.push_back({stem_m + 0.004F, stem_top_m + 0.005F, {}});
  profile.push_back({rim_m, top_m, {}});
  profile.push_back({rim_m - wall_m, top_m + 0.3F * wall_m, {}});
  profile.push_back({stem_m + 0.001F, stem_top_m + 0.005F + wall_m, {}});
  profile.push_back({0.5F * stem_m, stem_top_m + 0.004F + wall_m, {}});
  Material glass = Clear(
      FromHsv(Between(rng, 0.3F, 0.65F), Between(rng, 0.0F, 0.05F), Between(rng, 0.96F, 0.995F)));
  glass.transmission = Between(rng, 0.80F, 0.92F);  // it bends light, which darkens it
  glass.specular = Between(rng, 0.06F, 0.14F);
  glass.shininess = Between(rng, 200.0F, 900.0F);
  return {.mesh = Revolve(profile, Ends::kCapped), .materials = {glass}};
}

Object DrawMug(Rng& rng) {
  const float radius_m = Between(rng, 0.036F, 0.047F);
  const float height_m = Between(rng, 0.080F, 0.112F);
  const float taper = Between(rng, 0.88F, 1.0F);
  const float wall_m = Between(rng, 0.003F, 0.0045F);
  const Profile outside = {{radius_m * taper - 0.004F, 0.0F, {}},
                           {radius_m * taper, 0.005F, {}},
                           {radius_m * (0.5F + 0.5F * taper), 0.5F * height_m, {}},
                           {radius_m, height_m - kRimDepthM, {}},
                           {radius_m, height_m, {}}};
  Object mug{.mesh = Vessel(outside, wall_m), .materials = {DrawGlaze(rng)}};
  mug.materials.push_back(Chance(rng, 0.4) ? DrawGlaze(rng) : mug.materials[0]);
  PaintInside(mug.mesh, 1);
  const HandleShape handle{
      .bottom_m = {radius_m * (0.5F + 0.5F * taper) - 0.003F,
                   height_m * Between(rng, 0.15F, 0.25F)},
      .top_m = {radius_m - 0.003F, height_m * Between(rng, 0.76F, 0.87F)},
      .reach_m = Between(rng, 0.026F, 0.038F),
      .semi_axes_m = {Between(rng, 0.006F, 0.009F), Between(rng, 0.0035F, 0.005F)},
      .power = Between(rng, 0.5F, 1.0F)};
  Append(mug.mesh, Handle(handle, {0, true}));
  return mug;
}

Object DrawStapler(Rng& rng) {
  const float length_m = Between(rng, 0.11F, 0.16F);
  const float width_m = Between(rng, 0.026F, 0.036F);
  const float arm_m = Between(rng, 0.018F, 0.026F);
  const float tilt_rad = Between(rng, 0.06F, 0.16F);
  Object stapler{.mesh = RoundedBox({length_m, width_m, 0.008F}, 0.003F, {0, false}),
                 .materials = {DrawPlastic(rng), DrawPlastic(rng)}};
  stapler.materials[1].base = Colour::Constant(Between(rng, 0.25F, 0.5F));
  stapler.materials[1].specular = 0.3F;
  std::vector<Station> stations = RoundedStations(length_m * 0.96F, 0.006F, {0, false}, 24);
  for (Station& station : stations) {
    const float along = station.height_m / length_m;
    station.surface.graspable = along > 0.25F && along < 0.72F;
  }
  Mesh arm = Extrude(RoundedRectangle({width_m * 0.8F, arm_m}, 0.0065F), stations);
  Mesh rail = RoundedBox({length_m * 0.9F, width_m * 0.55F, 0.010F}, 0.002F, {1, false});
  const Eigen::Isometry3f hinged =
      Eigen::Translation3f(-0.48F * length_m, 0.0F, 0.012F) *
      Eigen::Isometry3f(Eigen::AngleAxisf(-tilt_rad, Vector3f::UnitY()));
  Transform(rail, hinged * Eigen::Translation3f(0.47F * length_m, 0.0F, -0.002F));
  LieAlongX(arm);
  Transform(arm, hinged * Eigen::Translation3f(0.48F * length_m, 0.0F, 0.006F));
  Mesh hinge = RoundedBox({0.02F, width_m * 0.85F, 0.024F}, 0.003F, {1, false});
  Transform(hinge, Eigen::Isometry3f(Eigen::Translation3f(-0.42F * length_m, 0.0F, 0.002F)));
  for (const Mesh* part : {&rail, &arm, &hinge}) Append(stapler.mesh, *part);
  RestOnTable(stapler.mesh);
  return stapler;
}

Object DrawTeaCup(Rng& rng) {
  const float rim_m = Between(rng, 0.040F, 0.052F);
  const float height_m = Between(rng, 0.050F, 0.068F);
  const float foot_m = rim_m * Between(rng, 0.45F, 0.6F);
  const float belly = Between(rng, 0.72F, 0.9F);
  const Profile outside = {{foot_m, 0.0F, {}},
                           {foot_m, 0.004F, {}},
                           {rim_m * belly, 0.4F * height_m, {}},
                           {rim_m * (0.5F + 0.5F * belly), 0.75F * height_m, {}},
                           {rim_m, height_m, {}}};
  Object cup{.mesh = Vessel(outside, Between(rng, 0.002F, 0.003F)), .materials = {DrawGlaze(rng)}};
  cup.materials.push_back(cup.materials[0]);
  cup.materials[1].base = FromHsv(0.1F, Between(rng, 0.0F, 0.1F), 0.92F);
  cup.materials[1].pattern = Pattern::kPlain;
  cup.materials[1].second = 0.9F * cup.materials[1].base;
  PaintInside(cup.mesh, 1);
  const HandleShape handle{
      .bottom_m = {rim_m * belly - 0.003F, 0.36F * height_m},
      .top_m = {rim_m * (0.5F + 0.5F * belly) - 0.002F, 0.82F * height_m},
      .reach_m = 0.75F * (rim_m - rim_m * belly) + Between(rng, 0.013F, 0.021F),
      .semi_axes_m = {Between(rng, 0.0035F, 0.005F), Between(rng, 0.002F, 0.003F)},
      .power = Between(rng, 0.6F, 1.0F)};
  Append(cup.mesh, Handle(handle, {0, true}));
  if (Chance(rng, 0.4)) {
    Mesh saucer;
    const float floor_m = AddSaucer(saucer, rim_m * Between(rng, 1.45F, 1.7F));
    Transform(cup.mesh, Eigen::Isometry3f(Eigen::Translation3f(0.0F, 0.0F, floor_m)));
    Append(cup.mesh, saucer);
  }
  return cup;
}

Object DrawPencil(Rng& rng) {
  const float length_m = Between(rng, 0.12F, 0.19F);
  const float radius_m = Between(rng, 0.0036F, 0.0045F);
  const float cone_m = Between(rng, 0.014F, 0.022F);
  const Outline outline =
      Chance(rng, 0.7) ? RegularPolygon(radius_m, 6) : Ellipse(Vector2f::Constant(radius_m), 20);
  Object pencil{.mesh = Extrude(outline, PencilStations(length_m, radius_m, cone_m)),
                .materials = {DrawPlastic(rng), {}, {}, {}, {}}};
  pencil.materials[1].base = FromHsv(0.08F, 0.45F, 0.85F);
  pencil.materials[1].second = FromHsv(0.08F, 0.5F, 0.7F);
  pencil.materials[2].base = pencil.materials[2].second = Colour::Constant(0.04F);
  pencil.materials[3].base = pencil.materials[3].second = Colour(0.5F, 0.45F, 0.3F);
  pencil.materials[3].specular = 0.4F;
  pencil.materials[4].base = pencil.materials[4].second = FromHsv(0.98F, 0.4F, 0.85F);
  LieAlongX(pencil.mesh);
  return pencil;
}

}  // namespace handcraft::synthetic
