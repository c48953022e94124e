// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/measured_view.h"

#include <string>
#include <utility>

#include "datasets/synthetic/depth_camera.h"
#include "datasets/synthetic/depth_cloud.h"
#include "datasets/synthetic/stereo_camera.h"
#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

MeasuredView WithStereo(const Scene& scene,
                        const StereoOptions& options,
                        std::uint64_t seed,
                        std::string_view name) {
  StereoShot shot = TakeStereo(scene, options, seed, name);
  return {std::move(shot.view), std::move(shot.image), std::move(shot.cloud)};
}

}  // namespace

std::string_view NameOf(CloudSensor sensor) {
  switch (sensor) {
    case CloudSensor::kStereo:
      return "stereo";
    case CloudSensor::kStereoBlockMatching:
      return "stereo-bm";
    case CloudSensor::kStereoActive:
      return "stereo-active";
    case CloudSensor::kDepthCamera:
      return "depth-camera";
    case CloudSensor::kPerfect:
      return "perfect";
  }
  HC_CHECK(false, static_cast<int>(sensor));
  return {};
}

MeasuredView MeasureView(const Scene& scene,
                         CloudSensor sensor,
                         float baseline_m,
                         std::uint64_t seed,
                         std::string_view name) {
  StereoOptions stereo{.baseline_m = baseline_m};
  switch (sensor) {
    case CloudSensor::kStereo:
      return WithStereo(scene, stereo, seed, name);
    case CloudSensor::kStereoBlockMatching:
      stereo.matcher = StereoMatcher::kBlock;
      return WithStereo(scene, stereo, seed, name);
    case CloudSensor::kStereoActive:
      stereo.has_projector = true;
      return WithStereo(scene, stereo, seed, name);
    case CloudSensor::kDepthCamera:
    case CloudSensor::kPerfect:
      break;
  }
  View view = Render(scene, scene.camera);
  Rng noise = Rng::Stream(seed, std::string(name) + " noise");
  Image image = Develop(view.light, scene.sensor, noise);
  FloatImage depth = view.depth;
  if (sensor == CloudSensor::kDepthCamera) {
    Rng rng = Rng::Stream(seed, std::string(name) + " depth");
    depth = MeasureDepth(scene, {}, rng);
  }
  return {std::move(view), std::move(image), CloudFromDepth(depth, scene.camera)};
}

}  // namespace handcraft::synthetic
