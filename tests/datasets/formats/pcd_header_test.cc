// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/pcd_header.h"

#include <string>
#include <string_view>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kGood =
    "# a comment\nVERSION 0.7\nFIELDS label x _ z y rgba\nSIZE 4 4 2 4 4 4\nTYPE U F U F F U\n"
    "COUNT 1 1 3 1 1 1\nWIDTH 4\nHEIGHT 3\nVIEWPOINT 0.5 0 1 0 1 0 0\nPOINTS 12\nDATA binary\n";

PcdHeader Read(std::string_view text) {
  return ReadPcdHeader("a.pcd", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// The good header with one piece of its text replaced.
std::string With(std::string_view old_text, std::string_view new_text) {
  std::string text(kGood);
  const std::size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return text.replace(at, old_text.size(), new_text);
}

void ExpectRefused(const std::string& text, const std::string& message) {
  EXPECT_THROWS_MESSAGE(Read(text), Error, HasSubstr(message));
}

TEST(ReadPcdHeader, FindsTheCoordinatesAmongOtherFields) {
  const PcdHeader header = Read(kGood);
  EXPECT_EQ(header.coordinates[0].offset_bytes, 4U);
  EXPECT_EQ(header.coordinates[1].offset_bytes, 18U) << "y stands behind z";
  EXPECT_EQ(header.coordinates[2].offset_bytes, 14U);
  EXPECT_EQ(header.coordinates[1].value, 6U);
  EXPECT_EQ(header.point_bytes, 26U);
  EXPECT_EQ(header.point_values, 8U);
  EXPECT_EQ(header.width, 4);
  EXPECT_EQ(header.height, 3);
  EXPECT_EQ(header.data, PcdData::kBinary);
  EXPECT_EQ(header.data_begin, kGood.size());
  EXPECT_EQ(header.data_line, 12U);
  // Quaternion w x y z: half a turn about x.
  EXPECT_TRUE(header.viewpoint.linear().isApprox(
      Eigen::Vector3f(1.0F, -1.0F, -1.0F).asDiagonal().toDenseMatrix()));
  EXPECT_TRUE(header.viewpoint.translation().isApprox(Eigen::Vector3f(0.5F, 0.0F, 1.0F)));
}

TEST(ReadPcdHeader, TakesCarriageReturnsAndDoesWithoutCountAndViewpoint) {
  const PcdHeader header = Read(
      "VERSION .7\r\nFIELDS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\nWIDTH 2\r\nHEIGHT 1\r\n"
      "POINTS 2\r\nDATA ascii\r\n");
  EXPECT_EQ(header.num_points(), 2U);
  EXPECT_TRUE(header.viewpoint.isApprox(Eigen::Isometry3f::Identity()));
}

TEST(ReadPcdHeader, FindsTheIndexOfThePixel) {
  EXPECT_FALSE(Read(kGood).index);
  const PcdHeader header = Read(With("rgba", "index"));
  ASSERT_TRUE(header.index);
  EXPECT_EQ(header.index->offset_bytes, 22U);
  EXPECT_EQ(header.index->value, 7U);
  EXPECT_EQ(header.index->type, 'U');
  EXPECT_EQ(Read(With("label", "index")).index->offset_bytes, 0U);
  EXPECT_FALSE(Read(With("_", "index")).index) << "two bytes, three of them";
  std::string twice = With("rgba", "index");
  EXPECT_THROWS_MESSAGE(Read(twice.replace(twice.find("label"), 5, "index")),
                        Error,
                        HasSubstr("a.pcd:3: field 'index' appears twice"));
}

TEST(ReadPcdHeader, KnowsTheFilesOfCornellByTheirMissingVersion) {
  const std::string fields =
      "FIELDS x y z rgb index\nSIZE 4 4 4 4 4\nTYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH 2\n"
      "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n";
  EXPECT_EQ(Read("# .PCD v.7 - Point Cloud Data file format\n" + fields).unit_m, 0.001F);
  EXPECT_EQ(Read("VERSION 0.7\n" + fields).unit_m, 1.0F);
  std::string other = fields;
  ExpectRefused(other.replace(other.find("rgb"), 3, "hue"), "a PCD header without 'VERSION'");
}

TEST(ReadPcdHeader, RefusesWhatItDoesNotKnow) {
  ExpectRefused("", "a.pcd:1: the PCD header ends before a line DATA");
  ExpectRefused("\x89PNG\r\n\x1a\n", "a.pcd:1: no line of a PCD header");
  ExpectRefused(With("VERSION 0.7", "VERSION 0.6"), "a.pcd:2: PCD version 0.6; 0.7 is due");
  ExpectRefused(With("VERSION 0.7\n", ""), "without 'VERSION'");
  ExpectRefused(With("DATA binary\n", ""), "a.pcd:11: the PCD header ends before a line DATA");
  ExpectRefused(With("DATA binary", "DATA zipped"), "a.pcd:11: DATA 'zipped'; ascii, binary or");
  ExpectRefused(With("WIDTH 4", "WIDTH 4\nWIDTH 4"), "a.pcd:8: 'WIDTH' appears twice");
}

TEST(ReadPcdHeader, RefusesFieldsThatDoNotHoldPoints) {
  ExpectRefused(With("label x", "label w"), "no fields x, y and z");
  ExpectRefused(With("label x", "x x"), "field 'x'");
  ExpectRefused(With("TYPE U F", "TYPE U U"), "field 'x' is not a single float of four bytes");
  ExpectRefused(With("SIZE 4 4", "SIZE 4 8"), "field 'x' is not a single float of four bytes");
  ExpectRefused(With("COUNT 1 1", "COUNT 1 2"), "field 'x' is not a single float of four bytes");
  ExpectRefused(With("SIZE 4 4", "SIZE 4"), "a.pcd:4: SIZE has 5 values; 6 are due");
  ExpectRefused(With("SIZE 4", "SIZE 0"), "SIZE 0; a number from 1 to 8 is due");
  ExpectRefused(With("COUNT 1", "COUNT 65536"), "more than 65536 bytes a point");
}

TEST(ReadPcdHeader, RefusesCountsThatCannotBe) {
  ExpectRefused(With("POINTS 12", "POINTS 13"), "a.pcd:10: POINTS 13; WIDTH times HEIGHT is 12");
  ExpectRefused(With("WIDTH 4", "WIDTH 0"), "a.pcd:10: POINTS 12; WIDTH times HEIGHT is 0");
  ExpectRefused(With("WIDTH 4", "WIDTH -4"), "WIDTH -4; a number from 0 to 268435456 is due");
  ExpectRefused(With("WIDTH 4", "WIDTH 4.0"), "WIDTH 4.0");
  ExpectRefused(With("WIDTH 4", "WIDTH 99999999999999999999"), "WIDTH 99999999999999999999");
  std::string huge = With("WIDTH 4", "WIDTH 268435456");
  huge.replace(huge.find("HEIGHT 3"), 8, "HEIGHT 268435456");
  ExpectRefused(huge, "more than 268435456 points");
}

TEST(ReadPcdHeader, RefusesViewpointsThatAreNoPose) {
  ExpectRefused(With("VIEWPOINT 0.5", "VIEWPOINT nan"), "a.pcd:9: VIEWPOINT with 'nan'");
  ExpectRefused(With("VIEWPOINT 0.5 0", "VIEWPOINT 0.5"), "VIEWPOINT has 6 values; 7 are due");
  ExpectRefused(With("0 1 0 0", "0 2 0 0"), "quaternion that is not of length 1");
  ExpectRefused(With("0 1 0 0", "0 0 0 0"), "quaternion that is not of length 1");
}

TEST(ReadPcdHeader, RefusesTooManyFields) {
  std::string names;
  for (int i = 0; i < 65; ++i) names += " f" + std::to_string(i);
  ExpectRefused("VERSION .7\nFIELDS" + names + "\nDATA ascii\n", "a.pcd:2: 65 fields");
}

}  // namespace
}  // namespace handcraft::datasets
