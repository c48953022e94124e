// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/ray_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::synthetic {

struct RayTracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

namespace {

constexpr const char* kDeviceSettings = "threads=1,isa=sse2";

void CheckDevice(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw Error({.reason = "Embree cannot cast rays: its error " +
                         std::to_string(static_cast<int>(error)) + " with " + kDeviceSettings});
}

void AttachMesh(RTCDevice device, RTCScene scene, const Mesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry,
                                                                     RTC_BUFFER_TYPE_VERTEX,
                                                                     0,
                                                                     RTC_FORMAT_FLOAT3,
                                                                     3 * sizeof(float),
                                                                     mesh.vertices.size()));
  auto* const faces = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry,
                                                                          RTC_BUFFER_TYPE_INDEX,
                                                                          0,
                                                                          RTC_FORMAT_UINT3,
                                                                          3 * sizeof(std::uint32_t),
                                                                          mesh.faces.size()));
  CheckDevice(device);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      vertices[3 * i + static_cast<std::size_t>(axis)] = mesh.vertices[i][axis];
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      faces[3 * i + corner] = mesh.faces[i].vertices[corner];
    }
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

void FillRays(const RayPacket& rays, RTCRay4& filled) {
  for (std::size_t i = 0; i < 4; ++i) {
    // Rays that are not cast repeat the last one, so that no lane holds what was never set.
    const std::size_t from = std::min(i, static_cast<std::size_t>(rays.count - 1));
    filled.org_x[i] = rays.origins[from].x();
    filled.org_y[i] = rays.origins[from].y();
    filled.org_z[i] = rays.origins[from].z();
    filled.dir_x[i] = rays.directions[from].x();
    filled.dir_y[i] = rays.directions[from].y();
    filled.dir_z[i] = rays.directions[from].z();
    filled.tnear[i] = RayTracer::kNearest;
    filled.tfar[i] = rays.farthest[from];
    filled.time[i] = 0.0F;
    filled.mask[i] = ~0U;
    filled.id[i] = 0;
    filled.flags[i] = 0;
  }
}

struct alignas(16) Lanes {
  std::array<int, 4> valid;
};

Lanes ValidLanes(const RayPacket& rays) {
  HC_CHECK(rays.count >= 1 && rays.count <= 4, rays.count);
  Lanes lanes{};
  for (std::size_t i = 0; i < 4; ++i) lanes.valid[i] = static_cast<int>(i) < rays.count ? -1 : 0;
  return lanes;
}

}  // namespace

void RayPacket::Add(const Eigen::Vector3f& origin,
                    const Eigen::Vector3f& direction,
                    float farthest_at) {
  HC_CHECK(count < 4, count);
  const auto i = static_cast<std::size_t>(count++);
  origins[i] = origin;
  directions[i] = direction;
  farthest[i] = farthest_at;
}

RayTracer::RayTracer(std::span<const Mesh> meshes) : embree_(std::make_unique<Embree>()) {
  embree_->device = rtcNewDevice(kDeviceSettings);
  if (embree_->device == nullptr) CheckDevice(nullptr);
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  for (const Mesh& mesh : meshes) AttachMesh(embree_->device, embree_->scene, mesh);
  rtcCommitScene(embree_->scene);
  CheckDevice(embree_->device);
}

RayTracer::~RayTracer() = default;

std::array<Hit, 4> RayTracer::Intersect(const RayPacket& rays) const {
  const Lanes lanes = ValidLanes(rays);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit4 cast;
  FillRays(rays, cast.ray);
  for (std::size_t i = 0; i < 4; ++i) {
    cast.hit.geomID[i] = cast.hit.primID[i] = cast.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect4(lanes.valid.data(), embree_->scene, &context, &cast);
  std::array<Hit, 4> hits;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
    if (cast.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[i] = {
        cast.ray.tfar[i], cast.hit.geomID[i], cast.hit.primID[i], cast.hit.u[i], cast.hit.v[i]};
  }
  return hits;
}

std::array<bool, 4> RayTracer::IsBlocked(const RayPacket& rays) const {
  const Lanes lanes = ValidLanes(rays);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay4 cast;
  FillRays(rays, cast);
  rtcOccluded4(lanes.valid.data(), embree_->scene, &context, &cast);
  std::array<bool, 4> blocked{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
    blocked[i] = cast.tfar[i] < 0.0F;
  }
  return blocked;
}

}  // namespace handcraft::synthetic
