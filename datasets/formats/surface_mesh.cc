// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/surface_mesh.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "datasets/formats/obj_mesh.h"
#include "datasets/formats/ply_mesh.h"
#include "datasets/formats/stl_mesh.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 28;

std::string LowerEnding(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return ending;
}

}  // namespace

void SurfaceMesh::AddFace(std::span<const std::uint32_t> face_vertices,
                          std::span<const std::uint32_t> texture,
                          std::uint32_t part) {
  HC_CHECK(face_vertices.size() >= 3, face_vertices.size());
  HC_CHECK(texture.empty() || texture.size() == face_vertices.size(), texture.size());
  for (std::size_t i = 1; i + 1 < face_vertices.size(); ++i) {
    Triangle triangle{.vertices = {face_vertices[0], face_vertices[i], face_vertices[i + 1]},
                      .face = num_faces,
                      .part = part};
    if (!texture.empty()) triangle.texture = {texture[0], texture[i], texture[i + 1]};
    triangles.push_back(triangle);
  }
  ++num_faces;
}

SurfaceMesh ReadSurfaceMesh(const std::filesystem::path& path) {
  const std::string ending = LowerEnding(path);
  if (ending != ".obj" && ending != ".stl" && ending != ".ply") {
    throw Error({.path = path.string(),
                 .reason = "ends with \"" + ending + "\"; a mesh ends with .obj, .stl or .ply",
                 .remedy = "convert it to one of those"});
  }
  const std::vector<std::uint8_t> bytes = ReadFile(path, kMaxBytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  SurfaceMesh mesh = ending == ".obj"   ? ParseObj(path, text)
                     : ending == ".stl" ? ParseStl(path, text)
                                        : ParsePly(path, text);
  if (mesh.triangles.empty()) {
    throw Error({.path = path.string(), .reason = "has no face; a surface is due"});
  }
  return mesh;
}

}  // namespace handcraft::datasets
