// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/moved_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/rng.h"

namespace handcraft::datasets {
namespace {

constexpr double kMaxResidual_px = 2.0;
constexpr int kMaxSide_px = 8192;

// pixel = scale · ratio + offset, fitted by least squares.
struct Line {
  double scale = 0.0;
  double offset = 0.0;
};

class LineFit {
 public:
  void Add(double ratio, double pixel) noexcept {
    count_ += 1.0;
    sums_[0] += ratio;
    sums_[1] += pixel;
    sums_[2] += ratio * ratio;
    sums_[3] += ratio * pixel;
    sums_[4] += pixel * pixel;
  }
  [[nodiscard]] Line Solve() const noexcept {
    const double spread = sums_[2] - sums_[0] * sums_[0] / count_;
    const double scale = (sums_[3] - sums_[0] * sums_[1] / count_) / spread;
    return {.scale = scale, .offset = (sums_[1] - scale * sums_[0]) / count_};
  }
  // The root of the mean squared residual; NaN without spread.
  [[nodiscard]] double Residual() const noexcept {
    const Line line = Solve();
    const double squares = sums_[4] - line.scale * sums_[3] - line.offset * sums_[1];
    return std::sqrt(std::max(0.0, squares) / count_) + 0.0 * line.scale;
  }

 private:
  double count_ = 0.0;
  std::array<double, 5> sums_{};
};

struct Projection {
  Line u;
  Line v;
};

template <class Visit>
void ForEachPoint(const MaskedCloud& object, const Visit& visit) {
  const features::ObjectCloud view = object.View();
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      if (view.Has(u, v)) visit(u, v, object.cloud.At(u, v));
    }
  }
}

[[noreturn]] void ThrowNoCamera() {
  throw Error({.reason = "the cloud's points are not seen from its VIEWPOINT at their pixels: its "
                         "object cannot be moved",
               .remedy = "give clouds that tell where the camera was, or no moved copies"});
}

Projection FitProjection(const MaskedCloud& object) {
  const Eigen::Isometry3f camera_from_base = object.cloud.base_from_camera.inverse();
  LineFit along_u;
  LineFit along_v;
  ForEachPoint(object, [&](int u, int v, const Eigen::Vector3f& point) {
    const Eigen::Vector3d p = (camera_from_base * point).cast<double>();
    along_u.Add(p.x() / p.z(), u);
    along_v.Add(p.y() / p.z(), v);
  });
  // A NaN fails as well.
  if (!(along_u.Residual() <= kMaxResidual_px && along_v.Residual() <= kMaxResidual_px)) {
    ThrowNoCamera();
  }
  return {.u = along_u.Solve(), .v = along_v.Solve()};
}

Eigen::Vector3f FootOf(const MaskedCloud& object) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  float lowest = std::numeric_limits<float>::max();
  ForEachPoint(object, [&](int, int, const Eigen::Vector3f& point) {
    sum += point.cast<double>();
    count += 1.0;
    lowest = std::min(lowest, point.z());
  });
  return {static_cast<float>(sum.x() / count), static_cast<float>(sum.y() / count), lowest};
}

// A moved point and where it is seen.
struct SeenPoint {
  Eigen::Vector3f point;
  int u;
  int v;
  float depth_m;
};

std::vector<SeenPoint> Project(const MaskedCloud& object,
                               const Movement& movement,
                               const Projection& projection) {
  const Eigen::Isometry3f camera_from_base = object.cloud.base_from_camera.inverse();
  const Eigen::Vector3f foot = FootOf(object);
  std::vector<SeenPoint> seen;
  ForEachPoint(object, [&](int, int, const Eigen::Vector3f& point) {
    const Eigen::Vector3f moved = foot + movement.scale * (point - foot) + movement.shift_m;
    const Eigen::Vector3d p = (camera_from_base * moved).cast<double>();
    const double u = projection.u.scale * p.x() / p.z() + projection.u.offset;
    const double v = projection.v.scale * p.y() / p.z() + projection.v.offset;
    if (!(p.z() > 0.0 && std::fabs(u) < kMaxSide_px && std::fabs(v) < kMaxSide_px)) {
      ThrowNoCamera();
    }
    seen.push_back({.point = moved,
                    .u = static_cast<int>(std::lround(u)),
                    .v = static_cast<int>(std::lround(v)),
                    .depth_m = static_cast<float>(p.z())});
  });
  return seen;
}

