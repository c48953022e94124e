// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh_catalogue.h"

#include <string>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr std::string_view kTetrahedron =
    "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\no foot\nf 1 3 2\no rest\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::string kEntry =
    "[[mesh]]\nfile = \"a.obj\"\nclass = \"mug\"\nfamily = \"trained\"\nlicence = \"CC0-1.0\"\n"
    "unit = \"cm\"\ngraspable_names = [\"foot\"]\n";

class ReadMeshCatalogueTest : public ::testing::Test {
 protected:
  void SetUp() override { WriteFileAtomically(folder_ / "a.obj", kTetrahedron); }

  [[nodiscard]] MeshCatalogue Read(const std::string& text) const {
    WriteFileAtomically(folder_ / "meshes.toml", text);
    return ReadMeshCatalogue(folder_.path());
  }

  void ExpectRefused(const std::string& text, const std::string& message) const {
    EXPECT_THROWS_MESSAGE((void)Read(text), Error, HasSubstr(message));
  }

  TemporaryDirectory folder_;
};

TEST_F(ReadMeshCatalogueTest, ReadsWhatEachMeshIs) {
  const MeshCatalogue catalogue =
      Read(kEntry + "scale = [0.5, 2]\nfinish = \"metal\"\ngraspable_finish = \"rubber\"\n" +
           "turn_deg = 90\nup = \"y\"\n" + kEntry);
  ASSERT_EQ(catalogue.meshes.size(), 2U);
  const CatalogueMesh& mesh = catalogue.meshes[0];
  EXPECT_EQ(mesh.object_class, "mug");
  EXPECT_EQ(mesh.family, Family::kTrained);
  EXPECT_EQ(mesh.licence, "CC0-1.0");
  EXPECT_FLOAT_EQ(mesh.least_scale, 0.5F);
  EXPECT_FLOAT_EQ(mesh.greatest_scale, 2.0F);
  EXPECT_EQ(mesh.finish, Finish::kMetal);
  EXPECT_EQ(mesh.graspable_finish, Finish::kRubber);
  EXPECT_NEAR(SurfaceAreas(mesh.labelled.mesh).graspable, 0.005, 1e-7);
  EXPECT_EQ(catalogue.meshes[1].graspable_finish, std::nullopt);
}

TEST_F(ReadMeshCatalogueTest, HasAFingerprintOfEveryByteBelow) {
  const std::string first = Read(kEntry).fingerprint;
  EXPECT_EQ(first.size(), 64U);
  EXPECT_EQ(Read(kEntry).fingerprint, first);
  EXPECT_NE(Read(kEntry + "\n").fingerprint, first);
  EXPECT_EQ(Read(kEntry).fingerprint, first);
  WriteFileAtomically(folder_ / "a.obj", std::string(kTetrahedron) + "\n");
  EXPECT_NE(Read(kEntry).fingerprint, first);
}

TEST_F(ReadMeshCatalogueTest, RefusesWhatIsWrongByFileAndLine) {
  ExpectRefused(kEntry + "colour = \"red\"\n", "meshes.toml:8: \"colour\" is no key of a mesh");
  ExpectRefused("[[mesh]]\nfile = \"a.obj\"\n", "meshes.toml:1: a mesh has no \"class\"");
  ExpectRefused(kEntry + "up = \"w\"\n", "meshes.toml:8: up is \"w\" (give one of x, y, z)");
  ExpectRefused(kEntry + "scale = 2\n", "scale is no list of two numbers");
  ExpectRefused(kEntry + "scale = [2, 1]\n",
                "scale does not rise from above 0 to at most 10 (write the smaller");
  ExpectRefused(kEntry + "scale = [\"a\", 1]\n", "meshes.toml:8: scale is no number");
  ExpectRefused(kEntry + "turn_deg = nan\n", "turn_deg is no number");
  ExpectRefused(kEntry + "finish = 3\n", "finish is no text (write one between quotes)");
  ExpectRefused(kEntry + "graspable_texture = \"a.png\"\n",
                "a mesh has 2 keys that say what is graspable");
  ExpectRefused("[[mesh]]\nx = [\n", "meshes.toml:");
  ExpectRefused("mesh = 3\n", "meshes.toml:1: \"mesh\" is not a table [[mesh]] (give a table");
  ExpectRefused(kEntry + "[other]\n", "meshes.toml:8: \"other\" is not a table [[mesh]]");
  ExpectRefused("[[mesh]]\nfile = 3\n" + kEntry.substr(kEntry.find("class")),
                "meshes.toml:2: file is no text");
  ExpectRefused("mesh = [3]\n", "meshes.toml:1: a mesh is not a table [[mesh]]");
  ExpectRefused("", "no table [[mesh]] (give a table [[mesh]] for each mesh");
}

