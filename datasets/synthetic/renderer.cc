// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/synthetic/visibility.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

constexpr int kNumSubsamples = 4;
// A rotated grid within the pixel.
constexpr std::array<std::array<float, 2>, kNumSubsamples> kSubsamples = {
    {{-0.125F, -0.375F}, {0.375F, -0.125F}, {0.125F, 0.375F}, {-0.375F, 0.125F}}};

// How much light reaches a point of the picture.
struct Visible {
  float light = 1.0F;
  float sky = 1.0F;
};

class Painter {
 public:
  Painter(const Scene& scene, const PinholeCamera& camera)
      : scene_(scene),
        camera_(camera),
        geometry_(scene),
        tracer_(geometry_.meshes()),
        pixels_(CastPixels(tracer_, geometry_, camera)) {
    // Clear things cast no shadow: they bend and scatter little of the light.
    if (geometry_.HasClearMaterial()) opaque_.emplace(geometry_.OpaqueMeshes());
    light_ = LightVisibility(Blockers(), pixels_, scene.light);
    sky_ = SkyVisibility(Blockers(), pixels_);
  }

  [[nodiscard]] View Paint() const {
    View view{.light = FloatImage(camera_.width_px, camera_.height_px, 3),
              .labels = Image(camera_.width_px, camera_.height_px),
              .object_mask = Image(camera_.width_px, camera_.height_px),
              .depth = FloatImage(camera_.width_px, camera_.height_px)};
    for (int v = 0; v < camera_.height_px; ++v) {
      for (int u = 0; u < camera_.width_px; ++u) PaintPixel(view, u, v);
    }
    return view;
  }

 private:
  void PaintPixel(View& view, int u, int v) const {
    const Hit& hit = pixels_.At(u, v);
    const Vector3f ray = camera_.Ray(static_cast<float>(u), static_cast<float>(v));
    Colour colour = Shade(hit, ray, {light_.At(u, v), sky_.At(u, v)});
    int num_graspable = geometry_.IsGraspable(hit) ? 1 : 0;
    int num_samples = 1;
    if (IsOnEdge(u, v)) {
      const auto [sum, graspable] = ShadeSubsamples(u, v);
      colour += sum;
      num_graspable += graspable;
      num_samples += kNumSubsamples;
    }
    for (int channel = 0; channel < 3; ++channel) {
      view.light.At(u, v, channel) = colour[channel] / static_cast<float>(num_samples);
    }
    view.labels.At(u, v) = num_graspable == 0             ? datasets::kMaskBad
                           : num_graspable == num_samples ? datasets::kMaskGood
                                                          : datasets::kMaskDontCare;
    view.object_mask.At(u, v) = geometry_.IsTarget(hit) ? 255 : 0;
    view.depth.At(u, v) = hit.mesh == Hit::kNothing ? 0.0F : hit.distance;
  }

  // Whether a neighbour shows another object, part or slope, or lies at another depth.
  [[nodiscard]] bool IsOnEdge(int u, int v) const {
    const Hit& own = pixels_.At(u, v);
    for (int i = 0; i < 4; ++i) {
      const int x = u + (i == 0 ? 1 : i == 1 ? -1 : 0);
      const int y = v + (i == 2 ? 1 : i == 3 ? -1 : 0);
      if (x < 0 || y < 0 || x >= camera_.width_px || y >= camera_.height_px) continue;
      const Hit& other = pixels_.At(x, y);
      if (own.mesh != other.mesh) return true;
      if (own.mesh == Hit::kNothing || own.face == other.face) continue;
      if (geometry_.IsGraspable(own) != geometry_.IsGraspable(other)) return true;
      if (std::abs(own.distance - other.distance) > 0.01F * own.distance) return true;
      if (pixels_.PointAt(u, v).normal.dot(pixels_.PointAt(x, y).normal) < 0.8F) return true;
    }
    return false;
  }

