// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh_file.h"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/image.h"
#include "lib/perception/image_io.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

// A box as an OBJ of six faces in the order bottom, top, −y, +x, +y, −x; every face has the whole
// texture. The top is group "lid", painted red.
std::string Box(float x, float y, float z, float low = 0.0F) {
  std::string text = "mtllib box.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  for (int i = 0; i < 8; ++i) {
    text += "v " + std::to_string(i % 2 == 0 ? 0.0F : x) + " " +
            std::to_string(i / 2 % 2 == 0 ? 0.0F : y) + " " + std::to_string(i < 4 ? low : z) +
            "\n";
  }
  return text +
         "o box\nf 1/1 3/2 4/3 2/4\ng lid\nusemtl red\nf 5/1 6/2 8/3 7/4\n"
         "g sides\nusemtl plain\nf 1/1 2/2 6/3 5/4\nf 2/1 4/2 8/3 6/4\n"
         "f 4/1 3/2 7/3 8/4\nf 3/1 1/2 5/3 7/4\n";
}

class ReadMeshFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    WriteFileAtomically(folder_ / "box.obj", Box(0.1F, 0.2F, 0.3F));
    WriteFileAtomically(folder_ / "box.mtl", "newmtl red\nKd 1 0 0\n");
  }

  [[nodiscard]] LabelledMesh Read(const MeshFileOptions& options) const {
    return ReadMeshFile(folder_ / "box.obj", options);
  }

  TemporaryDirectory folder_;
};

TEST_F(ReadMeshFileTest, LabelsByNameOfGroupMaterialOrObject) {
  for (const char* name : {"lid", "red"}) {
    const LabelledMesh box = Read({.names = {name}});
    EXPECT_NEAR(SurfaceAreas(box.mesh).graspable, 0.1 * 0.2, 1e-6) << name;
    EXPECT_NEAR(SurfaceAreas(box.mesh).all, 0.04 + 0.06 + 0.12, 1e-6);
    EXPECT_NEAR(Volume(box.mesh), 0.1 * 0.2 * 0.3, 1e-7);
    EXPECT_TRUE(IsClosed(box.mesh));
  }
  const LabelledMesh all = Read({.names = {"box"}});
  EXPECT_DOUBLE_EQ(SurfaceAreas(all.mesh).graspable, SurfaceAreas(all.mesh).all);
}

TEST_F(ReadMeshFileTest, CentresOnTheTableAndKeepsColours) {
  const LabelledMesh box = Read({.names = {"lid"}});
  EXPECT_TRUE(Bounds(box.mesh).min().isApprox(Eigen::Vector3f(-0.05F, -0.1F, 0.0F), 1e-5F));
  ASSERT_EQ(box.diffuse.size(), 2U);
  EXPECT_FALSE(box.diffuse[0].has_value());
  EXPECT_EQ(box.diffuse[1], Colour(1, 0, 0));
  for (const Face& face : box.mesh.faces) {
    EXPECT_EQ(face.surface.material, face.surface.graspable ? 1 : 0);
  }
}

TEST_F(ReadMeshFileTest, TurnsUpAxisAndFront) {
  const auto sizes = [&](UpAxis up, float turn_rad) {
    return Bounds(Read({.up = up, .turn_rad = turn_rad, .names = {"lid"}}).mesh).sizes().eval();
  };
  EXPECT_TRUE(sizes(UpAxis::kY, 0.0F).isApprox(Eigen::Vector3f(0.3F, 0.1F, 0.2F), 1e-5F));
  EXPECT_TRUE(sizes(UpAxis::kX, 0.0F).isApprox(Eigen::Vector3f(0.2F, 0.3F, 0.1F), 1e-5F));
  const float quarter_rad = 0.5F * std::numbers::pi_v<float>;
  EXPECT_TRUE(sizes(UpAxis::kZ, quarter_rad).isApprox(Eigen::Vector3f(0.2F, 0.1F, 0.3F), 1e-5F));
  EXPECT_GT(Volume(Read({.up = UpAxis::kY, .names = {"lid"}}).mesh), 0.0) << "not mirrored";
}

TEST_F(ReadMeshFileTest, LabelsByALineAFace) {
  WriteFileAtomically(folder_ / "labels.txt", "0\n1\n0\n0\n0\n1\n");
  const LabelledMesh box = Read({.face_labels = folder_ / "labels.txt"});
  EXPECT_NEAR(SurfaceAreas(box.mesh).graspable, 0.1 * 0.2 + 0.2 * 0.3, 1e-6);
  WriteFileAtomically(folder_ / "labels.txt", "0\n1\n");
  EXPECT_THROWS_MESSAGE((void)Read({.face_labels = folder_ / "labels.txt"}),
                        Error,
                        HasSubstr("labels.txt: has 2 labels; the mesh has 6 faces"));
  WriteFileAtomically(folder_ / "labels.txt", "0\n2\n");
  EXPECT_THROWS_MESSAGE((void)Read({.face_labels = folder_ / "labels.txt"}),
                        Error,
                        HasSubstr("labels.txt:2: \"2\" is no whole number from 0 to 1"));
}

