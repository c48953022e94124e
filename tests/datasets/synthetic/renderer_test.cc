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
