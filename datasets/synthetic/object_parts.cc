// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/object_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "datasets/synthetic/draw.h"
#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kRingPoints = 64;

// The parameter form of a superellipse: cos and sin to the power 2/n, with their signs.
float SignedPower(float value, float exponent) {
  return std::copysign(std::pow(std::abs(value), exponent), value);
}

Section Ring(const BodySection& body) {
  Section section{.ring = {}, .surface = body.surface};
  const float exponent = 2.0F / body.power;
  for (int i = 0; i < kRingPoints; ++i) {
    // Half a step on, so that no point's cosine or sine is 0 up to rounding.
    const float angle_rad = 2.0F * kPi * (static_cast<float>(i) + 0.5F) / kRingPoints;
    section.ring.emplace_back(
        body.shift_x_m + body.semi_axes_m.x() * SignedPower(std::cos(angle_rad), exponent),
        body.semi_axes_m.y() * SignedPower(std::sin(angle_rad), exponent),
        body.height_m);
  }
  return section;
}

BodySection Blend(const std::array<const BodySection*, 4>& around, float t) {
  const auto mix = [&](const auto& field) {
    return CatmullRom({field(*around[0]), field(*around[1]), field(*around[2]), field(*around[3])},
                      t);
  };
  constexpr float kThinnestM = 0.0005F;
  BodySection section = *around[1];
  section.height_m = mix([](const BodySection& s) { return s.height_m; });
  section.semi_axes_m.x() =
      std::max(mix([](const BodySection& s) { return s.semi_axes_m.x(); }), kThinnestM);
  section.semi_axes_m.y() =
      std::max(mix([](const BodySection& s) { return s.semi_axes_m.y(); }), kThinnestM);
  section.power = std::max(mix([](const BodySection& s) { return s.power; }), 2.0F);
  section.shift_x_m = mix([](const BodySection& s) { return s.shift_x_m; });
  return section;
}

}  // namespace

std::vector<BodySection> SmoothSections(std::span<const BodySection> sections, int steps) {
  HC_CHECK(sections.size() >= 2 && steps >= 1, sections.size(), steps);
  std::vector<BodySection> smooth;
  const std::size_t last = sections.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const BodySection& from = sections[i];
    const BodySection& to = sections[i + 1];
    const bool is_edge = from.height_m == to.height_m;
    const std::array<const BodySection*, 4> around = {
        &sections[i == 0 ? 0 : i - 1], &from, &to, &sections[std::min(i + 2, last)]};
    for (int step = 0; step < (is_edge ? 1 : steps); ++step) {
      smooth.push_back(Blend(around, static_cast<float>(step) / static_cast<float>(steps)));
    }
  }
  smooth.push_back(sections.back());
  return smooth;
}

Mesh LoftBody(std::span<const BodySection> sections) {
  std::vector<Section> rings;
  for (const BodySection& section : sections) {
    HC_CHECK(section.semi_axes_m.minCoeff() > 0.0F && section.power >= 2.0F, section.power);
    rings.push_back(Ring(section));
  }
  return Loft(rings, Ends::kCapped);
}

std::vector<PathPoint> SmoothPath(std::span<const PathPoint> path, int steps) {
  HC_CHECK(path.size() >= 2 && steps >= 1, path.size(), steps);
  std::vector<PathPoint> smooth;
  const std::size_t last = path.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const PathPoint& before = path[i == 0 ? 0 : i - 1];
    const PathPoint& to = path[i + 1];
    const PathPoint& after = path[std::min(i + 2, last)];
    for (int step = 0; step < steps; ++step) {
      const float t = static_cast<float>(step) / static_cast<float>(steps);
      PathPoint point = path[i];
      for (Eigen::Index k = 0; k < 3; ++k) {
        point.position_m[k] = CatmullRom(
            {before.position_m[k], path[i].position_m[k], to.position_m[k], after.position_m[k]},
            t);
      }
      point.semi_axes_m += t * (to.semi_axes_m - path[i].semi_axes_m);
      smooth.push_back(point);
    }
  }
  smooth.push_back(path.back());
  return smooth;
}

Mesh RidgedCap(float radius_m, float height_m, int num_ridges, Surface surface) {
  HC_CHECK(num_ridges >= 3, num_ridges);
  const float depth_m = 0.04F * radius_m;
  const float bevel_m = std::min(0.1F * radius_m, 0.3F * height_m);
  Outline outline = Ellipse(Vector2f::Constant(radius_m), 4 * num_ridges);
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    if (i % 4 >= 2) outline.points[i] -= depth_m * outline.normals[i];
  }
  return Extrude(outline,
                 std::array<Station, 5>{{{0.0F, 0.0F, surface},
                                         {0.5F * height_m, 0.0F, surface},
                                         {height_m - bevel_m, 0.0F, surface},
                                         {height_m - 0.3F * bevel_m, 0.35F * bevel_m, surface},
                                         {height_m, bevel_m, surface}}});
}

Mesh MovedBy(Mesh mesh, const Vector3f& offset_m) {
  for (Vector3f& vertex : mesh.vertices) vertex += offset_m;
  return mesh;
}

Mesh TurnedAlongX(Mesh mesh) {
  for (Vector3f& vertex : mesh.vertices) vertex = {vertex.z(), vertex.x(), vertex.y()};
  return mesh;
}

void CentreOnTable(Mesh& mesh) {
  const Eigen::AlignedBox3f box = Bounds(mesh);
  const Vector3f offset_m(-box.center().x(), -box.center().y(), -box.min().z());
  for (Vector3f& vertex : mesh.vertices) vertex += offset_m;
}

void MarkHeights(Mesh& mesh, float low_m, float high_m) {
  for (Face& face : mesh.faces) {
    float sum_m = 0.0F;
    for (const std::uint32_t vertex : face.vertices) sum_m += mesh.vertices[vertex].z();
    face.surface.graspable = sum_m >= 3.0F * low_m && sum_m <= 3.0F * high_m;
  }
}

Material DrawLabel(Rng& rng) {
  Material label;
  const bool is_light = Chance(rng, 0.6);
  const float hue = Between(rng, 0.0F, 1.0F);
  const Colour light = FromHsv(hue, Between(rng, 0.0F, 0.25F), Between(rng, 0.85F, 0.97F));
  const Colour dark = FromHsv(
      hue + Between(rng, 0.2F, 0.8F), Between(rng, 0.6F, 0.95F), Between(rng, 0.25F, 0.65F));
  label.base = is_light ? light : dark;
  label.second = is_light ? dark : light;
  label.pattern = Pattern::kLabel;
  label.scale_m = Between(rng, 0.0035F, 0.006F);
  label.specular = Between(rng, 0.02F, 0.05F);
  label.shininess = Between(rng, 30.0F, 120.0F);
  label.seed = Between(rng, 0.0F, 500.0F);
  return label;
}

Material DrawDarkRubber(Rng& rng) {
  Material rubber = Painted(Colour::Constant(Between(rng, 0.015F, 0.05F)), 0.025F);
  rubber.shininess = Between(rng, 8.0F, 25.0F);
  return rubber;
}

Material DrawVividPlastic(Rng& rng) {
  Material plastic = Painted(
      FromHsv(Between(rng, 0.0F, 1.0F), Between(rng, 0.75F, 0.98F), Between(rng, 0.5F, 0.92F)),
      Between(rng, 0.03F, 0.05F));
  plastic.shininess = Between(rng, 25.0F, 120.0F);
  return plastic;
}

}  // namespace handcraft::synthetic
