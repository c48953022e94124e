// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/renderer.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "datasets/formats/labelled_image_set.h"
#include "tests/datasets/synthetic/small_scene.h"

namespace handcraft::synthetic {
namespace {

using datasets::kMaskBad;
using datasets::kMaskDontCare;
using datasets::kMaskGood;
using Eigen::Vector2f;
using Eigen::Vector3f;

TEST(Render, PutsThePartWhereItProjectsTo) {
  const Scene scene = testing::SmallScene();
  const View view = Render(scene, scene.camera);
  // The top face covers what the box's graspable half covers from almost straight above.
  const Vector2f first = scene.camera.Project({-0.05F, 0.05F, 0.1F});
  const Vector2f last = scene.camera.Project({0.05F, -0.05F, 0.1F});
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const Vector2f at(static_cast<float>(u), static_cast<float>(v));
      const Vector2f inside = (at - first).cwiseMin(last - at);
      const std::uint8_t label = view.labels.At(u, v);
      if (inside.minCoeff() > 1.5F) {
        EXPECT_EQ(label, kMaskGood) << u << ' ' << v;
      }
      if (inside.minCoeff() < -2.0F) {
        EXPECT_EQ(label, kMaskBad) << u << ' ' << v;
      }
      if (inside.minCoeff() > 0.5F) {
        EXPECT_EQ(view.object_mask.At(u, v), 255);
      }
      if (inside.minCoeff() < -2.0F) {
        EXPECT_EQ(view.object_mask.At(u, v), 0);
      }
    }
  }
}

TEST(Render, CallsThePartsEdgeNeitherGoodNorBad) {
  const Scene scene = testing::SmallScene();
  const View view = Render(scene, scene.camera);
  const auto count = [&](std::uint8_t value) {
    return std::count(view.labels.values().begin(), view.labels.values().end(), value);
  };
  EXPECT_GT(count(kMaskGood), 150);
  EXPECT_GT(count(kMaskDontCare), 10);
  EXPECT_LT(count(kMaskDontCare), 80) << "one pixel wide: the outline is about 58 pixels long";
  EXPECT_EQ(count(kMaskGood) + count(kMaskDontCare) + count(kMaskBad), 160 * 120);
}

TEST(Render, GivesTheDepthOfTableAndBox) {
  const Scene scene = testing::SmallScene();
  const View view = Render(scene, scene.camera);
  const Vector2f top = scene.camera.Project({0.0F, 0.0F, 0.1F});
  const Vector3f ray = scene.camera.Ray(std::round(top.x()), std::round(top.y()));
  EXPECT_NEAR(
      view.depth.At(static_cast<int>(std::round(top.x())), static_cast<int>(std::round(top.y()))),
      -0.9F / ray.z(),
      1e-4F);
  EXPECT_NEAR(view.depth.At(3, 3), -1.0F / scene.camera.Ray(3.0F, 3.0F).z(), 1e-4F);
}

TEST(Render, LightsADiffusePlaneAsLambertSays) {
  Scene scene = testing::SmallScene();
  scene.objects.pop_back();
  Material& matt = scene.objects[0].object.materials[0];
  matt = {.base = Colour::Constant(0.5F), .second = Colour::Constant(0.5F), .specular = 0.0F};
  scene.ambient = Colour::Zero();
  const View view = Render(scene, scene.camera);
  for (const int u : {5, 80, 150}) {
    const Vector3f at = scene.camera.Origin() +
                        view.depth.At(u, 60) * scene.camera.Ray(static_cast<float>(u), 60.0F);
    const Vector3f to_light = scene.light.centre_m - at;
    const float expected = 0.5F * to_light.normalized().z() / to_light.squaredNorm();
    EXPECT_NEAR(view.light.At(u, 60, 1), expected, 1e-5F);
  }
}

// The small scene with a matt slab and, instead of the box, one of this material; no light around.
Scene SceneUnder(const Material& material) {
  Scene scene = testing::SmallScene();
  scene.objects[0].object.materials[0] = {
      .base = Colour::Constant(0.5F), .second = Colour::Constant(0.5F), .specular = 0.0F};
  scene.objects[1].object.materials[0] = material;
  scene.ambient = Colour::Zero();
  return scene;
}

