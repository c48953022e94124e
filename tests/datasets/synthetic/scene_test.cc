// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

std::vector<const PlacedObject*> TargetsOf(const Scene& scene) {
  std::vector<const PlacedObject*> targets;
  for (const PlacedObject& placed : scene.objects) {
    if (placed.is_target) targets.push_back(&placed);
  }
  return targets;
}

TEST(DrawScene, KeepsTwoTargetsApartOnTheTableAndInThePicture) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Rng rng = Rng::Stream(1, "scene", i);
    const ObjectClass& kind = ClassesOf(Family::kTrained)[i % 9];
    const std::vector<Object> objects = {kind.draw(rng), kind.draw(rng)};
    const Scene scene = DrawScene(objects, rng);
    const auto targets = TargetsOf(scene);
    ASSERT_EQ(targets.size(), 2U);
    float reach_m = 0.0F;
    for (const PlacedObject* target : targets) {
      EXPECT_EQ(target->base_from_object.translation().z(), 0.0F);
      float farthest_m = 0.0F;
      for (const Vector3f& vertex : target->object.mesh.vertices) {
        farthest_m = std::max(farthest_m, vertex.head<2>().norm());
      }
      reach_m += farthest_m;
      const Vector2f seen = scene.camera.Project(target->base_from_object.translation());
      EXPECT_TRUE(seen.x() > 0.0F && seen.x() < 639.0F && seen.y() > 0.0F && seen.y() < 479.0F);
    }
    const Vector3f apart =
        targets[0]->base_from_object.translation() - targets[1]->base_from_object.translation();
    EXPECT_GT(apart.norm(), reach_m);
  }
}

TEST(DrawScene, LightsFromAboveAndLooksDown) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Rng rng = Rng::Stream(2, "scene", i);
    const Object object = ClassesOf(Family::kNovel)[i % 6].draw(rng);
    const Scene scene = DrawScene(std::span(&object, 1), rng);
    EXPECT_GT(scene.light.centre_m.z(), 0.5F);
    EXPECT_LT(scene.light.half_u_m.dot(scene.light.centre_m), 1e-4F) << "faces the table";
    EXPECT_GT(scene.camera.Origin().z(), 0.1F);
    EXPECT_LT(scene.camera.Ray(319.5F, 239.5F).z(), 0.0F);
    EXPECT_GT(scene.ambient.minCoeff(), 0.0F);
  }
}

TEST(MakeBare, LeavesTargetsAndAPlainRoom) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rng rng = Rng::Stream(seed, "bare");
    const std::vector<Object> targets(2, ClassesOf(Family::kTrained)[seed % 9].draw(rng));
    Scene scene = DrawScene(targets, rng);
    const Scene before = scene;
    MakeBare(scene);
    ASSERT_EQ(scene.objects.size(), 6U + 2U) << "table, floor, four walls and the targets";
    for (const PlacedObject& placed : scene.objects) {
      if (placed.is_target) continue;
      for (const Material& material : placed.object.materials) {
        EXPECT_EQ(material.pattern, Pattern::kPlain);
      }
    }
    EXPECT_EQ(scene.objects[7].object.materials.size(), targets[1].materials.size());
    EXPECT_TRUE(
        scene.objects[7].base_from_object.isApprox(before.objects[7].base_from_object, 0.0F));
    EXPECT_EQ(scene.light.centre_m, before.light.centre_m);
  }
}

TEST(DrawScene, DependsOnItsStreamAlone) {
  Rng rng = Rng::Stream(1, "object");
  const Object object = ClassesOf(Family::kTrained)[0].draw(rng);
  const auto draw = [&](std::uint64_t seed) {
    Rng stream = Rng::Stream(seed, "scene");
    return DrawScene(std::span(&object, 1), stream);
  };
  EXPECT_EQ(draw(1).camera.Origin(), draw(1).camera.Origin());
  EXPECT_EQ(draw(1).objects.size(), draw(1).objects.size());
  EXPECT_NE(draw(1).camera.Origin(), draw(2).camera.Origin());
}

}  // namespace
}  // namespace handcraft::synthetic
