// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

// Twice the area long; zero for a face without area.
Vector3f AreaNormal(const Mesh& mesh, const Face& face) {
  const Vector3f& a = mesh.vertices[face.vertices[0]];
  return (mesh.vertices[face.vertices[1]] - a).cross(mesh.vertices[face.vertices[2]] - a);
}

}  // namespace

void Append(Mesh& mesh, const Mesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (Face face : other.faces) {
    for (std::uint32_t& vertex : face.vertices) vertex += offset;
    mesh.faces.push_back(face);
  }
}

void Transform(Mesh& mesh, const Eigen::Isometry3f& target_from_source) {
  for (Vector3f& vertex : mesh.vertices) vertex = target_from_source * vertex;
}

void RestOnTable(Mesh& mesh) {
  const float lowest_m = Bounds(mesh).min().z();
  for (Vector3f& vertex : mesh.vertices) vertex.z() -= lowest_m;
}

void LieAlongX(Mesh& mesh) {
  for (Vector3f& vertex : mesh.vertices) vertex = {vertex.z(), vertex.x(), vertex.y()};
  const float middle_m = Bounds(mesh).center().x();
  for (Vector3f& vertex : mesh.vertices) vertex.x() -= middle_m;
  RestOnTable(mesh);
}

bool IsClosed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Face& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++uses[{face.vertices[i], face.vertices[(i + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : uses) {
    const auto reverse = uses.find({edge.second, edge.first});
    if (count != 1 || reverse == uses.end() || reverse->second != 1) return false;
  }
  return !uses.empty();
}

double Volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3d a = mesh.vertices[face.vertices[0]].cast<double>();
    const Eigen::Vector3d b = mesh.vertices[face.vertices[1]].cast<double>();
    const Eigen::Vector3d c = mesh.vertices[face.vertices[2]].cast<double>();
    sum += a.dot(b.cross(c));
  }
  return sum / 6.0;
}

Areas SurfaceAreas(const Mesh& mesh) {
  Areas areas;
  for (const Face& face : mesh.faces) {
    const double area = 0.5 * static_cast<double>(AreaNormal(mesh, face).norm());
    areas.all += area;
    if (face.surface.graspable) areas.graspable += area;
  }
  return areas;
}

Eigen::AlignedBox3f Bounds(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Vector3f& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

std::vector<std::array<Vector3f, 3>> CornerNormals(const Mesh& mesh, float crease_rad) {
  std::vector<Vector3f> area_normals;
  std::vector<std::vector<std::uint32_t>> faces_around(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const std::uint32_t vertex : face.vertices) {
      faces_around[vertex].push_back(static_cast<std::uint32_t>(area_normals.size()));
    }
    area_normals.push_back(AreaNormal(mesh, face));
  }
  const float least_cosine = std::cos(crease_rad);
  std::vector<std::array<Vector3f, 3>> normals(mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Vector3f own = area_normals[i].normalized();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vector3f sum = area_normals[i];
      for (const std::uint32_t other : faces_around[mesh.faces[i].vertices[corner]]) {
        const Vector3f& normal = area_normals[other];
        if (other != i && own.dot(normal) > least_cosine * normal.norm()) sum += normal;
      }
      normals[i][corner] = sum.normalized();
    }
  }
  return normals;
}

}  // namespace handcraft::synthetic
