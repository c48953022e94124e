// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/stereo_camera.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/core/error.h"
#include "tests/datasets/synthetic/small_scene.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using ::testing::HasSubstr;

TEST(NumDisparities, CoversTheNearestPoint) {
  EXPECT_EQ(NumDisparities({}, {}), 160) << "525 · 0.12 / 0.4 = 157.5";
  EXPECT_EQ(NumDisparities({.focal_px = 131.25F}, {}), 48);
  EXPECT_EQ(NumDisparities({.focal_px = 100.0F}, {.baseline_m = 0.05F, .nearest_m = 1.0F}), 16);
}

TEST(StereoOptions, RefusesWhatCannotBe) {
  const auto refuses = [](const StereoOptions& options, const std::string& message) {
    EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(StereoOptions().Validate());
  refuses({.baseline_m = 0.0F}, "StereoOptions.baseline_m is 0; it must be in (0, 1]");
  refuses({.baseline_m = std::nanf("")}, "StereoOptions.baseline_m is nan");
  refuses({.nearest_m = 2.0F}, "StereoOptions.nearest_m is 2; it must be 0.1 or more and less");
  refuses({.farthest_m = 1000.0F}, "StereoOptions.farthest_m is 1000");
}

// A scene that a quarter of the usual camera sees from 0.6 m, with a floor and a table of noise.
Scene TexturedScene() {
  Scene scene = testing::SmallScene();
  for (PlacedObject& placed : scene.objects) {
    placed.object.materials[0].pattern = Pattern::kSpeckled;
    placed.object.materials[0].scale_m = 0.006F;
  }
  scene.camera.base_from_camera =
      LookAt({-0.5F, 0.0F, 0.4F}, Eigen::Vector3f(0.0F, 0.0F, 0.05F), 0.0F);
  return scene;
}

// Shares of the object's pixels that were measured, and of those within 2 % of their true depth.
struct Quality {
  double measured = 0.0;
  double close = 0.0;
};
Quality QualityOf(const StereoShot& shot, const PinholeCamera& camera) {
  double num_object = 0.0;
  double num_measured = 0.0;
  double num_close = 0.0;
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      if (shot.view.object_mask.At(u, v) == 0) continue;
      ++num_object;
      const Eigen::Vector3f& point = shot.cloud.At(u, v);
      if (!datasets::IsMeasured(point)) continue;
      ++num_measured;
      const float depth = (camera.base_from_camera.inverse() * point).z();
      const float truth = shot.view.depth.At(u, v);
      if (std::abs(depth - truth) < 0.02F * truth) ++num_close;
    }
  }
  return {num_measured / num_object, num_close / num_measured};
}

TEST(TakeStereo, MeasuresATexturedBox) {
  const Scene scene = TexturedScene();
  const StereoShot shot = TakeStereo(scene, {}, 1, "box");
  EXPECT_EQ(shot.image.width(), 160);
  EXPECT_EQ(shot.right_image.width(), 160);
  EXPECT_EQ(shot.cloud.points.size(), 160U * 120U);
  const Quality quality = QualityOf(shot, scene.camera);
  EXPECT_GT(quality.measured, 0.6);
  EXPECT_GT(quality.close, 0.8);
}

TEST(TakeStereo, KeepsTheFirstColumns) {
  const StereoShot shot = TakeStereo(TexturedScene(), {}, 1, "box");
  int num_measured = 0;
  for (int v = 60; v < 120; ++v) num_measured += datasets::IsMeasured(shot.cloud.At(3, v)) ? 1 : 0;
  EXPECT_GT(num_measured, 20) << "the table in front";
}

TEST(TakeStereo, SeesTheSameWithoutTheWidening) {
  const Scene scene = TexturedScene();
  const StereoShot shot = TakeStereo(scene, {}, 1, "box");
  const View view = Render(scene, scene.camera);
  EXPECT_EQ(shot.view.object_mask.values(), view.object_mask.values());
  float farthest_m = 0.0F;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      farthest_m = std::max(farthest_m, std::abs(shot.view.depth.At(u, v) - view.depth.At(u, v)));
    }
  }
  EXPECT_LT(farthest_m, 1e-5F);
}

TEST(TakeStereo, NeedsThePatternOnABareBox) {
  Scene scene = TexturedScene();
  for (PlacedObject& placed : scene.objects) placed.object.materials[0].pattern = Pattern::kPlain;
  const StereoShot passive = TakeStereo(scene, {}, 1, "box");
  const StereoShot active = TakeStereo(scene, {.has_projector = true}, 1, "box");
  const Quality bare = QualityOf(passive, scene.camera);
  const Quality dotted = QualityOf(active, scene.camera);
  EXPECT_GT(dotted.measured * dotted.close, bare.measured * bare.close + 0.1);
  EXPECT_GT(dotted.close, 0.75);
  EXPECT_EQ(active.image.values(), passive.image.values()) << "the picture is kept without dots";
}

TEST(TakeStereo, LeavesOutWhatIsFar) {
  const StereoShot shot = TakeStereo(TexturedScene(), {.farthest_m = 0.7F}, 1, "box");
  const PinholeCamera camera = TexturedScene().camera;
  for (const Eigen::Vector3f& point : shot.cloud.points) {
    if (!datasets::IsMeasured(point)) continue;
    EXPECT_LE((camera.base_from_camera.inverse() * point).z(), 0.7001F);
  }
}

TEST(TakeStereo, DependsOnItsStreamAlone) {
  const Scene scene = TexturedScene();
  const StereoShot first = TakeStereo(scene, {}, 1, "box");
  EXPECT_EQ(TakeStereo(scene, {}, 1, "box").image.values(), first.image.values());
  EXPECT_NE(TakeStereo(scene, {}, 2, "box").image.values(), first.image.values());
  EXPECT_NE(TakeStereo(scene, {}, 1, "can").image.values(), first.image.values());
}

}  // namespace
}  // namespace handcraft::synthetic