TEST(Render, SeesThroughAClearBoxAsIfItWereNotThere) {
  const Scene scene = SceneUnder(
      {.base = Colour::Ones(), .second = Colour::Ones(), .specular = 0.0F, .transmission = 1.0F});
  Scene without = scene;
  without.objects.pop_back();
  const View view = Render(scene, scene.camera);
  const View bare = Render(without, scene.camera);
  // Through top and bottom; the sides, seen at a grazing angle, mirror Fresnel's share.
  const Vector2f first = scene.camera.Project({-0.05F, 0.05F, 0.0F});
  const Vector2f last = scene.camera.Project({0.05F, -0.05F, 0.0F});
  int num_inside = 0;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const Vector2f at(static_cast<float>(u), static_cast<float>(v));
      const bool is_inside = (at - first).cwiseMin(last - at).minCoeff() > 2.0F;
      if (view.object_mask.At(u, v) == 255 && !is_inside) continue;
      num_inside += is_inside ? 1 : 0;
      if (view.labels.At(u, v) == kMaskDontCare) continue;
      EXPECT_NEAR(view.light.At(u, v), bare.light.At(u, v), 1e-5F) << u << ' ' << v;
    }
  }
  EXPECT_GT(num_inside, 60);
}

TEST(Render, TintsWhatIsBehindAClearBoxAndKeepsItsLabelAndDepth) {
  const Material half{.base = Colour(0.8F, 0.6F, 0.4F),
                      .second = Colour(0.8F, 0.6F, 0.4F),
                      .specular = 0.0F,
                      .transmission = 0.5F};
  const Scene scene = SceneUnder(half);
  const View view = Render(scene, scene.camera);
  const Vector2f top = scene.camera.Project({0.0F, 0.0F, 0.1F});
  const int u = static_cast<int>(std::round(top.x()));
  const int v = static_cast<int>(std::round(top.y()));
  EXPECT_EQ(view.labels.At(u, v), kMaskGood);
  EXPECT_EQ(view.object_mask.At(u, v), 255);
  const Vector3f ray = scene.camera.Ray(static_cast<float>(u), static_cast<float>(v));
  EXPECT_NEAR(view.depth.At(u, v), -0.9F / ray.z(), 1e-4F);
  for (int channel = 0; channel < 3; ++channel) {
    // Half of what the top gets is scattered there; through it the slab is seen, on which the
    // bottom lies. The light is 2 m above the slab and 1.9 m above the top.
    const float passing = 0.5F * half.base[channel];
    const float expected =
        0.5F * half.base[channel] / (1.9F * 1.9F) + passing * 0.5F / (2.0F * 2.0F);
    EXPECT_NEAR(view.light.At(u, v, channel), expected, 0.01F * expected);
  }
}

TEST(Render, LetsClearThingsCastNoShadow) {
  const auto light_beside = [](float transmission) {
    Scene scene = SceneUnder({.specular = 0.0F, .transmission = transmission});
    scene.light.centre_m = {-2.0F, 0.0F, 2.0F};  // the shadow falls towards +x
    const View view = Render(scene, scene.camera);
    const Vector2f at = scene.camera.Project({0.09F, 0.0F, 0.0F});
    return view.light.At(static_cast<int>(std::round(at.x())),
                         static_cast<int>(std::round(at.y())));
  };
  EXPECT_LT(light_beside(0.0F), 0.01F);
  EXPECT_GT(light_beside(0.9F), 0.03F);
}

TEST(Render, LeavesUnknownWhereNothingIs) {
  Scene scene = testing::SmallScene();
  scene.camera.base_from_camera = LookAt({0.0F, 0.0F, 1.0F}, {0.0F, 1.0F, 1.5F}, 0.0F);
  const View view = Render(scene, scene.camera);
  EXPECT_EQ(view.depth.At(80, 60), 0.0F);
  EXPECT_EQ(view.labels.At(80, 60), kMaskBad);
  EXPECT_EQ(view.light.At(80, 60, 0), scene.ambient[0]);
}

TEST(Render, GivesTheSameValuesAgain) {
  Rng rng = Rng::Stream(1, "scene");
  const Object object = ClassesOf(Family::kTrained)[3].draw(rng);
  Scene scene = DrawScene(std::span(&object, 1), rng);
  scene.camera.width_px = 161;  // neither a packet nor a block fits
  scene.camera.height_px = 121;
  const View first = Render(scene, scene.camera);
  const View again = Render(scene, scene.camera);
  EXPECT_EQ(first.light.values(), again.light.values());
  EXPECT_EQ(first.labels.values(), again.labels.values());
  EXPECT_EQ(first.depth.values(), again.depth.values());
}

}  // namespace
}  // namespace handcraft::synthetic
