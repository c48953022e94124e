// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/stereo_camera.h"

#include <algorithm>
#include <string>

#include "datasets/synthetic/depth_cloud.h"
#include "datasets/synthetic/projector.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

constexpr float kDotCellPx = 2.5F;
constexpr float kDotGain = 2.0F;

PinholeCamera WiderToTheLeft(PinholeCamera camera, int columns) {
  camera.width_px += columns;
  camera.centre_u_px += static_cast<float>(columns);
  return camera;
}

// The picture without its first columns.
template <class T>
BasicImage<T> WithoutLeft(const BasicImage<T>& image, int columns) {
  BasicImage<T> cut(image.width() - columns, image.height(), image.channels());
  const std::ptrdiff_t skipped = static_cast<std::ptrdiff_t>(columns) * image.channels();
  for (int v = 0; v < cut.height(); ++v) {
    std::copy_n(image.Row(v) + skipped,
                static_cast<std::ptrdiff_t>(cut.width()) * cut.channels(),
                cut.Row(v));
  }
  return cut;
}

// The light of a view as it is while the dots are thrown.
FloatImage LightWithDots(const Scene& scene,
                         const PinholeCamera& camera,
                         const PinholeCamera& projector,
                         const DotPattern& pattern,
                         const FloatImage& light) {
  const SceneGeometry geometry(scene);
  const RayTracer tracer(geometry.meshes());
  const PixelHits pixels = CastPixels(tracer, geometry, camera);
  FloatImage lit = light;
  ProjectPattern(
      pattern, projector, ReachedFrom(tracer, pixels, projector.Origin()), pixels, kDotGain, lit);
  return lit;
}

}  // namespace

void StereoOptions::Validate() const {
  const auto require = [](bool holds, const std::string& field, float value, const char* rule) {
    RequireOption(holds, "StereoOptions." + field, value, rule);
  };
  require(baseline_m > 0.0F && baseline_m <= 1.0F, "baseline_m", baseline_m, "in (0, 1]");
  require(farthest_m <= 100.0F && farthest_m > 0.1F, "farthest_m", farthest_m, "in (0.1, 100]");
  require(nearest_m >= 0.1F && nearest_m < farthest_m,
          "nearest_m",
          nearest_m,
          "0.1 or more and less than farthest_m");
}

int NumDisparities(const PinholeCamera& camera, const StereoOptions& options) {
  return perception::NumDisparities(camera.focal_px, options.baseline_m, options.nearest_m);
}

StereoShot TakeStereo(const Scene& scene,
                      const StereoOptions& options,
                      std::uint64_t seed,
                      std::string_view name) {
  const int columns = NumDisparities(scene.camera, options);
  const PinholeCamera left = WiderToTheLeft(scene.camera, columns);
  const PinholeCamera right = RightOf(left, options.baseline_m);
  const View left_view = Render(scene, left);
  const View right_view = Render(scene, right);
  const auto develop = [&](const FloatImage& light, const char* what) {
    Rng noise = Rng::Stream(seed, std::string(name) + " " + what);
    return Develop(light, scene.sensor, noise);
  };
  const Image left_image = develop(left_view.light, "left noise");
  const Image right_image = develop(right_view.light, "right noise");
  FloatImage disparity_px;
  if (options.has_projector) {
    const PinholeCamera projector = RightOf(scene.camera, 0.5F * options.baseline_m);
    Rng dots = Rng::Stream(seed, "dots");
    const DotPattern pattern(kDotCellPx, dots);
    disparity_px = perception::MatchPair(
        develop(LightWithDots(scene, left, projector, pattern, left_view.light), "left dots"),
        develop(LightWithDots(scene, right, projector, pattern, right_view.light), "right dots"),
        options.matcher,
        columns);
  } else {
    disparity_px = perception::MatchPair(left_image, right_image, options.matcher, columns);
  }
  const FloatImage depth_m = perception::DepthOfDisparity(
      disparity_px, scene.camera.focal_px, options.baseline_m, options.farthest_m);
  return {.view = {.light = WithoutLeft(left_view.light, columns),
                   .labels = WithoutLeft(left_view.labels, columns),
                   .object_mask = WithoutLeft(left_view.object_mask, columns),
                   .depth = WithoutLeft(left_view.depth, columns)},
          .image = WithoutLeft(left_image, columns),
          .right_image = WithoutLeft(right_image, columns),
          .cloud = CloudFromDepth(WithoutLeft(depth_m, columns), scene.camera)};
}

}  // namespace handcraft::synthetic