TEST_F(ReadMeshFileTest, LabelsByATextureFinerThanTheFaces) {
  Image texture(64, 64);
  for (int v = 0; v < 64; ++v) {
    for (int u = 0; u < 16; ++u) texture.At(u, v) = 255;  // the left quarter
  }
  perception::WritePng(folder_ / "labels.png", texture);
  const LabelledMesh box = Read({.texture = folder_ / "labels.png"});
  const Areas areas = SurfaceAreas(box.mesh);
  EXPECT_NEAR(areas.all, 0.22, 1e-5);
  EXPECT_NEAR(areas.graspable, 0.25 * areas.all, 0.02 * areas.all) << "to a pixel or so";
  EXPECT_LT(box.mesh.faces.size(), 4000U) << "only what the edge crosses is cut";
}

TEST_F(ReadMeshFileTest, LabelsByConvexParts) {
  // Slabs as wide as the box: what lies within them or up to 2 mm beyond, a band round the sides
  // (0.6 m about) and, but for the last, the top (0.02 m²).
  const auto graspable_area = [&](float low_m, float high_m) {
    WriteFileAtomically(folder_ / "slab.obj", Box(0.1F, 0.2F, high_m, low_m));
    return SurfaceAreas(Read({.parts = {folder_ / "slab.obj"}}).mesh).graspable;
  };
  const double tolerance = 0.6 * 0.001;  // what is at most 2 mm wide is not cut
  EXPECT_NEAR(graspable_area(0.29F, 0.31F), 0.02 + 0.6 * 0.012, tolerance);
  EXPECT_NEAR(graspable_area(0.25F, 0.2985F), 0.02 + 0.6 * 0.052, tolerance);
  EXPECT_NEAR(graspable_area(0.25F, 0.2975F), 0.6 * 0.0515, tolerance);
}

TEST_F(ReadMeshFileTest, RefusesWhatMarksNothing) {
  EXPECT_THROWS_MESSAGE((void)Read({.names = {"lid", "handle"}}),
                        Error,
                        HasSubstr("no face has the object, group or material \"handle\""));
  WriteFileAtomically(folder_ / "labels.txt", "0\n0\n0\n0\n0\n0\n");
  EXPECT_THROWS_MESSAGE((void)Read({.face_labels = folder_ / "labels.txt"}),
                        Error,
                        HasSubstr("box.obj: nothing of it is marked as graspable"));
  WriteFileAtomically(folder_ / "flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THROWS_MESSAGE((void)Read({.parts = {folder_ / "flat.obj"}}),
                        Error,
                        HasSubstr("flat.obj: encloses no volume; a convex part does"));
}

TEST_F(ReadMeshFileTest, RefusesAbsurdSizesAndHintsAtTheUnit) {
  EXPECT_THROWS_MESSAGE((void)Read({.unit_m = 0.001F, .names = {"lid"}}),
                        Error,
                        HasSubstr("m long; 0.005 to 1 m are due (check its unit: \"m\", \"cm\""));
  EXPECT_THROWS_MESSAGE(
      (void)Read({.unit_m = 10.0F, .names = {"lid"}}), Error, HasSubstr("is 3 m long"));
}

TEST_F(ReadMeshFileTest, RefusesAFlatMeshUnlessItStands) {
  WriteFileAtomically(folder_ / "box.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\no sheet\nf 1 2 3\n");
  EXPECT_THROWS_MESSAGE((void)Read({.names = {"sheet"}}),
                        Error,
                        HasSubstr("box.obj: is flat: 0 m high, so that it would lie within the "
                                  "table's top (give it a thickness"));
  EXPECT_EQ(Read({.up = UpAxis::kY, .names = {"sheet"}}).mesh.faces.size(), 1U);
}

TEST_F(ReadMeshFileTest, RefusesAMeshWithoutTextureCoordinates) {
  WriteFileAtomically(folder_ / "box.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\nf 1 2 3\n");
  perception::WritePng(folder_ / "labels.png", Image(8, 8));
  EXPECT_THROWS_MESSAGE((void)Read({.up = UpAxis::kY, .texture = folder_ / "labels.png"}),
                        Error,
                        HasSubstr("face 0 has no texture coordinates"));
}

TEST_F(ReadMeshFileTest, JoinsVerticesAndDropsFacesWithoutArea) {
  WriteFileAtomically(folder_ / "box.obj",
                      "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv .1 0 0\nv 0 .1 0\nv .1 .1 0\n"
                      "f 1 2 3\nf 4 6 5\nf 2 4 6\nf 1 1 2\n");
  WriteFileAtomically(folder_ / "labels.txt", "1\n0\n1\n1\n");
  const LabelledMesh square = Read({.up = UpAxis::kY, .face_labels = folder_ / "labels.txt"});
  EXPECT_EQ(square.mesh.vertices.size(), 4U);
  EXPECT_EQ(square.mesh.faces.size(), 2U);
  EXPECT_NEAR(SurfaceAreas(square.mesh).graspable, 0.005, 1e-7);
}

TEST(MeshFileOptions, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE((MeshFileOptions{.unit_m = 0.0F, .names = {"a"}}.Validate()),
                        Error,
                        HasSubstr("MeshFileOptions.unit_m is 0; it must be > 0"));
  EXPECT_THROWS_MESSAGE(MeshFileOptions{}.Validate(), Error, HasSubstr("given is 0; it must be 1"));
  EXPECT_THROWS_MESSAGE((MeshFileOptions{.names = {"a"}, .texture = "b.png"}.Validate()),
                        Error,
                        HasSubstr("given is 2; it must be 1"));
}

}  // namespace
}  // namespace handcraft::synthetic
