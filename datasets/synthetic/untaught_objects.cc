// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/untaught_objects.h"

#include <cmath>
#include <numbers>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/object_parts.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;

// A box about the z axis whose sides are cut into rows, so that labels can end anywhere up them.
Mesh BoxInRows(const Vector3f& size_m, float radius_m, int num_rows) {
  return Extrude(RoundedRectangle(size_m.head<2>(), 1.2F * radius_m),
                 RoundedStations(size_m.z(), radius_m, {}, num_rows));
}

// Three straight bars with round corners, out from the wall, down and back.
Mesh SquareHandle(const Vector2f& wall_m, const Vector2f& heights_m, float reach_m) {
  const Vector2f thick_m(0.0065F, 0.0045F);
  const Surface held{0, true};
  const float out_m = wall_m.mean() + reach_m;
  const float corner_m = 0.3F * reach_m;
  const std::vector<PathPoint> path = {
      {{wall_m.x(), 0.0F, heights_m.x()}, thick_m, held},
      {{out_m - corner_m, 0.0F, heights_m.x()}, thick_m, held},
      {{out_m - 0.2F * corner_m, 0.0F, heights_m.x() + 0.2F * corner_m}, thick_m, held},
      {{out_m, 0.0F, heights_m.x() + corner_m}, thick_m, held},
      {{out_m, 0.0F, heights_m.y() - corner_m}, thick_m, held},
      {{out_m - 0.2F * corner_m, 0.0F, heights_m.y() - 0.2F * corner_m}, thick_m, held},
      {{out_m - corner_m, 0.0F, heights_m.y()}, thick_m, held},
      {{wall_m.y(), 0.0F, heights_m.y()}, thick_m, held}};
  return Sweep(SmoothPath(path, 4), Vector3f::UnitY());
}

// Sections of a jug that leans away from its handle as it rises.
std::vector<BodySection> SlantedSections(const Vector2f& half_m, float height_m) {
  const float lean_m = 0.50F * half_m.x();
  const Vector2f neck_m(0.016F, 0.016F);
  return {{0.0F, 0.92F * half_m, 3.0F, 0.0F, {}},
          {0.03F * height_m, half_m, 3.2F, 0.0F, {}},
          {0.30F * height_m, half_m, 3.2F, 0.0F, {}},
          {0.42F * height_m, 0.95F * half_m, 3.0F, -0.04F * lean_m, {}},
          {0.58F * height_m, {0.66F * half_m.x(), 0.9F * half_m.y()}, 2.6F, -0.65F * lean_m, {}},
          {0.78F * height_m, {0.48F * half_m.x(), 0.8F * half_m.y()}, 2.3F, -lean_m, {}},
          {0.92F * height_m, neck_m, 2.0F, -1.15F * lean_m, {}},
          {height_m, neck_m, 2.0F, -1.15F * lean_m, {}}};
}

}  // namespace

Object DrawDvdCase(Rng& rng) {
  const Vector3f size_m(
      Between(rng, 0.0125F, 0.0160F), Between(rng, 0.132F, 0.138F), Between(rng, 0.186F, 0.193F));
  Object box{.mesh = BoxInRows(size_m, 0.0020F, 24),
             .materials = {DrawDarkRubber(rng), DrawLabel(rng)}};
  if (Chance(rng, 0.3)) box.materials[0] = Painted(FromHsv(0.6F, 0.8F, 0.6F), 0.05F);
  box.materials[1].scale_m = Between(rng, 0.006F, 0.010F);
  box.materials[1].specular = 0.09F;
  box.materials[1].shininess = 300.0F;
  // The printed sheet covers both sides and the spine, but for a margin below and above.
  Resurface(box.mesh, {1, false}, [&](const Vector3f& at, const Vector3f& normal) {
    const bool is_spine = normal.y() < -0.9F;
    const bool is_within = at.z() > 0.004F && at.z() < size_m.z() - 0.004F;
    return is_within && (std::abs(normal.x()) > 0.9F || is_spine);
  });
  MarkHeights(box.mesh, 0.5F * size_m.z(), size_m.z());
  return box;
}

