// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

namespace handcraft::synthetic {

/// What a face is made of, and whether a person would grasp the object there.
struct Surface {
  std::uint8_t material = 0;  ///< index into the object's materials
  bool graspable = false;
};

struct Face {
  std::array<std::uint32_t, 3> vertices{};  ///< counter-clockwise seen from outside
  Surface surface;
};

/// A triangle mesh with a part label on each face. Lengths in metres.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Face> faces;
};

/// Adds the other mesh's vertices and faces; nothing is cut where they overlap.
void Append(Mesh& mesh, const Mesh& other);

/// Moves every vertex. A rigid motion keeps the faces' orientation.
void Transform(Mesh& mesh, const Eigen::Isometry3f& target_from_source);

/// Puts the lowest vertex on z = 0.
void RestOnTable(Mesh& mesh);

/// Lays down what was built along z: z becomes x, x becomes y, y becomes z; then the middle of its
/// length is put on x = 0 and it rests on the table.
void LieAlongX(Mesh& mesh);

/// Whether every edge is shared by exactly two faces that run along it in opposite directions.
[[nodiscard]] bool IsClosed(const Mesh& mesh);

/// Enclosed volume [m³]: Σ a·(b × c) / 6 over the faces; positive when they face outwards. Parts
/// that overlap count twice.
[[nodiscard]] double Volume(const Mesh& mesh);

/// Area of all faces, and of the graspable ones alone [m²].
struct Areas {
  double all = 0.0;
  double graspable = 0.0;
};
[[nodiscard]] Areas SurfaceAreas(const Mesh& mesh);

/// Smallest box around the vertices; empty for no vertices.
[[nodiscard]] Eigen::AlignedBox3f Bounds(const Mesh& mesh);

/// Unit normals at the three corners of each face, for smooth shading: the mean, weighted by area,
/// of the normals of those faces around the corner that differ from the face's by less than
/// `crease_rad`.
[[nodiscard]] std::vector<std::array<Eigen::Vector3f, 3>> CornerNormals(const Mesh& mesh,
                                                                        float crease_rad);

}  // namespace handcraft::synthetic
