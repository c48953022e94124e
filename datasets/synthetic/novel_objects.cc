// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/novel_objects.h"

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

// A label round a bottle: blots on a light ground.
Material Label(Rng& rng) {
  Material label = DrawPlastic(rng);
  label.base =
      FromHsv(Between(rng, 0.0F, 1.0F), Between(rng, 0.0F, 0.5F), Between(rng, 0.7F, 0.95F));
  label.second = FromHsv(Between(rng, 0.0F, 1.0F), 0.8F, Between(rng, 0.15F, 0.6F));
  label.pattern = Pattern::kSpeckled;
  label.scale_m = Between(rng, 0.006F, 0.015F);
  return label;
}

// The keys and the display of a calculator, on the plane z = top_m.
void AddKeys(Mesh& mesh, const Vector2f& size_m, float top_m, Rng& rng) {
  Mesh display = RoundedBox({0.78F * size_m.x(), 0.16F * size_m.y(), 0.002F}, 0.0008F, {1, false});
  Transform(display,
            Eigen::Isometry3f(Eigen::Translation3f(0.0F, 0.34F * size_m.y(), top_m - 0.001F)));
  Append(mesh, display);
  const int columns = 4 + static_cast<int>(rng.UniformInt(2));
  const int rows = 5 + static_cast<int>(rng.UniformInt(2));
  const Vector2f pitch_m(0.80F * size_m.x() / static_cast<float>(columns),
                         0.62F * size_m.y() / static_cast<float>(rows));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::uint8_t material = column + 1 == columns || row + 1 == rows ? 3 : 2;
      Mesh key =
          RoundedBox({0.7F * pitch_m.x(), 0.62F * pitch_m.y(), 0.004F}, 0.0012F, {material, false});
      const float x =
          (static_cast<float>(column) - 0.5F * static_cast<float>(columns - 1)) * pitch_m.x();
      const float y = -0.43F * size_m.y() + (static_cast<float>(row) + 0.5F) * pitch_m.y();
      Transform(key, Eigen::Isometry3f(Eigen::Translation3f(x, y, top_m - 0.001F)));
      Append(mesh, key);
    }
  }
}

// Half ellipses of a shampoo bottle at a share of its height.
Section EllipticSection(const Vector2f& semi_axes_m, float height_m, Surface surface) {
  Section section{.ring = {}, .surface = surface};
  for (const Vector2f& at : Ellipse(semi_axes_m).points) {
    section.ring.emplace_back(at.x(), at.y(), height_m);
  }
  return section;
}

}  // namespace

Object DrawBottle(Rng& rng) {
  const float radius_m = Between(rng, 0.029F, 0.040F);
  const float height_m = Between(rng, 0.18F, 0.24F);
  const float neck_m = Between(rng, 0.0115F, 0.0145F);
  const float shoulder = Between(rng, 0.52F, 0.62F);
  Profile body = SmoothProfile({{radius_m, 0.008F, {0, false}},
                                {radius_m, 0.2F * height_m, {1, false}},
                                {radius_m, (shoulder - 0.06F) * height_m, {0, false}},
                                {radius_m, shoulder * height_m, {0, false}},
                                {neck_m, (shoulder + 0.22F) * height_m, {0, false}},
                                {neck_m, height_m - 0.015F, {2, false}}},
                               8);
  MarkBetween(body, (shoulder + 0.18F) * height_m, height_m);
  body.insert(body.begin(), {radius_m - 0.005F, 0.0F, {0, false}});
  body.push_back({neck_m + 0.0015F, height_m - 0.015F, {2, true}});
  body.push_back({neck_m + 0.0015F, height_m - 0.001F, {2, true}});
  body.push_back({neck_m, height_m, {2, true}});
  Object bottle{.mesh = Revolve(body, Ends::kCapped),
                .materials = {DrawPlastic(rng), Label(rng), DrawPlastic(rng)}};
  bottle.materials[0].shininess = 300.0F;
  bottle.materials[0].specular = 0.08F;
  RestOnTable(bottle.mesh);
  if (Chance(rng, 0.4)) LieAlongX(bottle.mesh);
  return bottle;
}

