// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/projector.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/datasets/synthetic/small_scene.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

// The small scene with its rays cast.
struct Cast {
  Scene scene = testing::SmallScene();
  SceneGeometry geometry{scene};
  RayTracer tracer{geometry.meshes()};
  PixelHits pixels = CastPixels(tracer, geometry, scene.camera);
};

// A box of 0.1 m, a light at x = 0.5 and z = 0.5: its shadow on the table ends where the ray over
// the box's far upper edge meets z = 0, at x = −0.05 − 0.55 · 0.1 / 0.4 = −0.1875.
TEST(ReachedFrom, ThrowsTheShadowOfABox) {
  const Cast cast;
  const Image reached = ReachedFrom(cast.tracer, cast.pixels, {0.5F, 0.0F, 0.5F});
  const auto at = [&](const Vector3f& point) {
    const Eigen::Vector2f seen = cast.scene.camera.Project(point);
    return reached.At(static_cast<int>(std::lround(seen.x())),
                      static_cast<int>(std::lround(seen.y())));
  };
  EXPECT_EQ(at({0.1F, 0.0F, 0.0F}), 255) << "in front";
  EXPECT_EQ(at({0.0F, 0.0F, 0.1F}), 255) << "on top";
  EXPECT_EQ(at({-0.17F, 0.0F, 0.0F}), 0) << "in the shadow";
  EXPECT_EQ(at({-0.21F, 0.0F, 0.0F}), 255) << "behind it";
  EXPECT_EQ(at({-0.1F, 0.2F, 0.0F}), 255) << "beside it";
}

TEST(ReachedFrom, ReachesAllFromTheCameraItself) {
  const Cast cast;
  const Image reached = ReachedFrom(cast.tracer, cast.pixels, cast.scene.camera.Origin());
  int num_dark = 0;
  for (const std::uint8_t value : reached.values()) num_dark += value == 0 ? 1 : 0;
  EXPECT_LT(num_dark, 20) << "but for grazing rays along the box's edges";
}

TEST(DotPattern, IsHalfBrightAndBlendsBetweenItsCells) {
  Rng rng = Rng::Stream(1, "dots");
  const DotPattern pattern(2.0F, rng);
  double sum = 0.0;
  for (int v = 0; v < 100; ++v) {
    for (int u = 0; u < 100; ++u) {
      const float own = pattern.At(2.0F * static_cast<float>(u), 2.0F * static_cast<float>(v));
      const float next = pattern.At(2.0F * static_cast<float>(u + 1), 2.0F * static_cast<float>(v));
      EXPECT_TRUE(own == 0.0F || own == 1.0F) << "on a cell";
      EXPECT_FLOAT_EQ(pattern.At(2.0F * static_cast<float>(u) + 1.0F, 2.0F * static_cast<float>(v)),
                      0.5F * (own + next));
      sum += static_cast<double>(own);
    }
  }
  EXPECT_NEAR(sum / 1e4, 0.5, 0.02) << "four standard deviations";
  EXPECT_EQ(pattern.At(-2.0F, -6.0F), pattern.At(2046.0F, 2042.0F)) << "repeats itself";
}

TEST(ProjectPattern, BrightensWhatIsReachedByThePatternThere) {
  const Cast cast;
  Rng rng = Rng::Stream(1, "dots");
  const DotPattern pattern(2.5F, rng);
  const PinholeCamera projector = RightOf(cast.scene.camera, 0.06F);
  Image reached(160, 120, 1, 255);
  reached.At(10, 20) = 0;
  FloatImage light(160, 120, 3, 0.5F);
  ProjectPattern(pattern, projector, reached, cast.pixels, 2.0F, light);
  EXPECT_EQ(light.At(10, 20, 0), 0.5F);
  // On the table at depth z the projector sees pixel (u, v) by its baseline's disparity to the
  // left.
  const float z = cast.pixels.At(30, 40).distance;
  EXPECT_NEAR(light.At(30, 40, 2),
              0.5F * (1.0F + 2.0F * pattern.At(30.0F - 131.25F * 0.06F / z, 40.0F)),
              1e-4F)
      << "places in single precision";
}

}  // namespace
}  // namespace handcraft::synthetic