Movement DrawMovement(const MovedCopyOptions& options, std::uint64_t view, int copy) {
  Rng rng = Rng::Stream(
      options.seed,
      "moved copy",
      view * static_cast<std::uint64_t>(options.num_copies) + static_cast<std::uint64_t>(copy));
  const auto between = [&rng](double low, double high) {
    return static_cast<float>(low + (high - low) * rng.Uniform());
  };
  const float scale = between(options.least_scale, options.greatest_scale);
  const float forward_m = between(-options.forward_m, options.forward_m);
  const float sideways_m = between(-options.sideways_m, options.sideways_m);
  return {.shift_m = {forward_m, sideways_m, 0.0F}, .scale = scale};
}

}  // namespace

void MovedCopyOptions::Validate() const {
  RequireOption(num_copies >= 0 && num_copies <= 1000,
                "MovedCopyOptions.num_copies",
                num_copies,
                "from 0 to 1000");
  RequireOption(forward_m >= 0.0 && forward_m <= 10.0,
                "MovedCopyOptions.forward_m",
                forward_m,
                "from 0 to 10");
  RequireOption(sideways_m >= 0.0 && sideways_m <= 10.0,
                "MovedCopyOptions.sideways_m",
                sideways_m,
                "from 0 to 10");
  RequireOption(least_scale >= 0.1 && least_scale <= 1.0,
                "MovedCopyOptions.least_scale",
                least_scale,
                "from 0.1 to 1");
  RequireOption(greatest_scale >= 1.0 && greatest_scale <= 10.0,
                "MovedCopyOptions.greatest_scale",
                greatest_scale,
                "from 1 to 10");
}

MaskedCloud MoveObject(const MaskedCloud& object, const Movement& movement) {
  const std::vector<SeenPoint> seen = Project(object, movement, FitProjection(object));
  const auto [left, right] = std::minmax_element(
      seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.u < b.u; });
  const auto [top, bottom] = std::minmax_element(
      seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.v < b.v; });
  MaskedCloud moved{.cloud = {.width = right->u - left->u + 1, .height = bottom->v - top->v + 1},
                    .mask = {}};
  moved.cloud.base_from_camera = object.cloud.base_from_camera;
  moved.mask = Image(moved.cloud.width, moved.cloud.height);
  const std::size_t num_pixels = moved.mask.values().size();
  moved.cloud.points.assign(num_pixels,
                            Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  std::vector<float> depths_m(num_pixels, std::numeric_limits<float>::max());
  for (const SeenPoint& point : seen) {
    const auto pixel =
        static_cast<std::size_t>((point.v - top->v) * moved.cloud.width + (point.u - left->u));
    if (point.depth_m >= depths_m[pixel]) continue;
    depths_m[pixel] = point.depth_m;
    moved.cloud.points[pixel] = point.point;
    moved.mask.Row(0)[pixel] = 255;
  }
  return moved;
}

CloudFeatures DescribeMovedCopies(const ViewSet& set,
                                  const features::CloudDescriptor& descriptor,
                                  const ObjectCloudOptions& options,
                                  const MovedCopyOptions& copies,
                                  int num_threads,
                                  const Progress& progress) {
  copies.Validate();
  const std::size_t num_features = descriptor.NumFeatures();
  const std::size_t num_rows = set.items.size() * static_cast<std::size_t>(copies.num_copies);
  CloudFeatures features{.values = std::vector<float>(num_rows * num_features),
                         .num_views = num_rows,
                         .num_features = num_features};
  const auto describe = [&](std::size_t i) {
    const MaskedCloud object = ReadObjectCloud(set, i, {.outlier_step = options.outlier_step});
    for (int copy = 0; copy < copies.num_copies; ++copy) {
      MaskedCloud moved = MoveObject(object, DrawMovement(copies, i, copy));
      ChangeFrame(options.frame, moved.cloud);
      const std::size_t row = static_cast<std::size_t>(copy) * set.items.size() + i;
      DescribeObject(
          moved, descriptor, std::span(features.values).subspan(row * num_features, num_features));
    }
  };
  ParallelForReporting(
      set.items.size(), num_threads, progress, "moving objects", [&](std::size_t i) {
        NamingCloud(set, i, [&] { describe(i); });
      });
  return features;
}

}  // namespace handcraft::datasets
