// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/visibility.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

constexpr float kSkyReachM = 0.3F;
constexpr int kSkyStep = 4;        // pixels between the points at which the sky is sampled
constexpr float kFarthest = 1e3F;  // of a pixel's ray [m of depth]
constexpr float kLeaveM = 2e-4F;   // how far above its surface a second ray begins

// One of nine offsets in the unit square, so that any 3 × 3 pixels have them all.
Eigen::Vector2f Offset(int u, int v) {
  return {(static_cast<float>(u % 3) + 0.5F) / 3.0F, (static_cast<float>(v % 3) + 0.5F) / 3.0F};
}

Vector3f OnLight(const AreaLight& light, float s, float t) {
  return light.centre_m + (2.0F * s - 1.0F) * light.half_u_m + (2.0F * t - 1.0F) * light.half_v_m;
}

// Shadow rays of one picture.
class LightCaster {
 public:
  LightCaster(const RayTracer& tracer, const PixelHits& pixels, const AreaLight& light)
      : tracer_(tracer), pixels_(pixels), light_(light) {}

  // Lit and shaded pixels of a block, each asked once: 0 ... 1, or −1 where they disagree.
  [[nodiscard]] float ProbeBlock(int u, int v) const {
    RayPacket rays;
    int num_dark = 0;
    for (int i = 0; i < 4; ++i) {
      const int s = i % 2;
      const int t = i / 2;
      if (!AddRay(rays,
                  u + s,
                  v + t,
                  0.125F + 0.75F * static_cast<float>(s),
                  0.125F + 0.75F * static_cast<float>(t))) {
        ++num_dark;
      }
    }
    int num_lit = 0;
    if (rays.count > 0) {
      const auto blocked = tracer_.IsBlocked(rays);
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
        blocked[i] ? ++num_dark : ++num_lit;
      }
    }
    if (num_lit == 4) return 1.0F;
    return num_dark == 4 ? 0.0F : -1.0F;
  }

  [[nodiscard]] float SamplePixel(int u, int v) const {
    constexpr int kStrata = 4;
    int num_lit = 0;
    for (int row = 0; row < kStrata; ++row) {
      RayPacket rays;
      for (int column = 0; column < kStrata; ++column) {
        const Eigen::Vector2f offset = Offset(u, v);
        const float s = (static_cast<float>(column) + offset.x()) / kStrata;
        const float t = (static_cast<float>(row) + offset.y()) / kStrata;
        if (!AddRay(rays, u, v, s, t)) return 0.0F;
      }
      for (const bool blocked : tracer_.IsBlocked(rays)) num_lit += blocked ? 0 : 1;
    }
    return static_cast<float>(num_lit) / (kStrata * kStrata);
  }

 private:
  // False where nothing is seen, or the surface is turned away from the light.
  bool AddRay(RayPacket& rays, int u, int v, float s, float t) const {
    const Hit& hit = pixels_.At(u, v);
    if (hit.mesh == Hit::kNothing) return false;
    const SurfacePoint& point = pixels_.PointAt(u, v);
    if (point.normal.dot(light_.centre_m - point.p_in_base) <= 0.0F) return false;
    const Vector3f from = point.p_in_base + kLeaveM * point.normal;
    rays.Add(from, OnLight(light_, s, t) - from, 1.0F);
    return true;
  }

  const RayTracer& tracer_;
  const PixelHits& pixels_;
  const AreaLight& light_;
};

// Whether the blocks around agree with this one.
bool IsUniform(const FloatImage& blocks, int x, int y) {
  const float own = blocks.At(x, y);
  if (own < 0.0F) return false;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, blocks.height() - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, blocks.width() - 1); ++u) {
      if (blocks.At(u, v) != own) return false;
    }
  }
  return true;
}

// Mean over those of the 3 × 3 pixels that show the same object.
float SmoothWithin(const FloatImage& values, const PixelHits& pixels, int u, int v) {
  float sum = 0.0F;
  int count = 0;
  for (int y = std::max(v - 1, 0); y <= std::min(v + 1, values.height() - 1); ++y) {
    for (int x = std::max(u - 1, 0); x <= std::min(u + 1, values.width() - 1); ++x) {
      if (pixels.At(x, y).mesh != pixels.At(u, v).mesh) continue;
      sum += values.At(x, y);
      ++count;
    }
  }
  return sum / static_cast<float>(count);
}

