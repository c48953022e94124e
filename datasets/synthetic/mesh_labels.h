// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <vector>

#include "datasets/formats/surface_mesh.h"
#include "datasets/synthetic/mesh_file.h"

namespace handcraft::synthetic {

/// Which triangles of a mesh, its vertices already in the object's frame [m], are graspable: by the
/// one way that the options name. A triangle that the edge of a part or of what a texture marks
/// crosses is cut into four, and those again, until it is at most 2 mm or four of the texture's
/// pixels wide (at most seven times, and to a million triangles in all; T-junctions stay); then its
/// centroid decides. Throws Error naming the file as ReadMeshFile does. `path` is the mesh's, for
/// messages.
[[nodiscard]] std::vector<bool> LabelTriangles(const std::filesystem::path& path,
                                               datasets::SurfaceMesh& mesh,
                                               const MeshFileOptions& options);

}  // namespace handcraft::synthetic
