// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/depth_camera.h"

#include <cmath>
#include <numbers>
#include <string>

#include "datasets/synthetic/renderer.h"
#include "lib/core/error.h"
#include "tests/datasets/synthetic/small_scene.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using ::testing::HasSubstr;

constexpr float kPi = std::numbers::pi_v<float>;

TEST(AxialNoise, FollowsTheSource) {
  EXPECT_FLOAT_EQ(AxialNoise(0.4F, 0.3F), 0.0012F);
  EXPECT_FLOAT_EQ(AxialNoise(1.4F, 0.0F), 0.0031F);
  EXPECT_FLOAT_EQ(AxialNoise(1.4F, kPi / 3.0F), 0.0031F) << "angles count beyond 60°";
  // 75° = 5π/12: θ² / (π/2 − θ)² = 25, and 0.0001 · 25 / √1 is added.
  EXPECT_NEAR(AxialNoise(1.0F, kPi * 5.0F / 12.0F), 0.001884F + 0.0025F, 1e-6F);
}

TEST(LateralNoise, FollowsTheSource) {
  EXPECT_FLOAT_EQ(LateralNoise(0.0F), 0.8F);
  EXPECT_FLOAT_EQ(LateralNoise(kPi / 4.0F), 0.835F) << "θ = π/2 − θ";
}

// The slab alone, from straight above.
Scene FlatScene() {
  Scene scene = testing::SmallScene();
  scene.objects.pop_back();
  scene.camera.base_from_camera = LookAt({0.0F, -1e-4F, 1.0F}, Eigen::Vector3f::Zero(), 0.0F);
  return scene;
}

TEST(MeasureDepth, HasTheNoiseOfTheModelOnAPlane) {
  Rng rng = Rng::Stream(1, "depth");
  // Steps too small to add to the noise.
  const FloatImage depth = MeasureDepth(FlatScene(), {.disparity_step_px = 1e-4F}, rng);
  double sum = 0.0;
  double squares = 0.0;
  for (const float z : depth.values()) {
    ASSERT_GT(z, 0.9F) << "no hole in a plane";
    sum += static_cast<double>(z) - 1.0;
    squares += (static_cast<double>(z) - 1.0) * (static_cast<double>(z) - 1.0);
  }
  const auto count = static_cast<double>(depth.values().size());
  const double expected = 0.0012 + 0.0019 * 0.36;
  EXPECT_NEAR(sum / count, 0.0, 5.0 * expected / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), expected, 0.03 * expected) << "19200 draws: 0.5 %";
}

TEST(MeasureDepth, RoundsToStepsOfDisparity) {
  Rng rng = Rng::Stream(1, "depth");
  const DepthCameraOptions options{.disparity_step_px = 0.5F};
  const FloatImage depth = MeasureDepth(FlatScene(), options, rng);
  for (const float z : depth.values()) {
    const float steps = 131.25F * options.baseline_m / z / options.disparity_step_px;
    EXPECT_NEAR(steps, std::round(steps), 1e-3F);
  }
}

TEST(MeasureDepth, HasHolesInTheProjectorsShadowAndBesideSteps) {
  const Scene scene = testing::SmallScene();
  Rng rng = Rng::Stream(1, "depth");
  const FloatImage depth = MeasureDepth(scene, {.baseline_m = 0.5F}, rng);
  const auto at = [&](const Eigen::Vector3f& point) {
    const Eigen::Vector2f seen = scene.camera.Project(point);
    return depth.At(static_cast<int>(std::lround(seen.x())),
                    static_cast<int>(std::lround(seen.y())));
  };
  // The projector stands half a metre to the right: the box's shadow lies to the left of it.
  EXPECT_EQ(at({-0.075F, 0.0F, 0.0F}), 0.0F);
  EXPECT_NEAR(at({0.12F, 0.0F, 0.0F}), 1.0F, 0.02F);
  EXPECT_NEAR(at({0.0F, 0.0F, 0.1F}), 0.9F, 0.02F);
  const View view = Render(scene, scene.camera);
  int num_beside = 0;
  int num_holes = 0;
  for (int v = 1; v < 119; ++v) {
    for (int u = 1; u < 159; ++u) {
      if (view.object_mask.At(u, v) == view.object_mask.At(u + 1, v)) continue;
      if (view.object_mask.At(u, v) == 255) continue;
      ++num_beside;
      num_holes += depth.At(u, v) == 0.0F ? 1 : 0;
    }
  }
  EXPECT_GT(num_holes, num_beside / 3) << "beside the left edge";
}

TEST(MeasureDepth, MeasuresNothingOutOfRange) {
  Rng rng = Rng::Stream(1, "depth");
  const FloatImage depth = MeasureDepth(FlatScene(), {.farthest_m = 0.9F}, rng);
  for (const float z : depth.values()) ASSERT_EQ(z, 0.0F);
}

TEST(MeasureDepth, DependsOnItsStreamAlone) {
  const Scene scene = testing::SmallScene();
  const auto measure = [&](std::uint64_t seed) {
    Rng rng = Rng::Stream(seed, "depth");
    return MeasureDepth(scene, {}, rng).values();
  };
  EXPECT_EQ(measure(1), measure(1));
  EXPECT_NE(measure(1), measure(2));
}

TEST(DepthCameraOptions, RefusesWhatCannotBe) {
  const auto refuses = [](const DepthCameraOptions& options, const std::string& message) {
    EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(DepthCameraOptions().Validate());
  refuses({.baseline_m = 0.0F}, "DepthCameraOptions.baseline_m is 0; it must be in (0, 1]");
  refuses({.disparity_step_px = 0.0F}, "DepthCameraOptions.disparity_step_px is 0");
  refuses({.nearest_m = 0.0F}, "DepthCameraOptions.nearest_m is 0");
  refuses({.farthest_m = std::nanf("")}, "DepthCameraOptions.farthest_m is nan");
}

}  // namespace
}  // namespace handcraft::synthetic
