// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/obj_mesh.h"

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kSquare =
    "v 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

SurfaceMesh Parse(const std::string& text) { return ParseObj("a.obj", text); }

TEST(ParseObj, CutsAFaceOfFourCornersIntoAFan) {
  const SurfaceMesh mesh = Parse(std::string(kSquare) + "f 1/1 2/2 3/3 4/4\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.num_faces, 1U);
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles[1].vertices, (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.triangles[1].texture, (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.triangles[1].face, 0U);
}

TEST(ParseObj, TakesEveryFormOfACorner) {
  for (const std::string face : {"1 2 3", "1//1 2//1 3//1", "1/1/1 2/2/1 3/3/1", "-4 -3 -2"}) {
    const SurfaceMesh mesh = Parse(std::string(kSquare) + "vn 0 0 1\nf " + face + "\n");
    ASSERT_EQ(mesh.triangles.size(), 1U) << face;
    EXPECT_EQ(mesh.triangles[0].vertices, (std::array<std::uint32_t, 3>{0, 1, 2})) << face;
    EXPECT_EQ(mesh.triangles[0].texture[0] == 0, face == "1/1/1 2/2/1 3/3/1") << face;
  }
}

TEST(ParseObj, NamesThePartsInTheFilesOrder) {
  const SurfaceMesh mesh = Parse(std::string(kSquare) +
                                 "o pan\nusemtl steel\nf 1 2 3\ng long handle\nf 1 3 4\n"
                                 "usemtl wood\nf 1 2 4\n");
  ASSERT_EQ(mesh.triangles.size(), 3U);
  const auto part = [&](std::size_t i) { return mesh.parts[mesh.triangles[i].part]; };
  EXPECT_EQ(part(0).object, "pan");
  EXPECT_EQ(part(0).material, "steel");
  EXPECT_EQ(part(0).group, "");
  EXPECT_EQ(part(1).group, "long handle");
  EXPECT_EQ(part(2).material, "wood");
  EXPECT_EQ(part(2).object, "pan");
  EXPECT_EQ(mesh.triangles[2].face, 2U);
}

TEST(ParseObj, ReadsColoursOfTheMaterialsBesideIt) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.mtl",
                      "# colours\nKd 9 9 9\nnewmtl red\nKa 0 0 0\nKd 1 0.2 0.1\n");
  const std::string text = "mtllib a.mtl\nmtllib none.mtl\n" + std::string(kSquare) + "f 1 2 3\n";
  const SurfaceMesh mesh = ParseObj(folder / "a.obj", text);
  ASSERT_EQ(mesh.diffuse.size(), 1U);
  EXPECT_TRUE(mesh.diffuse.at("red").isApprox(Eigen::Vector3f(1.0F, 0.2F, 0.1F)));
}

TEST(ParseObj, RefusesAFileOfMaterialsOutsideTheFolder) {
  for (const std::string name : {"../a.mtl", "/etc/passwd", "b/../../a.mtl", ""}) {
    EXPECT_THROWS_MESSAGE((void)Parse("mtllib " + name + "\n"),
                          Error,
                          HasSubstr("a.obj:1: a file of materials lies in the folder or below it"));
  }
}

TEST(ParseObj, RefusesWhatIsBrokenByLine) {
  const std::string square(kSquare);
  EXPECT_THROWS_MESSAGE((void)Parse(square + "f 1 2 5\n"),
                        Error,
                        HasSubstr("a.obj:9: \"5\" names no vertex; 4 are above"));
  EXPECT_THROWS_MESSAGE((void)Parse(square + "f 0 1 2\n"), Error, HasSubstr("names no vertex"));
  EXPECT_THROWS_MESSAGE((void)Parse(square + "f -5 1 2\n"), Error, HasSubstr("names no vertex"));
  EXPECT_THROWS_MESSAGE((void)Parse(square + "f 1/9 2/1 3/1\n"),
                        Error,
                        HasSubstr("\"9\" names no texture coordinate; 4 are above"));
  EXPECT_THROWS_MESSAGE(
      (void)Parse(square + "f 99999999999999999999 1 2\n"), Error, HasSubstr("names no vertex"));
  EXPECT_THROWS_MESSAGE(
      (void)Parse(square + "f 1 2\n"), Error, HasSubstr("a face has three corners or more"));
  EXPECT_THROWS_MESSAGE(
      (void)Parse("v 0 nan 0\n"), Error, HasSubstr("a.obj:1: \"nan\" is no finite number"));
  EXPECT_THROWS_MESSAGE((void)Parse("v 0 1\n"), Error, HasSubstr("ends after 3 words"));
}

}  // namespace
}  // namespace handcraft::datasets