  struct Subsamples {
    Colour sum = Colour::Zero();
    int num_graspable = 0;
  };

  [[nodiscard]] Subsamples ShadeSubsamples(int u, int v) const {
    RayPacket rays;
    for (const auto& [du, dv] : kSubsamples) {
      rays.Add(camera_.Origin(),
               camera_.Ray(static_cast<float>(u) + du, static_cast<float>(v) + dv),
               1e3F);
    }
    Subsamples result;
    const std::array<Hit, 4> hits = tracer_.Intersect(rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      result.sum += Shade(hits[i], rays.directions[i], VisibleNear(hits[i], u, v));
      result.num_graspable += geometry_.IsGraspable(hits[i]) ? 1 : 0;
    }
    return result;
  }

  // The light of that pixel around (u, v) whose centre shows the nearest point of the same object.
  [[nodiscard]] Visible VisibleNear(const Hit& hit, int u, int v) const {
    Visible visible{light_.At(u, v), sky_.At(u, v)};
    float least_m = pixels_.At(u, v).mesh == hit.mesh
                        ? std::abs(pixels_.At(u, v).distance - hit.distance)
                        : std::numeric_limits<float>::max();
    for (int y = std::max(v - 1, 0); y <= std::min(v + 1, camera_.height_px - 1); ++y) {
      for (int x = std::max(u - 1, 0); x <= std::min(u + 1, camera_.width_px - 1); ++x) {
        const float apart_m = std::abs(pixels_.At(x, y).distance - hit.distance);
        if (pixels_.At(x, y).mesh != hit.mesh || apart_m >= least_m) continue;
        least_m = apart_m;
        visible = {light_.At(x, y), sky_.At(x, y)};
      }
    }
    return visible;
  }

  [[nodiscard]] const RayTracer& Blockers() const { return opaque_ ? *opaque_ : tracer_; }

  [[nodiscard]] Colour Shade(const Hit& hit, const Vector3f& ray, const Visible& visible) const {
    if (hit.mesh == Hit::kNothing) return scene_.ambient;
    const SurfacePoint point = geometry_.PointAt(hit, ray);
    Colour colour = Reflected(point, ray, visible);
    if (point.material->transmission > 0.0F) {
      colour += Passing(point, ray).cwiseProduct(Behind(point, ray, visible.sky));
    }
    return colour;
  }

  // What comes through a clear surface from behind it: the ray goes on straight to the first
  // surface that is not clear, through at most eight more of them that are. Those within 0.2 mm of
  // that surface lie on it and are not seen. Inner surfaces show the room, not the light.
  [[nodiscard]] Colour Behind(SurfacePoint point, const Vector3f& ray, float sky) const {
    constexpr int kMostSurfaces = 8;
    constexpr float kContactM = 2e-4F;
    const Hit end = FirstHit(Blockers(), point.p_in_base, ray);
    const Vector3f origin = point.p_in_base;
    Colour sum = Colour::Zero();
    Colour share = Colour::Ones();
    for (int i = 0; i < kMostSurfaces; ++i) {
      const Hit hit = FirstHit(tracer_, point.p_in_base, ray);
      if (hit.mesh == Hit::kNothing) break;
      point = geometry_.PointAt(hit, ray);
      const float distance_m = (point.p_in_base - origin).norm();
      if (distance_m > end.distance * ray.norm() - kContactM) break;
      sum += share.cwiseProduct(Reflected(point, ray, {0.0F, sky}));
      share = share.cwiseProduct(Passing(point, ray));
    }
    if (end.mesh == Hit::kNothing) return sum + share.cwiseProduct(scene_.ambient);
    const SurfacePoint last = geometry_.PointAt(end, ray);
    return sum + share.cwiseProduct(Reflected(last, ray, {LightAt(last), sky}));
  }

