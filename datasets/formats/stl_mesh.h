// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string_view>

#include "datasets/formats/surface_mesh.h"

namespace handcraft::datasets {

/// The surface that the bytes of an STL file describe, binary or text. Binary: 80 bytes, the number
/// n of faces in 4, then 50 bytes a face, little-endian: normal, three vertices, 2 bytes. A file of
/// just 84 + 50 n bytes is binary, even where it begins with "solid". In text each solid is a part
/// that bears its name. Normals are not read: they follow from the vertices. Throws Error naming
/// file and byte or line for a file of another length, a number that is none, a line that is not
/// due and a text without its end. Source: 3D Systems, StereoLithography Interface Specification.
[[nodiscard]] SurfaceMesh ParseStl(const std::filesystem::path& path, std::string_view bytes);

}  // namespace handcraft::datasets
