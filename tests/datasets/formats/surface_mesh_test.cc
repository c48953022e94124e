// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/surface_mesh.h"

#include <string>

#include <gtest/gtest.h>

#include "datasets/formats/obj_mesh.h"
#include "datasets/formats/ply_mesh.h"
#include "datasets/formats/stl_mesh.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kStl =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid\n";

TEST(AddFace, KeepsTheFileNumberOfEachTriangle) {
  SurfaceMesh mesh;
  mesh.AddFace(std::array<std::uint32_t, 3>{0, 1, 2}, {}, 0);
  mesh.AddFace(std::array<std::uint32_t, 5>{4, 5, 6, 7, 8}, {}, 1);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.num_faces, 2U);
  EXPECT_EQ(mesh.triangles[3].face, 1U);
  EXPECT_EQ(mesh.triangles[3].part, 1U);
  EXPECT_EQ(mesh.triangles[3].vertices, (std::array<std::uint32_t, 3>{4, 7, 8}));
}

TEST(ReadSurfaceMesh, ReadsTheThreeFormatsAlike) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.obj", kObj);
  WriteFileAtomically(folder / "a.ply", kPly);
  WriteFileAtomically(folder / "a.STL", kStl);
  for (const char* name : {"a.obj", "a.ply", "a.STL"}) {
    const SurfaceMesh mesh = ReadSurfaceMesh(folder / name);
    ASSERT_EQ(mesh.triangles.size(), 1U) << name;
    EXPECT_EQ(mesh.vertices[mesh.triangles[0].vertices[2]], Eigen::Vector3f(0, 1, 0)) << name;
  }
}

TEST(ReadSurfaceMesh, RefusesOtherFilesAndEmptyOnes) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.fbx", "");
  EXPECT_THROWS_MESSAGE((void)ReadSurfaceMesh(folder / "a.fbx"),
                        Error,
                        HasSubstr("ends with \".fbx\"; a mesh ends with .obj, .stl or .ply"));
  WriteFileAtomically(folder / "a.obj", "");
  EXPECT_THROWS_MESSAGE((void)ReadSurfaceMesh(folder / "a.obj"), Error, HasSubstr("has no face"));
  WriteFileAtomically(folder / "a.stl", "solid\nendsolid\n");
  EXPECT_THROWS_MESSAGE((void)ReadSurfaceMesh(folder / "a.stl"), Error, HasSubstr("has no face"));
  EXPECT_THROWS_MESSAGE((void)ReadSurfaceMesh(folder / "none.ply"), Error, HasSubstr("none.ply"));
}

// Whatever bytes: a mesh whose indices are within range, or an Error.
void ExpectMeshOrError(SurfaceMesh (*parse)(const std::filesystem::path&, std::string_view),
                       const std::string& bytes) {
  try {
    const SurfaceMesh mesh = parse("a", bytes);
    for (const SurfaceMesh::Triangle& triangle : mesh.triangles) {
      ASSERT_LT(triangle.part, mesh.parts.size());
      for (const std::uint32_t vertex : triangle.vertices) {
        ASSERT_LT(vertex, mesh.vertices.size());
      }
      for (const std::uint32_t at : triangle.texture) {
        ASSERT_TRUE(at == SurfaceMesh::kNone || at < mesh.texture_coordinates.size());
      }
    }
  } catch (const Error&) {
  }
}

TEST(ReadSurfaceMesh, TakesOrRefusesDamagedFilesOfEveryFormat) {
  Rng rng = Rng::Stream(1, "damage");
  for (int i = 0; i < 3000; ++i) {
    for (const auto& [parse, whole] :
         {std::pair{&ParseObj, kObj}, std::pair{&ParsePly, kPly}, std::pair{&ParseStl, kStl}}) {
      std::string bytes = whole;
      for (std::uint64_t k = rng.UniformInt(4) + 1; k > 0; --k) {
        bytes[rng.UniformInt(bytes.size())] = static_cast<char>(rng.UniformInt(256));
      }
      ExpectMeshOrError(parse, bytes);
    }
  }
}

}  // namespace
}  // namespace handcraft::datasets
