// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "datasets/formats/surface_mesh.h"
#include "datasets/synthetic/mesh_labels.h"
#include "datasets/synthetic/object_parts.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using datasets::SurfaceMesh;
using Eigen::Vector3f;

constexpr float kSmallestM = 0.005F;
constexpr float kLargestM = 1.0F;
constexpr float kLowestM = 1e-4F;
constexpr std::size_t kMostMaterials = 250;

[[noreturn]] void Refuse(const fs::path& path, std::string reason, std::string remedy) {
  throw Error({.path = path.string(), .reason = std::move(reason), .remedy = std::move(remedy)});
}

void CheckSize(const fs::path& path, const SurfaceMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const SurfaceMesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle.vertices) box.extend(mesh.vertices[vertex]);
  }
  const float size_m = box.sizes().maxCoeff();
  if (!(size_m >= kSmallestM && size_m <= kLargestM)) {
    Refuse(path,
           "is " + NumberToText(size_m) + " m long; 0.005 to 1 m are due",
           "check its unit: \"m\", \"cm\", \"mm\" or \"inch\"");
  }
  const float height_m = box.sizes().z();
  if (height_m >= kLowestM) return;
  Refuse(
      path,
      "is flat: " + NumberToText(height_m) + " m high, so that it would lie within the table's top",
      "give it a thickness of 0.0001 m or more, or name the axis that points upwards as \"up\"");
}

// Vertices in the same micrometre become one.
class Welder {
 public:
  std::uint32_t Add(const Vector3f& at, Mesh& mesh) {
    std::array<std::int64_t, 3> cell{};
    for (std::size_t i = 0; i < 3; ++i) {
      cell[i] = std::llround(1e6 * static_cast<double>(at[static_cast<Eigen::Index>(i)]));
    }
    const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto [found, is_new] = vertices_.try_emplace(cell, next);
    if (is_new) mesh.vertices.push_back(at);
    return found->second;
  }

 private:
  std::map<std::array<std::int64_t, 3>, std::uint32_t> vertices_;
};

// The material of each part: 0 where the file gives no colour.
std::vector<std::uint8_t> MaterialsOf(const fs::path& path,
                                      const SurfaceMesh& mesh,
                                      std::vector<std::optional<Colour>>& diffuse) {
  diffuse = {std::nullopt};
  std::map<std::string, std::uint8_t> known;
  std::vector<std::uint8_t> materials;
  for (const SurfaceMesh::Part& part : mesh.parts) {
    const auto colour = mesh.diffuse.find(part.material);
    if (colour == mesh.diffuse.end()) {
      materials.push_back(0);
      continue;
    }
    if (diffuse.size() > kMostMaterials) Refuse(path, "has more than 250 materials", "merge them");
    const auto [found, is_new] =
        known.try_emplace(part.material, static_cast<std::uint8_t>(diffuse.size()));
    if (is_new) diffuse.emplace_back(colour->second.cwiseMax(0.0F).cwiseMin(1.0F));
    materials.push_back(found->second);
  }
  return materials;
}

}  // namespace

Eigen::Matrix3f MeshFileOptions::ObjectFromFile() const {
  Eigen::Matrix3f upright = Eigen::Matrix3f::Identity();
  if (up == UpAxis::kY) upright << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  if (up == UpAxis::kX) upright << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  const Eigen::AngleAxisf turn(turn_rad, Vector3f::UnitZ());
  return unit_m * (turn.toRotationMatrix() * upright);
}

void MeshFileOptions::Validate() const {
  RequireOption(std::isfinite(unit_m) && unit_m > 0.0F, "MeshFileOptions.unit_m", unit_m, "> 0");
  RequireOption(std::isfinite(turn_rad), "MeshFileOptions.turn_rad", turn_rad, "a finite number");
  const int num_ways = (names.empty() ? 0 : 1) + (texture.empty() ? 0 : 1) +
                       (face_labels.empty() ? 0 : 1) + (parts.empty() ? 0 : 1);
  RequireOption(
      num_ways == 1,
      "The number of MeshFileOptions.names, texture, face_labels and parts that are given",
      num_ways,
      "1");
}

LabelledMesh ReadMeshFile(const fs::path& path, const MeshFileOptions& options) {
  options.Validate();
  SurfaceMesh source = datasets::ReadSurfaceMesh(path);
  const Eigen::Matrix3f object_from_file = options.ObjectFromFile();
  for (Vector3f& vertex : source.vertices) vertex = object_from_file * vertex;
  CheckSize(path, source);
  const std::vector<bool> graspable = LabelTriangles(path, source, options);
  LabelledMesh labelled;
  const std::vector<std::uint8_t> materials = MaterialsOf(path, source, labelled.diffuse);
  Welder welder;
  for (std::size_t i = 0; i < source.triangles.size(); ++i) {
    const SurfaceMesh::Triangle& triangle = source.triangles[i];
    Face face{.vertices = {}, .surface = {materials[triangle.part], graspable[i]}};
    for (std::size_t k = 0; k < 3; ++k) {
      face.vertices[k] = welder.Add(source.vertices[triangle.vertices[k]], labelled.mesh);
    }
    const auto [a, b, c] = face.vertices;
    const std::vector<Vector3f>& at = labelled.mesh.vertices;
    const bool has_area = (at[b] - at[a]).cross(at[c] - at[a]).norm() > 1e-14F;
    if (has_area) labelled.mesh.faces.push_back(face);
  }
  if (SurfaceAreas(labelled.mesh).graspable <= 0.0) {
    Refuse(path, "nothing of it is marked as graspable", "look at what marks it");
  }
  CentreOnTable(labelled.mesh);
  return labelled;
}

}  // namespace handcraft::synthetic