// A point at which the sky was sampled.
struct SkySample {
  std::uint32_t mesh = Hit::kNothing;
  Vector3f p_in_base = Vector3f::Zero();
  Vector3f normal = Vector3f::Zero();
  float visible = 1.0F;
};

struct SkyGrid {
  int columns = 0;
  int rows = 0;
  std::vector<SkySample> samples;

  [[nodiscard]] SkySample& At(int x, int y) {
    return samples[static_cast<std::size_t>(y * columns + x)];
  }
  [[nodiscard]] const SkySample& At(int x, int y) const {
    return samples[static_cast<std::size_t>(y * columns + x)];
  }
};

float CastSky(const RayTracer& tracer, const SkySample& sample, const Eigen::Vector2f& offset) {
  const Vector3f side = (std::abs(sample.normal.z()) < 0.9F ? Vector3f::UnitZ() : Vector3f::UnitX())
                            .cross(sample.normal)
                            .normalized();
  const Vector3f across = sample.normal.cross(side);
  const Vector3f from = sample.p_in_base + kLeaveM * sample.normal;
  int num_open = 0;
  for (int row = 0; row < 4; ++row) {
    RayPacket rays;
    for (int column = 0; column < 4; ++column) {
      // Stratified over the disc beneath the hemisphere, hence weighted by the cosine.
      const float radius = std::sqrt((static_cast<float>(row) + offset.x()) / 4.0F);
      const float angle_rad =
          2.0F * std::numbers::pi_v<float> *
          (static_cast<float>(column) + offset.y() + 0.25F * static_cast<float>(row)) / 4.0F;
      const float up = std::sqrt(std::max(1.0F - radius * radius, 0.0F));
      rays.Add(from,
               radius * std::cos(angle_rad) * side + radius * std::sin(angle_rad) * across +
                   up * sample.normal,
               kSkyReachM);
    }
    for (const bool blocked : tracer.IsBlocked(rays)) num_open += blocked ? 0 : 1;
  }
  return static_cast<float>(num_open) / 16.0F;
}

SkyGrid SampleSky(const RayTracer& tracer, const PixelHits& pixels) {
  SkyGrid grid{.columns = (pixels.width_px + kSkyStep - 1) / kSkyStep + 1,
               .rows = (pixels.height_px + kSkyStep - 1) / kSkyStep + 1,
               .samples = {}};
  grid.samples.resize(static_cast<std::size_t>(grid.columns * grid.rows));
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      const int u = std::min(x * kSkyStep, pixels.width_px - 1);
      const int v = std::min(y * kSkyStep, pixels.height_px - 1);
      const Hit& hit = pixels.At(u, v);
      if (hit.mesh == Hit::kNothing) continue;
      const SurfacePoint& point = pixels.PointAt(u, v);
      SkySample& sample = grid.At(x, y);
      sample = {.mesh = hit.mesh, .p_in_base = point.p_in_base, .normal = point.normal};
      sample.visible = CastSky(tracer, sample, Offset(x, y));
    }
  }
  return grid;
}

// How much a sample says about a point: nothing across an edge, less with distance.
float Likeness(const SkySample& sample, std::uint32_t mesh, const SurfacePoint& point) {
  if (sample.mesh != mesh) return 0.0F;
  const float facing = std::max(sample.normal.dot(point.normal), 0.0F);
  const float off_plane_m = std::abs(point.normal.dot(sample.p_in_base - point.p_in_base));
  const float squared = facing * facing;
  return squared * squared * squared * squared * std::max(1.0F - off_plane_m / 0.01F, 0.0F);
}

SkyGrid SmoothSky(const SkyGrid& grid) {
  SkyGrid smooth = grid;
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      SkySample& own = smooth.At(x, y);
      const SurfacePoint point{.p_in_base = own.p_in_base, .normal = own.normal};
      float sum = 1e-3F * own.visible;
      float weights = 1e-3F;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, grid.rows - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, grid.columns - 1); ++u) {
          const float weight = Likeness(grid.At(u, v), own.mesh, point);
          sum += weight * grid.At(u, v).visible;
          weights += weight;
        }
      }
      own.visible = sum / weights;
    }
  }
  return smooth;
}

