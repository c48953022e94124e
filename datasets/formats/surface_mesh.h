// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace handcraft::datasets {

/// The faces of a surface as a file of meshes has them: its own unit and axes, vertices neither
/// joined nor turned. Faces of more than three corners are cut into fans, so they should be convex.
struct SurfaceMesh {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    std::array<std::uint32_t, 3> texture = {kNone, kNone, kNone};  ///< into texture_coordinates
    std::uint32_t face = 0;  ///< which of the file's faces it is of, from 0 in the file's order
    std::uint32_t part = 0;  ///< into parts
  };

  /// What the file calls the faces; empty where it says nothing.
  struct Part {
    std::string object;    ///< OBJ: o; STL: the solid's name
    std::string group;     ///< OBJ: g
    std::string material;  ///< OBJ: usemtl
  };

  std::vector<Eigen::Vector3f> vertices;             ///< finite
  std::vector<Eigen::Vector2f> texture_coordinates;  ///< u to the right, v upwards, 1 the whole
  std::vector<Triangle> triangles;                   ///< at least one; every index is within range
  std::vector<Part> parts;                           ///< at least one
  std::uint32_t num_faces = 0;
  std::map<std::string, Eigen::Vector3f> diffuse;  ///< material → red, green, blue (MTL: Kd)

  /// Adds a face of three corners or more. `texture` is empty or as long as `vertices`.
  void AddFace(std::span<const std::uint32_t> vertices,
               std::span<const std::uint32_t> texture,
               std::uint32_t part);
};

/// Reads .obj, .stl or .ply (in either case) as read by obj_mesh.h, stl_mesh.h and ply_mesh.h.
/// Throws Error naming file and place for another ending, a file that cannot be read, is broken or
/// has more than 256 MiB or no face. The same bytes give the same mesh.
[[nodiscard]] SurfaceMesh ReadSurfaceMesh(const std::filesystem::path& path);

}  // namespace handcraft::datasets
