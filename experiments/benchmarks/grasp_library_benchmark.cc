// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "experiments/benchmarks/benchmark.h"
#include "lib/core/check.h"
#include "lib/core/rng.h"
#include "lib/features/object_rotation.h"
#include "lib/features/position_tree.h"

namespace handcraft::experiments {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr std::size_t kNumViews = 36;
constexpr std::size_t kNumPoses = 5607;  // of the coffee can, Table 4.1
constexpr std::size_t kNumQueries = 1000;

// A bent object of 90 × 130 pixels, as large as those of the made-up turntable, with noise of 2 mm.
struct Object {
  std::vector<float> points = std::vector<float>(std::size_t{3} * kWidth * kHeight, NAN);
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight);

  Object() {
    Rng rng = Rng::Stream(1, "grasp_library_benchmark object");
    for (int v = 175; v < 305; ++v) {
      for (int u = 275; u < 365 - (v - 175) / 5; ++u) {
        const auto pixel = static_cast<std::size_t>(v * kWidth + u);
        const double along_m = 0.001 * (u - 320);
        mask[pixel] = 255;
        points[3 * pixel] = static_cast<float>(8.0 * along_m * along_m + 0.002 * rng.Normal());
        points[3 * pixel + 1] = static_cast<float>(along_m);
        points[3 * pixel + 2] = static_cast<float>(0.0012 * (305 - v));
      }
    }
  }
  [[nodiscard]] features::ObjectCloud View() const {
    return {.points = points.data(),
            .width = kWidth,
            .height = kHeight,
            .row_stride = std::ptrdiff_t{3} * kWidth,
            .mask = mask.data(),
            .mask_stride = kWidth};
  }
};

// Views of one class.
struct Views {
  std::vector<double> normals = {};
  std::vector<double> moments = {};

  Views() {
    Rng rng = Rng::Stream(1, "grasp_library_benchmark views");
    for (std::size_t i = 0; i < kNumViews; ++i) {
      const double angle_rad = 0.1745 * static_cast<double>(i);
      normals.insert(normals.end(), {std::cos(angle_rad), std::sin(angle_rad), 0.0});
      for (std::size_t k = 0; k < features::kNumMoments; ++k) {
        moments.push_back(k % features::kMomentsPerHalf == 0 ? 5000.0 : 0.1 * rng.Normal());
      }
    }
  }
};

// Plane by OpenCV's principal components, moments by cv::moments; the views are not compared.
double DescribeWithOpenCv(const Object& object) {
  const cv::Mat mask(kHeight, kWidth, CV_8U, const_cast<std::uint8_t*>(object.mask.data()));
  cv::Mat points(0, 3, CV_32F);
  for (std::size_t i = 0; i < object.mask.size(); ++i) {
    if (object.mask[i] == 0 || std::isnan(object.points[3 * i])) continue;
    points.push_back(cv::Mat(1, 3, CV_32F, const_cast<float*>(object.points.data() + 3 * i)));
  }
  const cv::PCA plane(points, cv::noArray(), cv::PCA::DATA_AS_ROW);
  const cv::Moments whole = cv::moments(mask, true);
  const int middle_u = static_cast<int>(std::ceil(whole.m10 / whole.m00));
  const cv::Moments left = cv::moments(mask.colRange(0, middle_u), true);
  const cv::Moments right = cv::moments(mask.colRange(middle_u, kWidth), true);
  return static_cast<double>(plane.eigenvectors.at<float>(2, 0)) + left.nu11 + right.nu11;
}

std::vector<features::Vector3> SomePlaces(std::size_t count, const char* stream) {
  Rng rng = Rng::Stream(1, stream);
  std::vector<features::Vector3> places(count);
  for (features::Vector3& place : places) {
    for (double& coordinate : place) coordinate = 0.05 * rng.Normal();
  }
  return places;
}

std::size_t NearestByScan(const std::vector<double>& rows, const features::Vector3& point) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kNumPoses; ++i) {
    const double x = rows[3 * i] - point[0];
    const double y = rows[3 * i + 1] - point[1];
    const double z = rows[3 * i + 2] - point[2];
    const double squared = x * x + y * y + z * z;
    if (squared < least) {
      least = squared;
      best = i;
    }
  }
  return best;
}

}  // namespace

BenchmarkResult BenchmarkRotationLayer(const BenchmarkOptions& options) {
  const Object object;
  const Views views;
  const features::HalvesMoments scales = features::MomentScales(views.moments);
  std::vector<float> scratch(features::ObjectPlaneScratch(kWidth, kHeight));
  std::size_t sum = 0;
  double check = 0.0;
  BenchmarkResult result;
  result.dissertation_ms = std::numeric_limits<double>::quiet_NaN();
  result.peer = "OpenCV PCA and moments, views not compared";
  result.ours_ms = MedianMs(10 * options.repetitions, [&] {
    features::ViewDescription view;
    const features::CloudFault fault = features::DescribeView(object.View(), scratch, view);
    HC_CHECK(fault == features::CloudFault::kNone, features::NameOf(fault));
    sum += features::NearestView(view, {views.normals, views.moments, scales}, {});
  });
  result.peer_ms = MedianMs(options.repetitions, [&] { check += DescribeWithOpenCv(object); });
  HC_CHECK(std::isfinite(check) && sum < kNumViews * 1000000, check, sum);
  result.ratio = result.peer_ms / result.ours_ms;
  return result;
}

BenchmarkResult BenchmarkNearestDemonstration(const BenchmarkOptions& options) {
  const std::vector<features::Vector3> poses =
      SomePlaces(kNumPoses, "grasp_library_benchmark poses");
  const std::vector<features::Vector3> queries =
      SomePlaces(kNumQueries, "grasp_library_benchmark queries");
  std::vector<double> rows;
  std::vector<std::int32_t> numbers;
  for (const std::size_t i : features::TreeOrder(poses)) {
    rows.insert(rows.end(), poses[i].begin(), poses[i].end());
    numbers.push_back(static_cast<std::int32_t>(i));
  }
  std::size_t same = 0;
  std::vector<std::size_t> found(kNumQueries);
  BenchmarkResult result;
  result.dissertation_ms = 7.0;  // Table 4.5
  result.peer = "a scan of all positions";
  result.ours_ms = MedianMs(options.repetitions, [&] {
    features::Neighbour nearest;
    for (std::size_t i = 0; i < kNumQueries; ++i) {
      static_cast<void>(features::FindNearest({rows, numbers}, queries[i], {&nearest, 1}));
      found[i] = nearest.row;
    }
  });
  result.peer_ms = MedianMs(options.repetitions, [&] {
    same = 0;
    for (std::size_t i = 0; i < kNumQueries; ++i) {
      same += NearestByScan(rows, queries[i]) == found[i] ? 1 : 0;
    }
  });
  result.ours_ms /= static_cast<double>(kNumQueries);
  result.peer_ms /= static_cast<double>(kNumQueries);
  result.ratio = result.peer_ms / result.ours_ms;
  result.details = {{"same_row", static_cast<double>(same) / static_cast<double>(kNumQueries)}};
  return result;
}

}  // namespace handcraft::experiments