float InterpolateSky(
    const SkyGrid& grid, int u, int v, std::uint32_t mesh, const SurfacePoint& point) {
  const int x = u / kSkyStep;
  const int y = v / kSkyStep;
  const float s = static_cast<float>(u % kSkyStep) / kSkyStep;
  const float t = static_cast<float>(v % kSkyStep) / kSkyStep;
  float sum = 0.0F;
  float weights = 0.0F;
  for (int i = 0; i < 4; ++i) {
    const SkySample& sample = grid.At(x + i % 2, y + i / 2);
    const float bilinear = (i % 2 == 0 ? 1.0F - s : s) * (i / 2 == 0 ? 1.0F - t : t) + 1e-3F;
    const float weight =
        bilinear * (Likeness(sample, mesh, point) + (sample.mesh == mesh ? 1e-3F : 1e-6F));
    sum += weight * sample.visible;
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

PixelHits CastPixels(const RayTracer& tracer,
                     const SceneGeometry& geometry,
                     const PinholeCamera& camera) {
  const int width = camera.width_px;
  PixelHits pixels{.width_px = width, .height_px = camera.height_px, .hits = {}, .points = {}};
  pixels.hits.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(camera.height_px));
  pixels.points.resize(pixels.hits.size());
  const Vector3f origin = camera.Origin();
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < width; u += 4) {
      RayPacket rays;
      for (int i = u; i < std::min(u + 4, width); ++i) {
        rays.Add(origin, camera.Ray(static_cast<float>(i), static_cast<float>(v)), kFarthest);
      }
      const std::array<Hit, 4> hits = tracer.Intersect(rays);
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
        const std::size_t pixel = pixels.Index(u, v) + i;
        pixels.hits[pixel] = hits[i];
        if (hits[i].mesh == Hit::kNothing) continue;
        pixels.points[pixel] = geometry.ShapeAt(hits[i], rays.directions[i]);
      }
    }
  }
  return pixels;
}

FloatImage LightVisibility(const RayTracer& tracer,
                           const PixelHits& pixels,
                           const AreaLight& light) {
  const LightCaster caster(tracer, pixels, light);
  FloatImage blocks(pixels.width_px / 2, pixels.height_px / 2);
  for (int y = 0; y < blocks.height(); ++y) {
    for (int x = 0; x < blocks.width(); ++x) blocks.At(x, y) = caster.ProbeBlock(2 * x, 2 * y);
  }
  FloatImage sampled(pixels.width_px, pixels.height_px);
  Image is_penumbra(pixels.width_px, pixels.height_px);
  for (int v = 0; v < pixels.height_px; ++v) {
    for (int u = 0; u < pixels.width_px; ++u) {
      const int x = std::min(u / 2, blocks.width() - 1);
      const int y = std::min(v / 2, blocks.height() - 1);
      const bool is_uniform = IsUniform(blocks, x, y);
      is_penumbra.At(u, v) = is_uniform ? 0 : 1;
      sampled.At(u, v) = is_uniform ? blocks.At(x, y) : caster.SamplePixel(u, v);
    }
  }
  FloatImage visible = sampled;
  for (int v = 0; v < pixels.height_px; ++v) {
    for (int u = 0; u < pixels.width_px; ++u) {
      if (is_penumbra.At(u, v) != 0) visible.At(u, v) = SmoothWithin(sampled, pixels, u, v);
    }
  }
  return visible;
}

FloatImage SkyVisibility(const RayTracer& tracer, const PixelHits& pixels) {
  const SkyGrid grid = SmoothSky(SampleSky(tracer, pixels));
  FloatImage visible(pixels.width_px, pixels.height_px, 1, 1.0F);
  for (int v = 0; v < pixels.height_px; ++v) {
    for (int u = 0; u < pixels.width_px; ++u) {
      const Hit& hit = pixels.At(u, v);
      if (hit.mesh == Hit::kNothing) continue;
      visible.At(u, v) = InterpolateSky(grid, u, v, hit.mesh, pixels.PointAt(u, v));
    }
  }
  return visible;
}

}  // namespace handcraft::synthetic
