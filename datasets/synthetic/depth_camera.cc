// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/depth_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "datasets/synthetic/projector.h"
#include "lib/core/check.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

constexpr float kRightAngleRad = 0.5F * std::numbers::pi_v<float>;
constexpr float kSteepRad = std::numbers::pi_v<float> / 3.0F;            // the source's 60°
constexpr float kSteepestRad = 4.0F / 9.0F * std::numbers::pi_v<float>;  // 80°
constexpr float kStepShare = 0.03F;
constexpr double kLostBesideStep = 0.5;

class DepthSampler {
 public:
  DepthSampler(const Scene& scene, const DepthCameraOptions& options)
      : options_(options),
        camera_(scene.camera),
        geometry_(scene),
        tracer_(geometry_.meshes()),
        pixels_(CastPixels(tracer_, geometry_, camera_)),
        lit_(ReachedFrom(tracer_, pixels_, RightOf(camera_, options.baseline_m).Origin())) {}

  FloatImage Sample(Rng& rng) const {
    FloatImage depth(camera_.width_px, camera_.height_px);
    for (int v = 0; v < depth.height(); ++v) {
      for (int u = 0; u < depth.width(); ++u) {
        // Every pixel takes the same number of draws, so that one hole moves no other.
        const auto across = static_cast<float>(rng.Normal());
        const auto down = static_cast<float>(rng.Normal());
        const auto along = static_cast<float>(rng.Normal());
        const bool is_lost_beside_step = rng.Uniform() < kLostBesideStep;
        if (!IsMatched(u, v) || (is_lost_beside_step && IsBesideStep(u, v))) continue;
        const float lateral_px = LateralNoise(AngleAt(u, v));
        const int s = Clamped(u, lateral_px * across, camera_.width_px);
        const int t = Clamped(v, lateral_px * down, camera_.height_px);
        if (!IsMatched(s, t)) continue;
        const float z = pixels_.At(s, t).distance;
        depth.At(u, v) = Quantised(z + AxialNoise(z, AngleAt(s, t)) * along);
      }
    }
    return depth;
  }

 private:
  [[nodiscard]] static int Clamped(int at, float shift_px, int size) {
    return std::clamp(at + static_cast<int>(std::lround(shift_px)), 0, size - 1);
  }

  // Between the surface's normal and the ray that sees it.
  [[nodiscard]] float AngleAt(int u, int v) const {
    const SurfacePoint& point = pixels_.PointAt(u, v);
    const Eigen::Vector3f back = (camera_.Origin() - point.p_in_base).normalized();
    return std::acos(std::clamp(point.normal.dot(back), 0.0F, 1.0F));
  }

  [[nodiscard]] bool IsMatched(int u, int v) const {
    const Hit& hit = pixels_.At(u, v);
    return hit.mesh != Hit::kNothing && lit_.At(u, v) != 0 && hit.distance >= options_.nearest_m &&
           hit.distance <= options_.farthest_m && AngleAt(u, v) < kSteepestRad;
  }

  [[nodiscard]] bool IsBesideStep(int u, int v) const {
    const float own = pixels_.At(u, v).distance;
    for (int y = std::max(v - 1, 0); y <= std::min(v + 1, camera_.height_px - 1); ++y) {
      for (int x = std::max(u - 1, 0); x <= std::min(u + 1, camera_.width_px - 1); ++x) {
        if (!(std::abs(pixels_.At(x, y).distance - own) <= kStepShare * own)) return true;
      }
    }
    return false;
  }

  [[nodiscard]] float Quantised(float depth_m) const {
    const float product = camera_.focal_px * options_.baseline_m;
    const float steps = std::round(product / depth_m / options_.disparity_step_px);
    return product / (std::max(steps, 1.0F) * options_.disparity_step_px);
  }

  const DepthCameraOptions& options_;
  const PinholeCamera& camera_;
  SceneGeometry geometry_;
  RayTracer tracer_;
  PixelHits pixels_;
  Image lit_;
};

}  // namespace

void DepthCameraOptions::Validate() const {
  const auto require = [](bool holds, const std::string& field, float value, const char* rule) {
    RequireOption(holds, "DepthCameraOptions." + field, value, rule);
  };
  require(baseline_m > 0.0F && baseline_m <= 1.0F, "baseline_m", baseline_m, "in (0, 1]");
  require(disparity_step_px > 0.0F && disparity_step_px <= 1.0F,
          "disparity_step_px",
          disparity_step_px,
          "in (0, 1]");
  require(farthest_m > 0.1F && farthest_m <= 100.0F, "farthest_m", farthest_m, "in (0.1, 100]");
  require(nearest_m >= 0.1F && nearest_m < farthest_m,
          "nearest_m",
          nearest_m,
          "0.1 or more and less than farthest_m");
}

float AxialNoise(float depth_m, float angle_rad) {
  HC_CHECK(depth_m > 0.0F && angle_rad >= 0.0F && angle_rad < kRightAngleRad, depth_m, angle_rad);
  const float beyond_m = depth_m - 0.4F;
  const float facing_m = 0.0012F + 0.0019F * beyond_m * beyond_m;
  if (angle_rad <= kSteepRad) return facing_m;
  const float ratio = angle_rad / (kRightAngleRad - angle_rad);
  return facing_m + 0.0001F / std::sqrt(depth_m) * ratio * ratio;
}

float LateralNoise(float angle_rad) {
  HC_CHECK(angle_rad >= 0.0F && angle_rad < kRightAngleRad, angle_rad);
  return 0.8F + 0.035F * angle_rad / (kRightAngleRad - angle_rad);
}

FloatImage MeasureDepth(const Scene& scene, const DepthCameraOptions& options, Rng& rng) {
  return DepthSampler(scene, options).Sample(rng);
}

}  // namespace handcraft::synthetic
