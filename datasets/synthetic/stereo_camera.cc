// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/stereo_camera.h"

#include <cmath>
#include <limits>
#include <string>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/synthetic/depth_cloud.h"
#include "datasets/synthetic/projector.h"
#include "lib/core/check.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr int kDisparityStep = 16;  // OpenCV searches multiples of it
constexpr float kDisparityUnit = 1.0F / 16.0F;
constexpr int kSpeckleSize = 100;
constexpr int kSpeckleRange = 2;
constexpr int kUniquenessPercent = 10;
constexpr float kDotCellPx = 2.5F;
constexpr float kDotGain = 2.0F;

cv::Mat Gray(const Image& image) {
  HC_CHECK(image.channels() == 3, image.channels());
  // OpenCV has no read-only matrix; the pixels are only read.
  const cv::Mat colours(
      image.height(), image.width(), CV_8UC3, const_cast<std::uint8_t*>(image.Row(0)));
  cv::Mat gray;
  cv::cvtColor(colours, gray, cv::COLOR_BGR2GRAY);
  return gray;
}

cv::Ptr<cv::StereoMatcher> MakeMatcher(StereoMatcher matcher, int num_disparities) {
  if (matcher == StereoMatcher::kSemiGlobal) {
    constexpr int kBlock = 5;
    constexpr int kP1 = 8 * kBlock * kBlock;
    constexpr int kP2 = 32 * kBlock * kBlock;
    return cv::StereoSGBM::create(0,
                                  num_disparities,
                                  kBlock,
                                  kP1,
                                  kP2,
                                  1,
                                  0,
                                  kUniquenessPercent,
                                  kSpeckleSize,
                                  kSpeckleRange);
  }
  constexpr int kBlock = 15;
  const cv::Ptr<cv::StereoBM> blocks = cv::StereoBM::create(num_disparities, kBlock);
  blocks->setUniquenessRatio(kUniquenessPercent);
  blocks->setSpeckleWindowSize(kSpeckleSize);
  blocks->setSpeckleRange(kSpeckleRange);
  blocks->setDisp12MaxDiff(1);
  return blocks;
}

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

FloatImage DepthFromDisparity(const FloatImage& disparity_px,
                              int first_column,
                              const PinholeCamera& camera,
                              const StereoOptions& options) {
  FloatImage depth(camera.width_px, camera.height_px);
  const float product = camera.focal_px * options.baseline_m;
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      const float disparity = disparity_px.At(u + first_column, v);
      if (!(disparity > 0.0F)) continue;
      const float depth_m = product / disparity;
      if (depth_m <= options.farthest_m) depth.At(u, v) = depth_m;
    }
  }
  return depth;
}

}  // namespace

void StereoOptions::Validate() const {
  const auto require = [](bool holds, const std::string& field, float value, const char* rule) {
    RequireOption(holds, "StereoOptions." + field, static_cast<double>(value), rule);
  };
  require(baseline_m > 0.0F && baseline_m <= 1.0F, "baseline_m", baseline_m, "in (0, 1]");
  require(farthest_m <= 100.0F && farthest_m > 0.1F, "farthest_m", farthest_m, "in (0.1, 100]");
  require(nearest_m >= 0.1F && nearest_m < farthest_m,
          "nearest_m",
          nearest_m,
          "0.1 or more and less than farthest_m");
}

int NumDisparities(const PinholeCamera& camera, const StereoOptions& options) {
  const float largest_px = camera.focal_px * options.baseline_m / options.nearest_m;
  return kDisparityStep * static_cast<int>(std::ceil((largest_px + 1.0F) / kDisparityStep));
}

FloatImage MatchPair(const Image& left,
                     const Image& right,
                     StereoMatcher matcher,
                     int num_disparities) {
  HC_CHECK(left.width() == right.width() && left.height() == right.height(),
           left.width(),
           right.width());
  HC_CHECK(num_disparities > 0 && num_disparities % kDisparityStep == 0, num_disparities);
  cv::Mat found;
  MakeMatcher(matcher, num_disparities)->compute(Gray(left), Gray(right), found);
  FloatImage disparity_px(left.width(), left.height(), 1, kNaN);
  for (int v = 0; v < left.height(); ++v) {
    for (int u = num_disparities; u < left.width(); ++u) {
      const auto sixteenths = found.at<std::int16_t>(v, u);
      if (sixteenths > 0) disparity_px.At(u, v) = kDisparityUnit * static_cast<float>(sixteenths);
    }
  }
  return disparity_px;
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
    disparity_px = MatchPair(
        develop(LightWithDots(scene, left, projector, pattern, left_view.light), "left dots"),
        develop(LightWithDots(scene, right, projector, pattern, right_view.light), "right dots"),
        options.matcher,
        columns);
  } else {
    disparity_px = MatchPair(left_image, right_image, options.matcher, columns);
  }
  return {.view = {.light = WithoutLeft(left_view.light, columns),
                   .labels = WithoutLeft(left_view.labels, columns),
                   .object_mask = WithoutLeft(left_view.object_mask, columns),
                   .depth = WithoutLeft(left_view.depth, columns)},
          .image = WithoutLeft(left_image, columns),
          .right_image = WithoutLeft(right_image, columns),
          .cloud = CloudFromDepth(DepthFromDisparity(disparity_px, columns, scene.camera, options),
                                  scene.camera)};
}

}  // namespace handcraft::synthetic
