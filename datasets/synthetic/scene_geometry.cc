// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene_geometry.h"

#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

constexpr float kCreaseRad = 0.7F;  // sharper edges stay edges

}  // namespace

SceneGeometry::SceneGeometry(const Scene& scene) : scene_(&scene) {
  for (const PlacedObject& placed : scene.objects) {
    Mesh mesh = placed.object.mesh;
    Transform(mesh, placed.base_from_object);
    normals_.push_back(CornerNormals(mesh, kCreaseRad));
    meshes_.push_back(std::move(mesh));
    object_from_base_.push_back(placed.base_from_object.inverse());
  }
}

std::vector<Mesh> SceneGeometry::OpaqueMeshes() const {
  std::vector<Mesh> opaque = meshes_;
  for (std::size_t i = 0; i < opaque.size(); ++i) {
    const std::vector<Material>& materials = scene_->objects[i].object.materials;
    for (Face& face : opaque[i].faces) {
      const bool is_clear = materials[face.surface.material].transmission > 0.0F;
      if (is_clear) face.vertices.fill(face.vertices[0]);
    }
  }
  return opaque;
}

bool SceneGeometry::HasClearMaterial() const {
  for (const PlacedObject& placed : scene_->objects) {
    for (const Material& material : placed.object.materials) {
      if (material.transmission > 0.0F) return true;
    }
  }
  return false;
}

SurfacePoint SceneGeometry::ShapeAt(const Hit& hit, const Eigen::Vector3f& direction) const {
  HC_CHECK(hit.mesh < meshes_.size(), hit.mesh, meshes_.size());
  const Mesh& mesh = meshes_[hit.mesh];
  const Face& face = mesh.faces[hit.face];
  const auto& normals = normals_[hit.mesh][hit.face];
  const float weight_a = 1.0F - hit.weight_b - hit.weight_c;
  SurfacePoint point;
  point.p_in_base = weight_a * mesh.vertices[face.vertices[0]] +
                    hit.weight_b * mesh.vertices[face.vertices[1]] +
                    hit.weight_c * mesh.vertices[face.vertices[2]];
  point.normal =
      (weight_a * normals[0] + hit.weight_b * normals[1] + hit.weight_c * normals[2]).normalized();
  if (point.normal.dot(direction) > 0.0F) point.normal = -point.normal;
  return point;
}

SurfacePoint SceneGeometry::PointAt(const Hit& hit, const Eigen::Vector3f& direction) const {
  SurfacePoint point = ShapeAt(hit, direction);
  const Face& face = meshes_[hit.mesh].faces[hit.face];
  point.material = &scene_->objects[hit.mesh].object.materials[face.surface.material];
  point.albedo = Albedo(*point.material, object_from_base_[hit.mesh] * point.p_in_base);
  return point;
}

bool SceneGeometry::IsTarget(const Hit& hit) const {
  return hit.mesh != Hit::kNothing && scene_->objects[hit.mesh].is_target;
}

bool SceneGeometry::IsGraspable(const Hit& hit) const {
  return IsTarget(hit) && meshes_[hit.mesh].faces[hit.face].surface.graspable;
}

}  // namespace handcraft::synthetic
