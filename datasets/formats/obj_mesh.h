// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string_view>

#include "datasets/formats/surface_mesh.h"

namespace handcraft::datasets {

/// The surface that the text of a Wavefront OBJ file describes: v (more than three numbers are
/// cut), vt, f with any of i, i/t, i//n, i/t/n and negative indices, o, g, usemtl, mtllib; other
/// lines are skipped. Of the MTL files, which lie in the same folder or below, newmtl and Kd are
/// read; one that is not there is no fault. Throws Error naming file and line for a number that is
/// none, an index of something that is not there yet and a face of less than three corners.
/// Source: Wavefront's Advanced Visualizer manual, appendix B1 (object files).
[[nodiscard]] SurfaceMesh ParseObj(const std::filesystem::path& path, std::string_view text);

}  // namespace handcraft::datasets