  [[nodiscard]] static Hit FirstHit(const RayTracer& tracer,
                                    const Vector3f& origin,
                                    const Vector3f& ray) {
    RayPacket packet;
    packet.Add(origin, ray, 1e3F);
    return tracer.Intersect(packet)[0];
  }

  // The share of each colour that passes a clear surface.
  [[nodiscard]] static Colour Passing(const SurfacePoint& point, const Vector3f& ray) {
    const Material& material = *point.material;
    return material.transmission * (1.0F - Fresnel(point, ray.normalized())) * material.base;
  }

  // The share of the light that a point sees, by four rays.
  [[nodiscard]] float LightAt(const SurfacePoint& point) const {
    constexpr float kLeaveM = 1e-4F;
    const AreaLight& light = scene_.light;
    const Vector3f from = point.p_in_base + kLeaveM * point.normal;
    RayPacket rays;
    for (const float s : {-0.5F, 0.5F}) {
      for (const float t : {-0.5F, 0.5F}) {
        const Vector3f to = light.centre_m + s * light.half_u_m + t * light.half_v_m;
        rays.Add(from, to - from, 1.0F);
      }
    }
    float num_lit = 0.0F;
    for (const bool blocked : Blockers().IsBlocked(rays)) num_lit += blocked ? 0.0F : 1.0F;
    return 0.25F * num_lit;
  }

  // What a surface itself sends back along the ray.
  [[nodiscard]] Colour Reflected(const SurfacePoint& point,
                                 const Vector3f& ray,
                                 const Visible& visible) const {
    const Vector3f to_light = scene_.light.centre_m - point.p_in_base;
    const float distance_m = to_light.norm();
    const Vector3f towards = to_light / distance_m;
    const float facing = std::max(point.normal.dot(towards), 0.0F);
    const Colour irradiance = visible.light / (distance_m * distance_m) * scene_.light.intensity;
    // More light comes from above than from the floor.
    const Colour around = visible.sky * (0.7F + 0.3F * point.normal.z()) * scene_.ambient;
    const float scattered = 1.0F - point.material->transmission;
    return scattered * point.albedo.cwiseProduct(facing * irradiance + around) +
           Mirrored(point, ray.normalized(), towards, irradiance * facing, around);
  }

  // The share that is mirrored at this angle (after Schlick).
  [[nodiscard]] static float Fresnel(const SurfacePoint& point, const Vector3f& view) {
    const float specular = point.material->specular;
    const float grazing = 1.0F - std::min(-view.dot(point.normal), 1.0F);
    return specular + (1.0F - specular) * 0.7F * grazing * grazing * grazing * grazing * grazing;
  }

  // The light's highlight, and the room in the surface.
  [[nodiscard]] static Colour Mirrored(const SurfacePoint& point,
                                       const Vector3f& view,
                                       const Vector3f& towards,
                                       const Colour& irradiance,
                                       const Colour& around) {
    const Material& material = *point.material;
    if (material.specular <= 0.0F) return Colour::Zero();
    const float fresnel = Fresnel(point, view);
    const Vector3f half = (towards - view).normalized();
    const float lobe = std::pow(std::max(point.normal.dot(half), 0.0F), material.shininess) *
                       (material.shininess + 8.0F) / 8.0F;
    const Vector3f reflected = view - 2.0F * view.dot(point.normal) * point.normal;
    const float room = 0.55F + 0.45F * reflected.z() + (reflected.z() > 0.55F ? 0.35F : 0.0F);
    return fresnel * (lobe * irradiance + room * around);
  }

  const Scene& scene_;
  const PinholeCamera& camera_;
  SceneGeometry geometry_;
  RayTracer tracer_;
  std::optional<RayTracer> opaque_;  // where something is clear
  PixelHits pixels_;
  FloatImage light_;
  FloatImage sky_;
};

}  // namespace

View Render(const Scene& scene, const PinholeCamera& camera) {
  return Painter(scene, camera).Paint();
}

}  // namespace handcraft::synthetic
