// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/measured_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/datasets/synthetic/small_scene.h"

namespace handcraft::synthetic {
namespace {

constexpr std::array<CloudSensor, 5> kSensors = {CloudSensor::kStereo,
                                                 CloudSensor::kStereoBlockMatching,
                                                 CloudSensor::kStereoActive,
                                                 CloudSensor::kDepthCamera,
                                                 CloudSensor::kPerfect};

// The box among specks, from 0.6 m.
Scene BoxFromTheRobot() {
  Scene scene = testing::SmallScene();
  for (PlacedObject& placed : scene.objects) {
    placed.object.materials[0].pattern = Pattern::kSpeckled;
    placed.object.materials[0].scale_m = 0.006F;
  }
  scene.camera.base_from_camera =
      LookAt({-0.5F, 0.0F, 0.4F}, Eigen::Vector3f(0.0F, 0.0F, 0.05F), 0.0F);
  return scene;
}

// Median distance of the object's measured points from their true depth, along the axis [m].
float MedianError(const MeasuredView& taken, const PinholeCamera& camera) {
  std::vector<float> errors;
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      const Eigen::Vector3f& point = taken.cloud.At(u, v);
      if (taken.view.object_mask.At(u, v) == 0 || !datasets::IsMeasured(point)) continue;
      const float depth = (camera.base_from_camera.inverse() * point).z();
      errors.push_back(std::abs(depth - taken.view.depth.At(u, v)));
    }
  }
  EXPECT_GT(errors.size(), 100U);
  if (errors.empty()) return 1.0F;
  std::nth_element(
      errors.begin(), errors.begin() + static_cast<int>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

TEST(MeasureView, MeasuresWithEverySensor) {
  const Scene scene = BoxFromTheRobot();
  for (const CloudSensor sensor : kSensors) {
    const MeasuredView taken = MeasureView(scene, sensor, 0.12F, 1, "box");
    EXPECT_EQ(taken.image.width(), 160) << NameOf(sensor);
    EXPECT_EQ(taken.cloud.width, 160) << NameOf(sensor);
    // One disparity is 26 mm at a quarter of the resolution.
    EXPECT_LT(MedianError(taken, scene.camera), 0.015F) << NameOf(sensor);
    EXPECT_TRUE(taken.cloud.base_from_camera.isApprox(scene.camera.base_from_camera));
  }
}

TEST(MeasureView, KnowsEveryPointWithoutFaultWhenPerfect) {
  const Scene scene = BoxFromTheRobot();
  const MeasuredView taken = MeasureView(scene, CloudSensor::kPerfect, 0.12F, 1, "box");
  EXPECT_LT(MedianError(taken, scene.camera), 1e-5F);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      EXPECT_EQ(datasets::IsMeasured(taken.cloud.At(u, v)), taken.view.depth.At(u, v) > 0.0F);
    }
  }
}

TEST(NameOf, TellsSensorsApart) {
  EXPECT_EQ(NameOf(CloudSensor::kStereo), "stereo");
  EXPECT_EQ(NameOf(CloudSensor::kStereoBlockMatching), "stereo-bm");
  EXPECT_EQ(NameOf(CloudSensor::kStereoActive), "stereo-active");
  EXPECT_EQ(NameOf(CloudSensor::kDepthCamera), "depth-camera");
  EXPECT_EQ(NameOf(CloudSensor::kPerfect), "perfect");
}

}  // namespace
}  // namespace handcraft::synthetic