TEST_F(ReadMeshCatalogueTest, RefusesNamesThatCannotBeFilesAndPathsThatLeave) {
  std::string text = kEntry;
  text.replace(text.find("\"mug\""), 5, "\"../mug\"");
  ExpectRefused(text, "meshes.toml:3: class is \"../mug\" (use a-z, 0-9 and _, up to 60)");
  text = kEntry;
  text.replace(text.find("\"a.obj\""), 7, "\"../a.obj\"");
  ExpectRefused(text, "meshes.toml:2: \"../a.obj\" leaves the folder");
  text.replace(text.find("\"../a.obj\""), 10, "\"b.obj\"");
  ExpectRefused(text, "b.obj");
}

TEST(ReadMeshCatalogue, RefusesAFolderWithoutMeshesToml) {
  const TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE((void)ReadMeshCatalogue(folder.path()),
                        Error,
                        HasSubstr("holds no meshes.toml, which says what its meshes are"));
  WriteFileAtomically(folder / "a.obj", "");
  EXPECT_THROWS_MESSAGE((void)ReadMeshCatalogue(folder / "a.obj"),
                        Error,
                        HasSubstr("a.obj: is a file; a folder with a meshes.toml is due"));
}

TEST_F(ReadMeshCatalogueTest, DrawsObjectsOfThatShape) {
  const MeshCatalogue catalogue =
      Read(kEntry + "scale = [0.5, 2]\ngraspable_finish = \"rubber\"\n");
  const CatalogueMesh& mesh = catalogue.meshes[0];
  Rng rng = Rng::Stream(1, "objects");
  Rng again = Rng::Stream(1, "objects");
  for (int i = 0; i < 20; ++i) {
    const Object object = DrawCatalogueObject(mesh, rng);
    EXPECT_EQ(object.mesh.vertices, DrawCatalogueObject(mesh, again).mesh.vertices);
    const float size_m = Bounds(object.mesh).sizes().x();
    EXPECT_GE(size_m, 0.05F - 1e-5F);
    EXPECT_LE(size_m, 0.2F + 1e-5F);
    ASSERT_EQ(object.materials.size(), 2U);
    for (const Face& face : object.mesh.faces) {
      EXPECT_EQ(face.surface.material, face.surface.graspable ? 1 : 0);
    }
  }
}

TEST_F(ReadMeshCatalogueTest, DrawsEveryFinish) {
  for (const char* finish : {"glaze", "plastic", "rubber", "metal", "wood"}) {
    const MeshCatalogue catalogue = Read(kEntry + "finish = \"" + finish + "\"\n");
    Rng rng = Rng::Stream(1, "objects");
    const Object object = DrawCatalogueObject(catalogue.meshes[0], rng);
    EXPECT_GT(object.materials[0].base.maxCoeff(), 0.0F) << finish;
    EXPECT_EQ(object.materials[0].pattern == Pattern::kWood, std::string(finish) == "wood");
  }
}

}  // namespace
}  // namespace handcraft::synthetic
