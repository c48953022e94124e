// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/synthetic/material.h"
#include "datasets/synthetic/mesh.h"

namespace handcraft::synthetic {

/// Which axis of a file points upwards.
enum class UpAxis { kX, kY, kZ };

/// How a file of a mesh is read, and what of it is graspable: one of the four ways below.
struct MeshFileOptions {
  float unit_m = 1.0F;  ///< how long the file's 1 is [m], > 0
  UpAxis up = UpAxis::kZ;
  float turn_rad = 0.0F;  ///< about z, after the up axis, so that the front faces +x

  /// Graspable are the faces whose object, group or material bears one of these names,
  std::vector<std::string> names = {};
  /// or those where this picture, by the file's texture coordinates, is 128 or more,
  std::filesystem::path texture = {};
  /// or those whose line in this file of a line a face, in the mesh file's order, is 1 and not 0,
  std::filesystem::path face_labels = {};
  /// or those whose centroid lies within, or 2 mm from, one of these convex meshes (which have the
  /// unit and the axes of the file).
  std::vector<std::filesystem::path> parts = {};

  /// The linear map from the file's coordinates to the object's [m].
  [[nodiscard]] Eigen::Matrix3f ObjectFromFile() const;

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// A mesh with its labels, on z = 0 with the middle of the box around it on the z axis. A face's
/// material is its place in `diffuse`.
struct LabelledMesh {
  Mesh mesh;
  std::vector<std::optional<Colour>> diffuse;  ///< at least one; nothing: the file gives no colour
};

/// Reads .obj, .stl or .ply: joins vertices that lie in the same micrometre, drops faces without
/// area, and cuts faces as mesh_labels.h says. Throws Error naming the file for what
/// ReadSurfaceMesh refuses, for a mesh smaller than 5 mm or larger than 1 m, labels that do not
/// fit, a name that nothing bears, more than 250 materials, and a mesh of which nothing is
/// graspable. The same files, the same mesh.
[[nodiscard]] LabelledMesh ReadMeshFile(const std::filesystem::path& path,
                                        const MeshFileOptions& options);

}  // namespace handcraft::synthetic
