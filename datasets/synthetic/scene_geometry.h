// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <span>
#include <vector>

#include "datasets/synthetic/ray_tracer.h"
#include "datasets/synthetic/scene.h"

namespace handcraft::synthetic {

/// What is seen at a hit.
struct SurfacePoint {
  Eigen::Vector3f p_in_base = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< smooth, unit length, towards the viewer
  const Material* material = nullptr;
  Colour albedo = Colour::Zero();
};

/// A scene's meshes in the base frame, ready to have rays cast at them. The scene must outlive it.
class SceneGeometry {
 public:
  explicit SceneGeometry(const Scene& scene);

  [[nodiscard]] std::span<const Mesh> meshes() const noexcept { return meshes_; }
  /// The meshes with every face that light goes through shrunk to a point, so that no ray meets it;
  /// the others keep their numbers.
  [[nodiscard]] std::vector<Mesh> OpaqueMeshes() const;
  [[nodiscard]] bool HasClearMaterial() const;

  /// The surface that a ray from the viewer along `direction` has hit.
  [[nodiscard]] SurfacePoint PointAt(const Hit& hit, const Eigen::Vector3f& direction) const;
  /// As PointAt, without material and albedo.
  [[nodiscard]] SurfacePoint ShapeAt(const Hit& hit, const Eigen::Vector3f& direction) const;

  [[nodiscard]] bool IsTarget(const Hit& hit) const;
  [[nodiscard]] bool IsGraspable(const Hit& hit) const;

 private:
  const Scene* scene_;
  std::vector<Mesh> meshes_;
  std::vector<std::vector<std::array<Eigen::Vector3f, 3>>> normals_;
  std::vector<Eigen::Isometry3f> object_from_base_;
};

}  // namespace handcraft::synthetic
