// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "datasets/synthetic/mesh.h"

namespace handcraft::synthetic {

/// Four rays that are cast together; those beyond `count` are not cast. Neighbouring rays together
/// are faster. A ray begins at kNearest of its direction's length, so that it leaves its surface.
struct RayPacket {
  std::array<Eigen::Vector3f, 4> origins;
  std::array<Eigen::Vector3f, 4> directions;  ///< of any length: the unit of `distance`
  std::array<float, 4> farthest{};            ///< in lengths of the direction
  int count = 0;

  void Add(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float farthest_at);
  [[nodiscard]] bool IsFull() const noexcept { return count == 4; }
};

struct Hit {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();
  float distance = std::numeric_limits<float>::infinity();  ///< in lengths of the direction
  std::uint32_t mesh = kNothing;                            ///< which of the meshes
  std::uint32_t face = 0;
  float weight_b = 0.0F;  ///< barycentric: of the face's second vertex
  float weight_c = 0.0F;  ///< and of its third
};

/// Finds where rays meet meshes, with Embree pinned to one instruction set, so that hits do not
/// depend on the processor. May be used by one thread at a time.
class RayTracer {
 public:
  static constexpr float kNearest = 1e-4F;

  /// The meshes, all in one frame, are copied. Throws Error when Embree cannot be set up.
  explicit RayTracer(std::span<const Mesh> meshes);
  ~RayTracer();
  RayTracer(const RayTracer&) = delete;
  RayTracer& operator=(const RayTracer&) = delete;

  /// The nearest hit of each ray; `mesh` is kNothing for one that meets nothing.
  [[nodiscard]] std::array<Hit, 4> Intersect(const RayPacket& rays) const;

  /// Whether each ray meets anything before its farthest point.
  [[nodiscard]] std::array<bool, 4> IsBlocked(const RayPacket& rays) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace handcraft::synthetic
