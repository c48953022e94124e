// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/stereo_matching.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"

namespace handcraft::perception {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr int kDisparityStep = 16;  // OpenCV searches multiples of it
constexpr float kDisparityUnit = 1.0F / 16.0F;
constexpr int kSpeckleSize = 100;
constexpr int kSpeckleRange = 2;
constexpr int kUniquenessPercent = 10;

cv::Mat Gray(const Image& image) {
  HC_CHECK(image.channels() == 1 || image.channels() == 3, image.channels());
  // OpenCV has no read-only matrix; the pixels are only read.
  cv::Mat pixels(image.height(),
                 image.width(),
                 CV_8UC(image.channels()),
                 const_cast<std::uint8_t*>(image.Row(0)));
  if (image.channels() == 1) return pixels;
  cv::Mat gray;
  cv::cvtColor(pixels, gray, cv::COLOR_BGR2GRAY);
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

}  // namespace

int NumDisparities(float focal_px, float baseline_m, float nearest_m) {
  const float largest_px = focal_px * baseline_m / nearest_m;
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

FloatImage DepthOfDisparity(const FloatImage& disparity_px,
                            float focal_px,
                            float baseline_m,
                            float farthest_m) {
  FloatImage depth(disparity_px.width(), disparity_px.height());
  const float product = focal_px * baseline_m;
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      const float disparity = disparity_px.At(u, v);
      if (!(disparity > 0.0F)) continue;
      const float depth_m = product / disparity;
      if (depth_m <= farthest_m) depth.At(u, v) = depth_m;
    }
  }
  return depth;
}

}  // namespace handcraft::perception