Object DrawFlipTopBottle(Rng& rng) {
  const Vector2f half_m(Between(rng, 0.0205F, 0.0255F), Between(rng, 0.0350F, 0.0420F));
  const float body_m = Between(rng, 0.150F, 0.185F);
  const float cap_m = Between(rng, 0.028F, 0.036F);
  const float belly = Between(rng, 1.04F, 1.12F);
  const Vector2f top_m = 0.80F * half_m;
  const std::vector<BodySection> outline = {{0.0F, 0.84F * half_m, 2.5F, 0.0F, {}},
                                            {0.005F, 0.94F * half_m, 2.5F, 0.0F, {}},
                                            {0.35F * body_m, belly * half_m, 2.5F, 0.0F, {}},
                                            {0.70F * body_m, half_m, 2.4F, 0.0F, {}},
                                            {body_m, top_m, 2.4F, 0.0F, {}}};
  Object bottle{.mesh = LoftBody(SmoothSections(outline, 10)),
                .materials = {DrawVividPlastic(rng), DrawLabel(rng), DrawVividPlastic(rng)}};
  if (Chance(rng, 0.5)) bottle.materials[0] = Painted(Colour::Constant(0.8F), 0.05F);
  Resurface(bottle.mesh, {1, false}, [&](const Vector3f& at, const Vector3f& normal) {
    return at.z() > 0.16F * body_m && at.z() < 0.78F * body_m && std::abs(normal.x()) > 0.5F;
  });
  MarkHeights(bottle.mesh, 0.22F * body_m, 0.72F * body_m);
  const Surface cap{2, false};
  Append(bottle.mesh,
         LoftBody(std::vector<BodySection>{{body_m - 0.002F, 1.03F * top_m, 2.4F, 0.0F, cap},
                                           {body_m + 0.60F * cap_m, 1.00F * top_m, 2.4F, 0.0F, cap},
                                           {body_m + 0.62F * cap_m, 0.96F * top_m, 2.4F, 0.0F, cap},
                                           {body_m + 0.66F * cap_m, 0.99F * top_m, 2.4F, 0.0F, cap},
                                           {body_m + 0.94F * cap_m, 0.92F * top_m, 2.4F, 0.0F, cap},
                                           {body_m + cap_m, 0.82F * top_m, 2.4F, 0.0F, cap}}));
  RestOnTable(bottle.mesh);
  return bottle;
}

Object DrawTaperedMug(Rng& rng) {
  const float rim_m = Between(rng, 0.043F, 0.050F);
  const float foot_m = rim_m * Between(rng, 0.62F, 0.72F);
  const float height_m = Between(rng, 0.100F, 0.130F);
  const float wall_m = Between(rng, 0.0030F, 0.0040F);
  const auto radius_at = [&](float along) { return foot_m + along * (rim_m - foot_m); };
  Profile outside = {{foot_m - 0.003F, 0.0F, {}}, {foot_m, 0.003F, {}}};
  constexpr int kSteps = 20;
  for (int i = 1; i <= kSteps; ++i) {
    const float along = static_cast<float>(i) / kSteps;
    outside.push_back({radius_at(along), 0.003F + along * (height_m - 0.003F), {}});
  }
  Profile wall = WalledProfile(outside, wall_m);
  MarkBetween(wall, height_m - 0.014F, height_m + wall_m);
  Object mug{.mesh = Revolve(wall, Ends::kCapped), .materials = {DrawGlaze(rng)}};
  const Vector2f heights_m(height_m * Between(rng, 0.24F, 0.32F),
                           height_m * Between(rng, 0.80F, 0.88F));
  const Vector2f wall_at_m(radius_at(heights_m.x() / height_m) - 0.002F,
                           radius_at(heights_m.y() / height_m) - 0.002F);
  Append(mug.mesh, SquareHandle(wall_at_m, heights_m, Between(rng, 0.029F, 0.037F)));
  RestOnTable(mug.mesh);
  return mug;
}

Object DrawSlantedJug(Rng& rng) {
  const Vector2f half_m(Between(rng, 0.068F, 0.078F), Between(rng, 0.040F, 0.047F));
  const float height_m = Between(rng, 0.235F, 0.270F);
  const float lean_m = 0.50F * half_m.x();
  Object jug{.mesh = LoftBody(SmoothSections(SlantedSections(half_m, height_m), 6)),
             .materials = {DrawVividPlastic(rng), DrawLabel(rng), DrawVividPlastic(rng)}};
  if (Chance(rng, 0.5)) jug.materials[0] = Painted(Colour::Constant(0.78F), 0.05F);
  Resurface(jug.mesh, {1, false}, [&](const Vector3f& at, const Vector3f& normal) {
    return at.z() > 0.06F * height_m && at.z() < 0.36F * height_m && std::abs(normal.y()) > 0.7F;
  });
  const float grip_m = Between(rng, 0.0120F, 0.0145F);
  const Vector2f thick_m(1.1F * grip_m, grip_m);
  const std::vector<PathPoint> path = {
      {{-lean_m, 0.0F, 0.86F * height_m}, thick_m, {0, false}},
      {{0.10F * half_m.x(), 0.0F, 0.83F * height_m}, thick_m, {0, true}},
      {{0.38F * half_m.x(), 0.0F, 0.74F * height_m}, thick_m, {0, true}},
      {{0.60F * half_m.x(), 0.0F, 0.60F * height_m}, thick_m, {0, true}},
      {{0.80F * half_m.x(), 0.0F, 0.44F * height_m}, thick_m, {0, false}},
      {{0.78F * half_m.x(), 0.0F, 0.34F * height_m}, thick_m, {0, false}}};
  Append(jug.mesh, Sweep(SmoothPath(path, 6), Vector3f::UnitY(), 24));
  const float cap_m = Between(rng, 0.019F, 0.022F);
  const Surface cap{2, false};
  Append(jug.mesh,
         MovedBy(Revolve({{cap_m, 0.0F, cap},
                          {cap_m, 0.016F, cap},
                          {0.62F * cap_m, 0.022F, cap},
                          {0.42F * cap_m, 0.042F, cap},
                          {0.36F * cap_m, 0.044F, cap}},
                         Ends::kCapped),
                 {-1.15F * lean_m, 0.0F, height_m - 0.010F}));
  RestOnTable(jug.mesh);
  return jug;
}

