// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes from anywhere: a reader makes a mesh of which every index leads somewhere, or throws
// handcraft::Error, and does nothing else. The first byte chooses the reader, the rest is the file.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "datasets/formats/obj_mesh.h"
#include "datasets/formats/ply_mesh.h"
#include "datasets/formats/stl_mesh.h"
#include "lib/core/error.h"
#include "tests/fuzz/fuzzed_file.h"

namespace handcraft::datasets {
namespace {

using testing::FuzzedFile;
using testing::Require;

void RequireWhole(const SurfaceMesh& mesh) {
  for (const Eigen::Vector3f& vertex : mesh.vertices) Require(vertex.allFinite());
  Require(!mesh.parts.empty() || mesh.triangles.empty());
  Require(mesh.num_faces <= mesh.triangles.size());
  for (const SurfaceMesh::Triangle& triangle : mesh.triangles) {
    Require(triangle.part < mesh.parts.size());
    Require(triangle.face < mesh.num_faces);
    for (const std::uint32_t vertex : triangle.vertices) Require(vertex < mesh.vertices.size());
    for (const std::uint32_t at : triangle.texture) {
      Require(at == SurfaceMesh::kNone || at < mesh.texture_coordinates.size());
    }
  }
}

void ReadObj(std::string_view bytes) { RequireWhole(ParseObj("no_folder/a.obj", bytes)); }

void ReadStl(std::string_view bytes) { RequireWhole(ParseStl("a.stl", bytes)); }

void ReadPly(std::string_view bytes) { RequireWhole(ParsePly("a.ply", bytes)); }

// The materials of an OBJ file.
void ReadMtl(std::string_view bytes) {
  static const FuzzedFile kFile;
  static const std::filesystem::path kFolder = kFile.FolderOf("a.mtl");
  kFile.Fill(bytes);
  const SurfaceMesh mesh =
      ParseObj(kFolder / "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  Require(mesh.triangles.size() == 1);
  RequireWhole(mesh);
}

constexpr auto kReaders =
    std::to_array<void (*)(std::string_view)>({ReadObj, ReadStl, ReadPly, ReadMtl});

}  // namespace
}  // namespace handcraft::datasets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using handcraft::datasets::kReaders;
  if (size == 0) return 0;
  try {
    kReaders[data[0] % kReaders.size()]({reinterpret_cast<const char*>(data) + 1, size - 1});
  } catch (const handcraft::Error& error) {
    handcraft::testing::Require(error.what()[0] != '\0');
  }
  return 0;
}