Object DrawCalculator(Rng& rng) {
  const Vector2f size_m(Between(rng, 0.070F, 0.086F), Between(rng, 0.120F, 0.152F));
  const float height_m = Between(rng, 0.010F, 0.016F);
  constexpr float kEdgeM = 0.002F;
  constexpr float kBorderM = 0.006F;  // of the face, held with the long sides
  std::vector<Station> stations = RoundedStations(height_m, kEdgeM, {0, true});
  stations.push_back({height_m, kBorderM, {0, false}});
  Object calculator{.mesh = Extrude(RoundedRectangle(size_m, kBorderM + 0.001F), stations),
                    .materials = {DrawPlastic(rng),
                                  Painted(Colour(0.25F, 0.32F, 0.22F), 0.06F),
                                  DrawPlastic(rng),
                                  DrawPlastic(rng)}};
  for (Face& face : calculator.mesh.faces) {
    const Vector3f& corner = calculator.mesh.vertices[face.vertices[0]];
    const bool on_long_side = std::abs(corner.x()) > 0.5F * size_m.x() - kBorderM - 0.0005F &&
                              std::abs(corner.y()) < 0.5F * size_m.y() - 0.002F;
    face.surface.graspable = face.surface.graspable && on_long_side;
  }
  AddKeys(calculator.mesh, size_m, height_m, rng);
  return calculator;
}

Object DrawVerySmallCup(Rng& rng) {
  const float rim_m = Between(rng, 0.022F, 0.029F);
  const float height_m = Between(rng, 0.034F, 0.046F);
  const float foot_m = rim_m * Between(rng, 0.66F, 0.8F);
  const Profile outside = SmoothProfile({{foot_m, 0.0F, {}},
                                         {0.5F * (foot_m + rim_m), 0.35F * height_m, {}},
                                         {rim_m * 0.98F, 0.7F * height_m, {}},
                                         {rim_m, height_m, {}}},
                                        8);
  Profile wall = WalledProfile(outside, Between(rng, 0.0018F, 0.0024F));
  MarkBetween(wall, 0.82F * height_m, 1.2F * height_m);
  Object cup{.mesh = Revolve(wall, Ends::kCapped), .materials = {DrawGlaze(rng)}};
  const float ear_m = Between(rng, 0.009F, 0.012F);
  const Vector3f middle(rim_m + 0.3F * ear_m, 0.0F, 0.52F * height_m);
  const Vector2f semi_axes_m(Between(rng, 0.002F, 0.003F), Between(rng, 0.0015F, 0.0022F));
  std::vector<PathPoint> ear;
  for (int i = 0; i <= 20; ++i) {
    const float angle_rad = kPi * (static_cast<float>(i) / 20.0F - 0.5F) * 1.35F;
    ear.push_back({middle + ear_m * Vector3f(std::cos(angle_rad), 0.0F, std::sin(angle_rad)),
                   semi_axes_m,
                   {0, true}});
  }
  Append(cup.mesh, Sweep(ear, Vector3f::UnitY()));
  RestOnTable(cup.mesh);
  return cup;
}

