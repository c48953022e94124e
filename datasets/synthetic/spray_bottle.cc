// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/spray_bottle.h"

#include <cmath>
#include <vector>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/object_parts.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// The spray bottle's materials.
enum : std::uint8_t { kBody, kLabelSheet, kHead, kNozzle };

// The shroud from the back of the head to the nozzle, along x at height 0, and the nozzle.
Mesh SprayHead(float length_m, float half_height_m) {
  const Surface head{kHead, false};
  const Vector2f half_m(0.42F * half_height_m, half_height_m);
  const std::vector<BodySection> outline = {{0.0F, 0.55F * half_m, 3.0F, 0.0F, head},
                                            {0.06F * length_m, 0.80F * half_m, 3.2F, 0.0F, head},
                                            {0.30F * length_m, 1.05F * half_m, 3.2F, 0.0F, head},
                                            {0.60F * length_m, 0.92F * half_m, 3.2F, 0.0F, head},
                                            {0.90F * length_m, 0.66F * half_m, 3.0F, 0.0F, head},
                                            {length_m, 0.62F * half_m, 3.0F, 0.0F, head}};
  Mesh mesh = TurnedAlongX(LoftBody(SmoothSections(outline, 5)));
  const Mesh nozzle = Extrude(RegularPolygon(0.0085F, 6),
                              std::vector<Station>{{0.0F, 0.0F, {kNozzle, false}},
                                                   {0.012F, 0.0F, {kNozzle, false}},
                                                   {0.014F, 0.0015F, {kNozzle, false}}});
  Append(mesh, MovedBy(TurnedAlongX(nozzle), {0.985F * length_m, 0.0F, 0.0F}));
  return mesh;
}

// The lever below the nozzle, curved for a finger.
Mesh Lever(const Vector3f& top_m, float length_m) {
  const Surface surface{kNozzle, false};
  const std::vector<PathPoint> path = {
      {top_m, {0.0065F, 0.0030F}, surface},
      {top_m + Vector3f(-0.004F, 0.0F, -0.30F * length_m), {0.0065F, 0.0030F}, surface},
      {top_m + Vector3f(-0.006F, 0.0F, -0.60F * length_m), {0.0060F, 0.0028F}, surface},
      {top_m + Vector3f(0.003F, 0.0F, -length_m), {0.0055F, 0.0025F}, surface}};
  return Sweep(SmoothPath(path, 6), Vector3f::UnitY());
}

}  // namespace

Object DrawSprayBottle(Rng& rng) {
  const Vector2f half_m(Between(rng, 0.041F, 0.048F), Between(rng, 0.028F, 0.033F));
  const float body_m = Between(rng, 0.165F, 0.190F);  // up to the collar
  const float neck_m = Between(rng, 0.0145F, 0.0170F);
  const Vector2f waist_m(0.62F * half_m.x(), 0.72F * half_m.y());
  const std::vector<BodySection> outline = {{0.0F, 0.90F * half_m, 2.8F, 0.0F, {}},
                                            {0.005F, half_m, 2.8F, 0.0F, {}},
                                            {0.35F * body_m, half_m, 2.8F, 0.0F, {}},
                                            {0.55F * body_m, 0.92F * half_m, 2.6F, 0.0F, {}},
                                            {0.75F * body_m, waist_m, 2.4F, 0.0F, {}},
                                            {0.92F * body_m, 0.90F * waist_m, 2.2F, 0.0F, {}},
                                            {body_m, Vector2f::Constant(neck_m), 2.0F, 0.0F, {}}};
  Object bottle{
      .mesh = LoftBody(SmoothSections(outline, 8)),
      .materials = {
          DrawVividPlastic(rng), DrawLabel(rng), DrawVividPlastic(rng), DrawDarkRubber(rng)}};
  if (Chance(rng, 0.6)) bottle.materials[kBody] = Painted(Colour::Constant(0.72F), 0.05F);
  Resurface(bottle.mesh, {kLabelSheet, false}, [&](const Vector3f& at, const Vector3f& normal) {
    return at.z() > 0.08F * body_m && at.z() < 0.52F * body_m && std::abs(normal.y()) > 0.6F;
  });
  MarkHeights(bottle.mesh, 0.18F * body_m, 0.95F * body_m);
  const float collar_m = Between(rng, 0.014F, 0.018F);
  const Mesh collar = RidgedCap(neck_m + 0.003F, collar_m, 28, {kHead, false});
  Append(bottle.mesh, MovedBy(collar, {0.0F, 0.0F, body_m - 0.003F}));
  const float length_m = Between(rng, 0.082F, 0.096F);
  const float half_height_m = Between(rng, 0.014F, 0.018F);
  const Vector3f head_m(-0.34F * length_m, 0.0F, body_m + collar_m + half_height_m);
  const Vector2f stem_m(0.62F * neck_m, 0.55F * neck_m);
  const Surface head{kHead, false};
  Append(bottle.mesh,
         LoftBody(std::vector<BodySection>{{body_m + 0.5F * collar_m, stem_m, 2.4F, 0.0F, head},
                                           {head_m.z(), 1.1F * stem_m, 2.4F, 0.0F, head}}));
  Append(bottle.mesh, MovedBy(SprayHead(length_m, half_height_m), head_m));
  const Vector3f lever_m = head_m + Vector3f(0.74F * length_m, 0.0F, -0.5F * half_height_m);
  Append(bottle.mesh, Lever(lever_m, Between(rng, 0.044F, 0.054F)));
  RestOnTable(bottle.mesh);
  return bottle;
}

}  // namespace handcraft::synthetic