Object DrawWaterBottle(Rng& rng) {
  const float radius_m = Between(rng, 0.0295F, 0.0325F);
  const float height_m = Between(rng, 0.185F, 0.203F);
  const float neck_m = 0.0128F;
  const float ring_m = Between(rng, 0.0012F, 0.0020F);  // depth of the rings' grooves
  Profile body = {{0.86F * radius_m, 0.0F, {}}, {radius_m, 0.006F, {}}};
  constexpr int kSteps = 96;
  for (int i = 0; i <= kSteps; ++i) {
    const float along = static_cast<float>(i) / kSteps;
    const float at_m = 0.008F + along * 0.66F * height_m;
    const bool is_label = along > 0.46F && along < 0.82F;
    const float groove = is_label ? 0.0F : 0.5F - 0.5F * std::cos(2.0F * kPi * 13.0F * along);
    const std::uint8_t material = is_label ? 1 : 0;
    body.push_back({radius_m - ring_m * groove, at_m, {material, along > 0.3F && along < 0.86F}});
  }
  const float shoulder_m = body.back().height_m;
  for (int i = 1; i <= 12; ++i) {
    const float turn_rad = 0.5F * kPi * static_cast<float>(i) / 12.0F;
    body.push_back({neck_m + (radius_m - neck_m) * std::cos(turn_rad),
                    shoulder_m + (0.90F * height_m - shoulder_m) * std::sin(turn_rad),
                    {}});
  }
  body.push_back({neck_m, 0.95F * height_m, {}});
  const float blue = Between(rng, 0.0F, 0.12F);
  Material clear = Clear(Colour(0.95F - blue, 0.97F - 0.3F * blue, 0.97F));
  clear.transmission = Between(rng, 0.6F, 0.8F);  // ribbed, hence a little milky
  Object bottle{.mesh = Revolve(body, Ends::kCapped),
                .materials = {clear, DrawLabel(rng), DrawVividPlastic(rng)}};
  const Mesh cap = RidgedCap(neck_m + 0.0018F, 0.07F * height_m, 32, {2, false});
  Append(bottle.mesh, MovedBy(cap, {0.0F, 0.0F, 0.93F * height_m}));
  return bottle;
}

Object DrawSaltContainer(Rng& rng) {
  const float radius_m = Between(rng, 0.039F, 0.044F);
  const float height_m = Between(rng, 0.125F, 0.145F);
  Profile profile = {{radius_m, 0.0F, {2, false}}, {radius_m, 0.003F, {0, false}}};
  constexpr int kSteps = 24;
  for (int i = 1; i <= kSteps; ++i) {
    const float along = static_cast<float>(i) / kSteps;
    const bool is_held = along > 0.2F && along < 0.85F;
    profile.push_back({radius_m, 0.003F + along * (height_m - 0.006F), {0, is_held}});
  }
  profile.push_back({radius_m, height_m, {1, false}});
  profile.push_back({radius_m - 0.0015F, height_m, {1, false}});
  profile.push_back({radius_m - 0.0020F, height_m - 0.002F, {1, false}});
  Object salt{
      .mesh = Revolve(profile, Ends::kCapped),
      .materials = {DrawLabel(rng), Painted(Colour(0.45F, 0.36F, 0.24F), 0.01F), DrawMetal(rng)}};
  salt.materials[0].specular = 0.015F;
  Mesh spout = RoundedBox({0.022F, 0.013F, 0.0035F}, 0.001F, {2, false});
  Append(salt.mesh, MovedBy(spout, {0.6F * radius_m, 0.0F, height_m - 0.003F}));
  return salt;
}

Object DrawRectangularBox(Rng& rng) {
  const Vector3f size_m(
      Between(rng, 0.048F, 0.062F), Between(rng, 0.110F, 0.140F), Between(rng, 0.165F, 0.205F));
  Object box{.mesh = BoxInRows(size_m, 0.0012F, 24), .materials = {DrawLabel(rng), DrawLabel(rng)}};
  for (Material& print : box.materials) print.specular = 0.025F;
  box.materials[0].scale_m = Between(rng, 0.006F, 0.011F);
  box.materials[1].base = box.materials[0].base;
  box.materials[1].second = box.materials[0].second;
  box.materials.push_back(Painted(box.materials[0].second, 0.025F));
  Resurface(box.mesh, {1, false}, [](const Vector3f&, const Vector3f& normal) {
    return std::abs(normal.x()) < 0.7F;
  });
  Resurface(box.mesh, {2, false}, [](const Vector3f&, const Vector3f& normal) {
    return std::abs(normal.z()) > 0.7F;
  });
  MarkHeights(box.mesh, 0.45F * size_m.z(), 0.95F * size_m.z());
  return box;
}

}  // namespace handcraft::synthetic
