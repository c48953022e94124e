// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string_view>

#include "datasets/formats/surface_mesh.h"

namespace handcraft::datasets {

/// The surface that the bytes of a PLY file describe: format ascii, binary_little_endian or
/// binary_big_endian; of the element vertex the properties x, y, z and, for texture, s, t or u, v
/// or texture_u, texture_v; of the element face the list vertex_indices or vertex_index. All else
/// is skipped. Throws Error naming file and line or byte for a head that is none, an element or a
/// property that is missing, a file that ends too early, a vertex that is not finite, a face of
/// less than three corners and an index without its vertex. Source: Turk, The PLY Polygon File
/// Format (1994).
[[nodiscard]] SurfaceMesh ParsePly(const std::filesystem::path& path, std::string_view bytes);

}  // namespace handcraft::datasets
