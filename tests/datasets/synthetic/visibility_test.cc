// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/visibility.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/datasets/synthetic/small_scene.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// A scene with its rays cast.
struct Cast {
  explicit Cast(const Scene& scene)
      : geometry(scene),
        tracer(geometry.meshes()),
        pixels(CastPixels(tracer, geometry, scene.camera)) {}
  SceneGeometry geometry;
  RayTracer tracer;
  PixelHits pixels;
};

TEST(CastPixels, GivesTheDepthOfAPlaneInClosedForm) {
  Scene scene = testing::SmallScene();
  scene.objects.pop_back();
  scene.camera.base_from_camera = LookAt({0.0F, -0.4F, 0.8F}, Vector3f::Zero(), 0.05F);
  const Cast cast(scene);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const Vector3f ray = scene.camera.Ray(static_cast<float>(u), static_cast<float>(v));
      EXPECT_NEAR(cast.pixels.At(u, v).distance, -0.8F / ray.z(), 1e-5F);
    }
  }
}

// The light that a point of the table sees past the box, by many rays: the oracle.
float BruteForceVisibility(const Cast& cast, const Scene& scene, const Vector3f& point) {
  int num_lit = 0;
  constexpr int kSide = 40;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; column += 4) {
      RayPacket rays;
      for (int i = 0; i < 4; ++i) {
        const float s = 2.0F * (static_cast<float>(column + i) + 0.5F) / kSide - 1.0F;
        const float t = 2.0F * (static_cast<float>(row) + 0.5F) / kSide - 1.0F;
        const Vector3f on_light =
            scene.light.centre_m + s * scene.light.half_u_m + t * scene.light.half_v_m;
        rays.Add(point, on_light - point, 1.0F);
      }
      for (const bool blocked : cast.tracer.IsBlocked(rays)) num_lit += blocked ? 0 : 1;
    }
  }
  return static_cast<float>(num_lit) / (kSide * kSide);
}

TEST(LightVisibility, AgreesWithManyRays) {
  Scene scene = testing::SmallScene();
  scene.light.centre_m = {0.8F, 0.3F, 1.2F};
  const Cast cast(scene);
  const FloatImage visible = LightVisibility(cast.tracer, cast.pixels, scene.light);
  Rng rng = Rng::Stream(1, "pixels");
  double worst = 0.0;
  double sum = 0.0;
  int num_partial = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto u = static_cast<int>(rng.UniformInt(160));
    const auto v = static_cast<int>(rng.UniformInt(120));
    if (cast.pixels.At(u, v).mesh != 0) continue;
    const SurfacePoint& point = cast.pixels.PointAt(u, v);
    const float expected =
        BruteForceVisibility(cast, scene, point.p_in_base + 2e-4F * point.normal);
    const double error = static_cast<double>(std::abs(visible.At(u, v) - expected));
    num_partial += expected > 0.05F && expected < 0.95F ? 1 : 0;
    worst = std::max(worst, error);
    sum += error;
  }
  EXPECT_GT(num_partial, 20) << "the penumbra is there";
  EXPECT_LT(sum / 3000, 0.01);
  EXPECT_LT(worst, 0.3) << "a pixel here is 8 mm wide, and smoothing takes its neighbours";
}

TEST(LightVisibility, IsNothingOnSurfacesTurnedAway) {
  Scene scene = testing::SmallScene();
  scene.light.centre_m = {0.0F, 0.0F, -2.0F};
  const Cast cast(scene);
  const FloatImage visible = LightVisibility(cast.tracer, cast.pixels, scene.light);
  for (const float value : visible.values()) EXPECT_EQ(value, 0.0F);
}

TEST(SkyVisibility, IsFullInTheOpenAndLessInACorner) {
  const Scene scene = testing::SmallScene();
  const Cast cast(scene);
  const FloatImage visible = SkyVisibility(cast.tracer, cast.pixels);
  for (const float value : visible.values()) {
    EXPECT_GE(value, 0.0F);
    EXPECT_LE(value, 1.0F + 1e-5F);
  }
  EXPECT_NEAR(visible.At(2, 2), 1.0F, 1e-4F) << "0.6 m from the box";
  const Vector2f corner = scene.camera.Project({0.065F, 0.0F, 0.0F});
  const Vector2f away = scene.camera.Project({0.3F, 0.0F, 0.0F});
  const auto at = [&](const Vector2f& pixel) {
    return visible.At(static_cast<int>(std::lround(pixel.x())),
                      static_cast<int>(std::lround(pixel.y())));
  };
  EXPECT_LT(at(corner), 0.8F) << "a wall takes up to half of the sky";
  EXPECT_GT(at(away), at(corner) + 0.1F);
}

}  // namespace
}  // namespace handcraft::synthetic
