// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/ply_mesh.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

const std::string kTextHead =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty uchar red\nproperty double z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n";
const std::string kTextVertices = "0 0 255 0\n1 0 255 0\n1 1 255 0\n0 1 255 0.5\n";

SurfaceMesh Parse(const std::string& text) { return ParsePly("a.ply", text); }

TEST(ParsePly, ReadsText) {
  const SurfaceMesh mesh = Parse(kTextHead + kTextVertices + "4 0 1 2 3\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.num_faces, 1U);
  EXPECT_EQ(mesh.vertices[3], Eigen::Vector3f(0.0F, 1.0F, 0.5F));
  EXPECT_EQ(mesh.triangles[1].vertices, (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.triangles[1].texture[0], SurfaceMesh::kNone);
}

template <class T>
void Put(std::string& bytes, T value, bool is_big) {
  std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
  if (is_big) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

// Three vertices with texture coordinates, another element in between, one face.
std::string Binary(bool is_big, std::int32_t last_index = 2, float last_z = 0.25F) {
  std::string bytes = std::string("ply\r\nformat binary_") + (is_big ? "big" : "little") +
                      "_endian 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
                      "property float z\r\nproperty float s\r\nproperty float t\r\n"
                      "element edge 2\r\nproperty short a\r\nproperty list uchar double b\r\n"
                      "element face 1\r\nproperty uchar flags\r\n"
                      "property list uint8 int32 vertex_index\r\nend_header\r\n";
  for (const float value : {0.F, 0.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F}) {
    Put(bytes, value, is_big);
  }
  for (const float value : {last_z, 0.5F, 1.0F}) Put(bytes, value, is_big);
  for (const std::uint8_t length : {std::uint8_t{2}, std::uint8_t{0}}) {
    Put(bytes, std::int16_t{-3}, is_big);
    Put(bytes, length, is_big);
    for (int i = 0; i < length; ++i) Put(bytes, 1.5, is_big);
  }
  Put(bytes, std::uint8_t{7}, is_big);
  Put(bytes, std::uint8_t{3}, is_big);
  for (const std::int32_t index : {0, 1, last_index}) Put(bytes, index, is_big);
  return bytes;
}

TEST(ParsePly, ReadsBothOrdersOfBytesAlike) {
  for (const bool is_big : {false, true}) {
    const SurfaceMesh mesh = Parse(Binary(is_big));
    ASSERT_EQ(mesh.triangles.size(), 1U) << is_big;
    EXPECT_EQ(mesh.vertices[2], Eigen::Vector3f(0.0F, 1.0F, 0.25F)) << is_big;
    EXPECT_EQ(mesh.texture_coordinates[2], Eigen::Vector2f(0.5F, 1.0F)) << is_big;
    EXPECT_EQ(mesh.triangles[0].texture, (std::array<std::uint32_t, 3>{0, 1, 2})) << is_big;
  }
}

TEST(ParsePly, RefusesIndicesThatCannotBe) {
  EXPECT_THROWS_MESSAGE(
      (void)Parse(Binary(false, 3)), Error, HasSubstr("face 0 names vertex 3; there are 3"));
  EXPECT_THROWS_MESSAGE(
      (void)Parse(Binary(true, -1)), Error, HasSubstr("face 0 names a vertex that cannot be"));
  EXPECT_THROWS_MESSAGE((void)Parse(kTextHead + kTextVertices + "3 0 1 1.5\n"),
                        Error,
                        HasSubstr("a.ply:16: face 0 names a vertex that cannot be"));
  EXPECT_THROWS_MESSAGE((void)Parse(kTextHead + kTextVertices + "2 0 1\n"),
                        Error,
                        HasSubstr("face 0 has 2 corners; three or more are due"));
}

TEST(ParsePly, RefusesWhatIsNotFinite) {
  EXPECT_THROWS_MESSAGE((void)Parse(Binary(false, 2, std::numeric_limits<float>::infinity())),
                        Error,
                        HasSubstr("vertex 2 is not finite"));
}

TEST(ParsePly, RefusesEveryTruncation) {
  for (const std::string& whole : {Binary(false), kTextHead + kTextVertices + "4 0 1 2 3\n"}) {
    for (std::size_t size = 0; size + 3 < whole.size(); ++size) {
      EXPECT_THROW((void)Parse(whole.substr(0, size)), Error) << size;
    }
  }
}

TEST(ParsePly, DoesNotBelieveHugeCounts) {
  std::string text = Binary(false);
  text.replace(text.find("vertex 3"), 8, "vertex 4000000000");
  EXPECT_THROWS_MESSAGE((void)Parse(text), Error, HasSubstr("the file ends before its last"));
  text.replace(text.find("4000000000"), 10, "99999999999");
  EXPECT_THROWS_MESSAGE((void)Parse(text), Error, HasSubstr("is no whole number from 0 to"));
}

TEST(ParsePly, RefusesAHeadThatIsNone) {
  const auto message = [](const std::string& head, const std::string& expected) {
    EXPECT_THROWS_MESSAGE((void)Parse(head), Error, HasSubstr(expected));
  };
  message("", "a.ply:1: a PLY file begins with \"ply\"");
  message("ply\nformat ascii 2.0\n", "a.ply:2: the format is \"ascii 2.0\"; ascii, binary_little");
  message("ply\nelement vertex 3\nproperty real x\n", "names no type of number");
  message("ply\nelement vertex 3\nproperty list float int x\n", "a list is a whole number");
  message("ply\nproperty float x\n", "no line of a PLY file's head");
  message("ply\nelement vertex 3\n", "the file ends within its head");
  message("ply\nelement vertex 3\nend_header\n", "element vertex has no property");
  message("ply\nelement vertex 1\nproperty float x\nend_header\n1\n", "a vertex has no x, y and z");
  message("ply\nelement face 1\nproperty float x\nend_header\n1\n", "no list vertex_indices");
}

}  // namespace
}  // namespace handcraft::datasets
