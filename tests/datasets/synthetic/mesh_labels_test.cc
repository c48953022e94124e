// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh_labels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/image.h"
#include "lib/perception/image_io.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

using datasets::SurfaceMesh;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

// A square of 0.1 m in z = 0 as one face, the whole texture on it.
SurfaceMesh Square() {
  SurfaceMesh mesh;
  mesh.parts.push_back({.object = "square", .group = {}, .material = {}});
  mesh.vertices = {{0.0F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}, {0.1F, 0.1F, 0.0F}, {0.0F, 0.1F, 0.0F}};
  mesh.texture_coordinates = {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}};
  const std::array<std::uint32_t, 4> corners = {0, 1, 2, 3};
  mesh.AddFace(corners, corners, 0);
  return mesh;
}

struct Areas {
  double all = 0.0;
  double graspable = 0.0;
  Eigen::Vector3f farthest = Eigen::Vector3f::Zero();  // of the graspable ones, by each coordinate
};

Areas AreasOf(const SurfaceMesh& mesh, const std::vector<bool>& flags) {
  Areas areas;
  EXPECT_EQ(mesh.triangles.size(), flags.size());
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i].vertices;
    const Eigen::Vector3f ab = mesh.vertices[b] - mesh.vertices[a];
    const Eigen::Vector3f normal = ab.cross(mesh.vertices[c] - mesh.vertices[a]);
    EXPECT_GT(normal.z(), 0.0F) << "cut as the whole is turned";
    areas.all += 0.5 * static_cast<double>(normal.norm());
    if (!flags[i]) continue;
    areas.graspable += 0.5 * static_cast<double>(normal.norm());
    for (const std::uint32_t vertex : mesh.triangles[i].vertices) {
      areas.farthest = areas.farthest.cwiseMax(mesh.vertices[vertex]);
    }
  }
  return areas;
}

// A pyramid over a triangle, x + y ≤ 0.05 m, whose faces turn every way.
constexpr std::string_view kPyramid =
    "v 0 0 -.05\nv .05 0 -.05\nv 0 .05 -.05\nv 0 0 .05\nv .05 0 .05\nv 0 .05 .05\n"
    "f 1 2 3\nf 4 5 6\nf 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 5 6\nf 1 3 6\nf 1 6 4\n";

TEST(LabelTriangles, CutsWhereAConvexPartEnds) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "part.obj", kPyramid);
  SurfaceMesh mesh = Square();
  const std::vector<bool> flags = LabelTriangles("a.obj", mesh, {.parts = {folder / "part.obj"}});
  const Areas areas = AreasOf(mesh, flags);
  EXPECT_NEAR(areas.all, 0.01, 1e-6);
  // With 2 mm about it the right angle's legs are 0.05 + 2 mm √2 long from the square's corner.
  const double leg_m = 0.05 + 0.002 * std::sqrt(2.0);
  EXPECT_NEAR(areas.graspable, 0.5 * leg_m * leg_m, 0.02 * areas.graspable);
  EXPECT_LT(areas.farthest.x(), 0.055F);
}

TEST(LabelTriangles, JoinsWhatSeveralPartsHold) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "part.obj", kPyramid);
  SurfaceMesh once = Square();
  SurfaceMesh twice = Square();
  const MeshFileOptions one{.parts = {folder / "part.obj"}};
  const MeshFileOptions two{.parts = {folder / "part.obj", folder / "part.obj"}};
  EXPECT_EQ(LabelTriangles("a.obj", once, one), LabelTriangles("a.obj", twice, two));
}

TEST(LabelTriangles, CutsWhereATextureChangesAndKeepsTheFileNumbers) {
  const TemporaryDirectory folder;
  Image texture(100, 50);
  for (int v = 0; v < 25; ++v) {  // the upper half, of which the file says v > 0.5
    for (int u = 0; u < 100; ++u) texture.At(u, v) = v < 10 ? 128 : 255;
  }
  perception::WritePng(folder / "labels.png", texture);
  SurfaceMesh mesh = Square();
  const std::vector<bool> flags = LabelTriangles("a.obj", mesh, {.texture = folder / "labels.png"});
  const Areas areas = AreasOf(mesh, flags);
  EXPECT_NEAR(areas.all, 0.01, 1e-6);
  EXPECT_NEAR(areas.graspable, 0.005, 0.0003);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    EXPECT_EQ(mesh.triangles[i].face, 0U);
    const auto& corners = mesh.triangles[i].vertices;
    const float mean = (mesh.vertices[corners[0]].y() + mesh.vertices[corners[1]].y() +
                        mesh.vertices[corners[2]].y()) /
                       3.0F;
    if (std::abs(mean - 0.05F) <= 0.004F) continue;
    EXPECT_EQ(flags[i], mean > 0.05F);
  }
}

TEST(LabelTriangles, CutsNothingWhereOneLabelHolds) {
  const TemporaryDirectory folder;
  perception::WritePng(folder / "labels.png", Image(10, 10));
  SurfaceMesh mesh = Square();
  EXPECT_EQ(LabelTriangles("a.obj", mesh, {.texture = folder / "labels.png"}),
            (std::vector<bool>{false, false}));
  EXPECT_EQ(LabelTriangles("a.obj", mesh, {.names = {"square"}}), (std::vector<bool>{true, true}));
}

TEST(LabelTriangles, NamesTheFileThatIsWrong) {
  const TemporaryDirectory folder;
  SurfaceMesh mesh = Square();
  EXPECT_THROWS_MESSAGE((void)LabelTriangles("a.obj", mesh, {.names = {"round"}}),
                        Error,
                        HasSubstr("a.obj: no face has the object, group or material \"round\""));
  EXPECT_THROWS_MESSAGE((void)LabelTriangles("a.obj", mesh, {.texture = folder / "no.png"}),
                        Error,
                        HasSubstr("no.png"));
  WriteFileAtomically(folder / "labels.txt", "1 0\n");
  EXPECT_THROWS_MESSAGE((void)LabelTriangles("a.obj", mesh, {.face_labels = folder / "labels.txt"}),
                        Error,
                        HasSubstr("labels.txt:1: one label a line is due: 0 or 1"));
}

}  // namespace
}  // namespace handcraft::synthetic