Object DrawHammer(Rng& rng) {
  const float length_m = Between(rng, 0.26F, 0.33F);
  const float head_m = Between(rng, 0.085F, 0.115F);
  const float face_m = Between(rng, 0.011F, 0.014F);
  std::vector<PathPoint> handle;
  for (int i = 0; i <= 30; ++i) {
    const float along = static_cast<float>(i) / 30.0F;
    const float swell = 0.85F + 0.25F * std::sin(2.2F * along + 0.6F * std::sin(6.0F * along));
    handle.push_back({{along * length_m, 0.0F, 0.0F},
                      swell * Vector2f(0.014F, 0.0105F),
                      {0, along > 0.08F && along < 0.75F}});
  }
  Object hammer{.mesh = Sweep(handle, Vector3f::UnitY()),
                .materials = {DrawPlastic(rng), DrawMetal(rng)}};
  if (Chance(rng, 0.6)) {
    hammer.materials[0] = Painted(FromHsv(0.08F, 0.5F, 0.7F), 0.02F);
    hammer.materials[0].second = FromHsv(0.07F, 0.6F, 0.45F);
    hammer.materials[0].pattern = Pattern::kWood;
  }
  std::vector<PathPoint> head;  // from the face, across the handle, to the flat pein
  for (int i = 0; i <= 16; ++i) {
    const float along = static_cast<float>(i) / 16.0F;
    const float neck = along > 0.2F && along < 0.35F ? 0.8F : 1.0F;
    const float taper = along < 0.55F ? 1.0F : 1.0F - 1.7F * (along - 0.55F);
    head.push_back(
        {{length_m - 0.012F - 0.06F * std::max(along - 0.6F, 0.0F), (0.45F - along) * head_m, 0.0F},
         face_m * neck * Vector2f(1.0F, std::max(taper, 0.25F)),
         {1, false}});
  }
  Append(hammer.mesh, Sweep(head, Vector3f::UnitX(), 24));
  Transform(hammer.mesh, Eigen::Isometry3f(Eigen::Translation3f(-0.5F * length_m, 0.0F, 0.0F)));
  RestOnTable(hammer.mesh);
  return hammer;
}

Object DrawShampooBottle(Rng& rng) {
  const Vector2f body_m(Between(rng, 0.030F, 0.040F), Between(rng, 0.017F, 0.024F));
  const float height_m = Between(rng, 0.13F, 0.18F);
  const float cap_m = Between(rng, 0.011F, 0.015F);
  const float waist = Between(rng, 0.0F, 0.12F);
  std::vector<Section> sections = {EllipticSection(0.93F * body_m, 0.0F, {0, false})};
  for (int i = 0; i <= 24; ++i) {
    const float along = static_cast<float>(i) / 24.0F;
    const float round = std::min(1.0F, 6.0F * (1.0F - along));
    const float width = (1.0F - waist * std::sin(kPi * along)) * (0.55F + 0.45F * std::sqrt(round));
    const bool is_middle = along > 0.25F && along < 0.7F;
    const auto material = static_cast<std::uint8_t>(along > 0.15F && along < 0.6F ? 1 : 0);
    sections.push_back(
        EllipticSection(width * body_m, 0.003F + along * height_m, {material, is_middle}));
  }
  const float top_m = height_m + 0.003F;
  sections.push_back(EllipticSection(Vector2f::Constant(cap_m * 0.9F), top_m + 0.001F, {2, true}));
  sections.push_back(EllipticSection(Vector2f::Constant(cap_m), top_m + 0.002F, {2, true}));
  sections.push_back(EllipticSection(Vector2f::Constant(cap_m * 0.95F), top_m + 0.022F, {2, true}));
  sections.push_back(
      EllipticSection(Vector2f::Constant(cap_m * 0.85F), top_m + 0.0235F, {2, true}));
  return {.mesh = Loft(sections, Ends::kCapped),
          .materials = {DrawPlastic(rng), Label(rng), DrawPlastic(rng)}};
}

Object DrawTape(Rng& rng) {
  const float inner_m = Between(rng, 0.019F, 0.036F);
  const float outer_m = inner_m + Between(rng, 0.006F, 0.018F);
  const float width_m = Between(rng, 0.012F, 0.045F);
  const float core_m = inner_m + 0.0025F;
  const Surface tape{0, true};
  const Surface core{1, true};
  const Profile profile = {{outer_m, 0.0F, tape},
                           {outer_m, 0.5F * width_m, tape},
                           {outer_m, width_m, tape},
                           {core_m, width_m, core},
                           {inner_m, width_m, core},
                           {inner_m, 0.5F * width_m, core},
                           {inner_m, 0.0F, core},
                           {core_m, 0.0F, tape}};
  Object roll{.mesh = Revolve(profile, Ends::kJoined), .materials = {DrawPlastic(rng), {}}};
  roll.materials[0].specular = 0.08F;
  roll.materials[1] = Painted(FromHsv(0.09F, 0.4F, Between(rng, 0.5F, 0.8F)), 0.0F);
  if (Chance(rng, 0.35)) LieAlongX(roll.mesh);  // stands on its edge
  return roll;
}

}  // namespace handcraft::synthetic
