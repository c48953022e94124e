// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/stl_mesh.h"

#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

// A binary file of one face with these nine numbers, and what its head begins with.
std::string Binary(const std::vector<float>& numbers, const std::string& head = "") {
  std::string bytes = head + std::string(80 - head.size(), ' ');
  const std::uint32_t count = 1;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  bytes.append(12, '\0');
  bytes.append(reinterpret_cast<const char*>(numbers.data()), 36);
  return bytes + std::string(2, '\0');
}

TEST(ParseStl, ReadsBinaryEvenWhereItSaysSolid) {
  for (const std::string head : {"", "solid of a careless program"}) {
    const SurfaceMesh mesh = ParseStl("a.stl", Binary({0, 0, 0, 1, 0, 0, 0, 2, 0}, head));
    ASSERT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.vertices[2], Eigen::Vector3f(0, 2, 0));
    EXPECT_EQ(mesh.parts.size(), 1U);
  }
}

TEST(ParseStl, ReadsTextWithASolidAPart) {
  const std::string text = "solid the cup\n" + std::string(kFacet) + std::string(kFacet) +
                           "endsolid the cup\nsolid ear\n" + std::string(kFacet) + "endsolid\n";
  const SurfaceMesh mesh = ParseStl("a.stl", text);
  ASSERT_EQ(mesh.triangles.size(), 3U);
  EXPECT_EQ(mesh.parts[mesh.triangles[1].part].object, "the cup");
  EXPECT_EQ(mesh.parts[mesh.triangles[2].part].object, "ear");
  EXPECT_EQ(mesh.triangles[2].vertices, (std::array<std::uint32_t, 3>{6, 7, 8}));
}

TEST(ParseStl, RefusesAnotherLengthThanItsCountSays) {
  std::string bytes = Binary({0, 0, 0, 1, 0, 0, 0, 2, 0});
  EXPECT_THROWS_MESSAGE((void)ParseStl("a.stl", bytes + "x"),
                        Error,
                        HasSubstr("has 135 bytes; 134 are due for 1 faces (get it whole)"));
  EXPECT_THROWS_MESSAGE((void)ParseStl("a.stl", std::string_view(bytes).substr(0, 100)),
                        Error,
                        HasSubstr("has 100 bytes; 134 are due"));
  EXPECT_THROWS_MESSAGE(
      (void)ParseStl("a.stl", ""), Error, HasSubstr("has 0 bytes; 84 are due for its head"));
  std::memset(bytes.data() + 80, 0xff, 4);
  EXPECT_THROWS_MESSAGE((void)ParseStl("a.stl", bytes),
                        Error,
                        HasSubstr("has 134 bytes; 214748364834 are due for 4294967295 faces"));
}

TEST(ParseStl, RefusesAVertexThatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROWS_MESSAGE((void)ParseStl("a.stl", Binary({0, 0, 0, 1, nan, 0, 0, 2, 0})),
                        Error,
                        HasSubstr("byte 108: a vertex of face 0 is not finite"));
}

TEST(ParseStl, RefusesTextThatIsBrokenByLine) {
  const std::string facet(kFacet);
  const auto parse = [](const std::string& text) { (void)ParseStl("a.stl", text); };
  EXPECT_THROWS_MESSAGE(
      parse("solid a\n" + facet), Error, HasSubstr("the file ends here; endsolid is due"));
  EXPECT_THROWS_MESSAGE(parse("solid a\n" + facet.substr(0, 56)),
                        Error,
                        HasSubstr("the file ends here; vertex is due"));
  EXPECT_THROWS_MESSAGE(
      parse("solid a\nfacet\nloop\n"), Error, HasSubstr("a.stl:3: \"outer\" is due here"));
  EXPECT_THROWS_MESSAGE(parse("solid a\nfacet\nouter loop\nvertex 1 2 x\n"),
                        Error,
                        HasSubstr("a.stl:4: \"x\" is no finite number"));
}

}  // namespace
}  // namespace handcraft::datasets
