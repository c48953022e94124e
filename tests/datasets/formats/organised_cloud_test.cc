// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/organised_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using Eigen::Vector3f;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::string Header(std::string_view points, std::string_view data) {
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
         std::string(points) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::string(points) + "\nDATA " + std::string(data) + "\n";
}

template <class T>
std::string Raw(std::initializer_list<T> values) {
  return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(T)};
}

class OrganisedCloudTest : public ::testing::Test {
 protected:
  [[nodiscard]] OrganisedCloud Read(std::string_view text) const {
    WriteFileAtomically(folder_ / "a.pcd", text);
    return ReadPcd(folder_ / "a.pcd");
  }
  void ExpectRefused(const std::string& text, const std::string& message) const {
    EXPECT_THROWS_MESSAGE(Read(text), Error, HasSubstr(message));
  }

  TemporaryDirectory folder_;
};

TEST_F(OrganisedCloudTest, ReadsAsciiByHand) {
  const OrganisedCloud cloud = Read(
      "VERSION 0.7\nFIELDS rgb z y x\nSIZE 4 4 4 4\nTYPE U F F F\nCOUNT 1 1 1 1\nWIDTH 2\n"
      "HEIGHT 2\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 4\nDATA ascii\n"
      "77 3 2 1\r\n77  6 5\t4 \n\n77 nan -nan nan\n77 1e-3 inf 2.5");
  EXPECT_EQ(cloud.width, 2);
  EXPECT_EQ(cloud.height, 2);
  EXPECT_EQ(cloud.At(0, 0), Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(cloud.At(1, 0), Vector3f(4.0F, 5.0F, 6.0F));
  EXPECT_FALSE(IsMeasured(cloud.At(0, 1)));
  EXPECT_TRUE(std::isnan(cloud.At(1, 1).x())) << "one infinite coordinate spoils the point";
  EXPECT_EQ(cloud.base_from_camera.translation(), Vector3f(1.0F, 2.0F, 3.0F));
}

TEST_F(OrganisedCloudTest, ReadsBinaryByHand) {
  const OrganisedCloud cloud = Read(
      "VERSION .7\r\nFIELDS x y z label\r\nSIZE 4 4 4 2\r\nTYPE F F F U\r\nWIDTH 2\r\nHEIGHT 1\r\n"
      "POINTS 2\r\nDATA binary\r\n" +
      Raw<float>({1.0F, 2.0F, 3.0F}) + "\n\r" + Raw<float>({4.0F, kNaN, 6.0F}) + "\r\n");
  EXPECT_EQ(cloud.At(0, 0), Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_FALSE(IsMeasured(cloud.At(1, 0)));
}

TEST_F(OrganisedCloudTest, ReadsCompressedByHand) {
  // All x, all y, all z: 1 1, 2 2, 3 4; the second 1 and 2 as copies from four bytes back.
  const std::string packed = "\x03" + Raw<float>({1.0F}) + "\x40\x03" + "\x03" +
                             Raw<float>({2.0F}) + "\x40\x03" + "\x07" + Raw<float>({3.0F, 4.0F});
  const auto length = static_cast<std::uint32_t>(packed.size());
  const OrganisedCloud cloud =
      Read(Header("2", "binary_compressed") + Raw<std::uint32_t>({length, 24}) + packed);
  EXPECT_EQ(cloud.At(0, 0), Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(cloud.At(1, 0), Vector3f(1.0F, 2.0F, 4.0F));
}

TEST_F(OrganisedCloudTest, ReadsBackWhatItWrote) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    Rng rng = Rng::Stream(1, "clouds", i);
    OrganisedCloud cloud{.width = 1 + static_cast<int>(rng.UniformInt(9)),
                         .height = 1 + static_cast<int>(rng.UniformInt(9))};
    const auto draw = [&] { return static_cast<float>(rng.Normal()); };
    for (int j = 0; j < cloud.width * cloud.height; ++j) {
      cloud.points.emplace_back(draw(), draw(), draw());
      if (j % 3 == 2) cloud.points.back().setConstant(kNaN);
    }
    const Eigen::Quaternionf rotation(draw(), draw(), draw(), draw());
    cloud.base_from_camera =
        Eigen::Translation3f(draw(), draw(), draw()) * Eigen::Isometry3f(rotation.normalized());
    WritePcd(folder_ / "a.pcd", cloud);
    const OrganisedCloud read = ReadPcd(folder_ / "a.pcd");
    ASSERT_EQ(read.width, cloud.width);
    ASSERT_EQ(read.points.size(), cloud.points.size());
    EXPECT_EQ(std::memcmp(
                  read.points.data(), cloud.points.data(), cloud.points.size() * sizeof(Vector3f)),
              0);
    EXPECT_TRUE(read.base_from_camera.isApprox(cloud.base_from_camera, 1e-6F));
  }
}

TEST_F(OrganisedCloudTest, WritesTheHeaderThatIsSpecified) {
  const OrganisedCloud cloud{.width = 1, .height = 1, .points = {Vector3f(1.0F, 2.0F, 3.0F)}};
  WritePcd(folder_ / "a.pcd", cloud);
  EXPECT_EQ(ReadTextFile(folder_ / "a.pcd"),
            "# .PCD v0.7 - Point Cloud Data file format\n" + Header("1", "binary") +
                Raw<float>({1.0F, 2.0F, 3.0F}));
}

TEST_F(OrganisedCloudTest, RefusesDamagedAscii) {
  const std::string header = Header("2", "ascii");
  ExpectRefused(header + "1 2 3\n", "a.pcd:12: the file ends after 1 of 2 points");
  ExpectRefused(header + "1 2 3\n4 5 6\n7 8 9\n", "a.pcd:13: more than the 2 points of the header");
  ExpectRefused(header + "1 2 3\n4 5\n", "a.pcd:12: 2 values; 3 are due");
  ExpectRefused(header + "1 2 3\n4 5 6 7\n", "a.pcd:12: 4 values; 3 are due");
  ExpectRefused(header + "1 2 3\n4 5 six\n", "a.pcd:12: 'six' where a coordinate is due");
  ExpectRefused(header + "1 2 3\n4 5 1e999\n", "'1e999' where a coordinate is due");
  ExpectRefused(header + "1,2,3\n", "'1,2,3' where a coordinate is due");
}

TEST_F(OrganisedCloudTest, RefusesDamagedBinary) {
  const std::string header = Header("2", "binary");
  const std::string points = Raw<float>({1, 2, 3, 4, 5, 6});
  EXPECT_EQ(Read(header + points).At(1, 0), Vector3f(4.0F, 5.0F, 6.0F));
  for (const std::size_t size : {0U, 1U, 12U, 23U}) {
    ExpectRefused(header + points.substr(0, size), "2 points of 12 bytes are due");
  }
  EXPECT_EQ(Read(header + points + std::string(65536, 'x')).At(1, 0), Vector3f(4.0F, 5.0F, 6.0F))
      << "a page behind the data";
  ExpectRefused(header + points + std::string(65537, 'x'), "65561 bytes of data; 2 points of 12");

  ExpectRefused(Header("268435456", "binary") + points, "268435456 points of 12 bytes are due");
  ExpectRefused(Header("268435456", "ascii") + "1 2 3\n", "after 1 of 268435456 points");
}

TEST_F(OrganisedCloudTest, RefusesDamagedCompression) {
  const std::string header = Header("1", "binary_compressed");
  const std::string packed = "\x0b" + Raw<float>({1, 2, 3});
  EXPECT_EQ(Read(header + Raw<std::uint32_t>({13, 12}) + packed).At(0, 0), Vector3f(1, 2, 3));
  ExpectRefused(header + "1234567", "the file ends before the two lengths");
  ExpectRefused(header + Raw<std::uint32_t>({13, 24}) + packed, "24 bytes unpacked; 12 are due");
  ExpectRefused(header + Raw<std::uint32_t>({14, 12}) + packed, "14 packed bytes announced; 13");
  ExpectRefused(header + Raw<std::uint32_t>({13, 12}) + packed.substr(1), "12 are there");
  ExpectRefused(header + Raw<std::uint32_t>({13, 12}) + packed + std::string(65537, 'x'),
                "13 packed bytes announced; 65550 are there");

  ExpectRefused(header + Raw<std::uint32_t>({13, 12}) + "\x0c" + packed.substr(1),
                "a damaged LZF stream");
  ExpectRefused(
      Header("200000000", "binary_compressed") + Raw<std::uint32_t>({13, 2400000000U}) + packed,
      "a damaged LZF stream");
}

std::string IndexedHeader(std::string_view points, std::string_view data, std::string_view type) {
  return "VERSION 0.7\nFIELDS index x y z\nSIZE 4 4 4 4\nTYPE " + std::string(type) +
         " F F F\nWIDTH " + std::string(points) + "\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS " +
         std::string(points) + "\nDATA " + std::string(data) + "\n";
}

class CloudOfPictureTest : public OrganisedCloudTest {
 protected:
  // Of a picture of 3 × 2.
  [[nodiscard]] OrganisedCloud Read(std::string_view text,
                                    std::optional<float> unit_m = std::nullopt) const {
    WriteFileAtomically(folder_ / "a.pcd", text);
    return ReadCloudOfPicture(folder_ / "a.pcd", {3, 2}, unit_m);
  }
  void ExpectRefused(const std::string& text, const std::string& message) const {
    EXPECT_THROWS_MESSAGE(Read(text), Error, HasSubstr(message));
  }
  // (1, 2, 3) at pixel (2, 1), nothing at (0, 0), nowhere else anything.
  static void ExpectPointAtItsPixel(const OrganisedCloud& cloud, const std::string& which) {
    ASSERT_EQ(cloud.width, 3) << which;
    ASSERT_EQ(cloud.height, 2) << which;
    ASSERT_EQ(cloud.points.size(), 6U) << which;
    EXPECT_EQ(cloud.At(2, 1), Vector3f(1.0F, 2.0F, 3.0F)) << which;
    for (std::size_t i = 0; i < 5; ++i) EXPECT_FALSE(IsMeasured(cloud.points[i])) << which;
    EXPECT_EQ(cloud.base_from_camera.translation(), Vector3f(1.0F, 2.0F, 3.0F)) << which;
  }
};

TEST_F(CloudOfPictureTest, PutsPointsWhereTheirIndicesSay) {
  for (const char* type : {"U", "I", "F"}) {
    ExpectPointAtItsPixel(Read(IndexedHeader("2", "ascii", type) + "5 1 2 3\n0 nan 1 1\n"),
                          std::string("ascii ") + type);
  }
  const std::string whole = Raw<std::uint32_t>({5}) + Raw<float>({1, 2, 3}) +
                            Raw<std::uint32_t>({0}) + Raw<float>({1, kNaN, 1});
  ExpectPointAtItsPixel(Read(IndexedHeader("2", "binary", "U") + whole), "binary U");
  ExpectPointAtItsPixel(Read(IndexedHeader("2", "binary", "I") + whole), "binary I");
  ExpectPointAtItsPixel(
      Read(IndexedHeader("2", "binary", "F") + Raw<float>({5, 1, 2, 3, 0, 1, kNaN, 1})),
      "binary F");
  // Field by field, in one run of 32 bytes.
  const std::string columns = Raw<std::uint32_t>({5, 0}) + Raw<float>({1, 1, 2, kNaN, 3, 1});
  ExpectPointAtItsPixel(Read(IndexedHeader("2", "binary_compressed", "U") +
                             Raw<std::uint32_t>({33, 32}) + "\x1f" + columns),
                        "compressed");
}

TEST_F(CloudOfPictureTest, TakesTheUnitOfTheFileOrTheGivenOne) {
  const std::string cornell =
      "# .PCD v.7 - Point Cloud Data file format\nFIELDS x y z rgb index\nSIZE 4 4 4 4 4\n"
      "TYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n"
      "DATA ascii\n1924.064 -647.111 -119.4176 0 5\r\n1.5 2 3 2.3e-38 1\nnan nan nan 0 2\n";
  const OrganisedCloud cloud = Read(cornell);
  EXPECT_TRUE(cloud.At(2, 1).isApprox(Vector3f(1.924064F, -0.647111F, -0.1194176F), 1e-6F));
  EXPECT_TRUE(cloud.At(1, 0).isApprox(Vector3f(0.0015F, 0.002F, 0.003F), 1e-6F));
  EXPECT_FALSE(IsMeasured(cloud.At(2, 0))) << "NaN";
  EXPECT_FALSE(IsMeasured(cloud.At(0, 0))) << "no line";
  EXPECT_EQ(Read(cornell, 1.0F).At(1, 0), Vector3f(1.5F, 2.0F, 3.0F));
  const std::string ours = IndexedHeader("1", "ascii", "U") + "5 1 2 3\n";
  EXPECT_EQ(Read(ours, 0.5F).At(2, 1), Vector3f(0.5F, 1.0F, 1.5F));
}

// HEIGHT above 1 and a field `index`: it says where a point belongs, not the order.
TEST_F(CloudOfPictureTest, BelievesTheIndicesOfAnOrganisedCloud) {
  const std::string header =
      "VERSION 0.7\nFIELDS index x y z\nSIZE 4 4 4 4\nTYPE U F F F\nWIDTH 3\nHEIGHT 2\n"
      "VIEWPOINT 1 2 3 1 0 0 0\nPOINTS 6\nDATA ascii\n5 1 2 3\n";
  const std::string nothing = " nan nan nan\n";
  ExpectPointAtItsPixel(
      Read(header + "0" + nothing + "1" + nothing + "2" + nothing + "3" + nothing + "4" + nothing),
      "in another order");
  ExpectRefused(
      header + "0" + nothing + "1" + nothing + "2" + nothing + "3" + nothing + "5" + nothing,
      "point 6 of 6: index 5 is there twice");
}

TEST_F(CloudOfPictureTest, TakesAnOrganisedCloudAsItIs) {
  const OrganisedCloud cloud{.width = 3, .height = 2, .points = {6, Vector3f(1, 2, 3)}};
  WritePcd(folder_ / "a.pcd", cloud);
  EXPECT_EQ(ReadCloudOfPicture(folder_ / "a.pcd", {3, 2}).points, cloud.points);
  EXPECT_THROWS_MESSAGE(ReadCloudOfPicture(folder_ / "a.pcd", {2, 3}),
                        Error,
                        HasSubstr("a.pcd: the cloud is 3x2 pixels, its picture 2x3"));
  const std::string row = Header("2", "ascii") + "1 2 3\n4 5 6\n";
  WriteFileAtomically(folder_ / "row.pcd", row);
  EXPECT_EQ(ReadCloudOfPicture(folder_ / "row.pcd", {2, 1}).At(1, 0), Vector3f(4, 5, 6))
      << "a picture of one row";
  ExpectRefused(row, "an unorganised cloud (HEIGHT 1) without a field 'index' of four bytes");
  ExpectRefused(row, "organised, 3 × 2 pixels, or with an index, row · width + column");
}

TEST_F(CloudOfPictureTest, TakesACloudWithoutPoints) {
  for (const char* data : {"ascii", "binary"}) {
    for (const std::string& text : {Header("0", data), IndexedHeader("0", data, "U")}) {
      const OrganisedCloud cloud = Read(text);
      EXPECT_EQ(cloud.points.size(), 6U);
      for (const Vector3f& point : cloud.points) EXPECT_FALSE(IsMeasured(point)) << text;
    }
  }
  ExpectRefused(Header("0", "ascii") + "1 2 3\n", "more than the 0 points of the header");
  EXPECT_THROWS_MESSAGE(ReadPcd(folder_ / "a.pcd"), Error, HasSubstr("a.pcd: no points"));
}

TEST_F(CloudOfPictureTest, NamesThePointAndTheIndexThatIsNoPixel) {
  const std::string header = IndexedHeader("2", "ascii", "F");
  ExpectRefused(header + "0 1 2 3\n6 1 2 3\n", "point 2 of 2: index 6 is outside the picture of 3");
  ExpectRefused(header + "-1 1 2 3\n0 1 2 3\n", "point 1 of 2: index -1 is outside the picture");
  ExpectRefused(header + "nan 1 2 3\n0 1 2 3\n", "point 1 of 2: index nan is outside");
  ExpectRefused(header + "1.5 1 2 3\n0 1 2 3\n", "point 1 of 2: index 1.5 is no whole number");
  ExpectRefused(header + "4 1 2 3\n4 1 2 3\n", "point 2 of 2: index 4 is there twice");
  ExpectRefused(header + "4 nan 2 3\n4 1 2 3\n", "index 4 is there twice");
  ExpectRefused(header + "four 1 2 3\n4 1 2 3\n", "a.pcd:10: 'four' where an index is due");
  ExpectRefused(IndexedHeader("1", "binary", "I") + Raw<std::int32_t>({-7}) + Raw<float>({1, 2, 3}),
                "point 1 of 1: index -7 is outside the picture of 3 × 2 pixels");
  ExpectRefused(IndexedHeader("268435456", "binary", "U"), "268435456 points of 16 bytes are due");
}

TEST_F(OrganisedCloudTest, RefusesAMissingFile) {
  EXPECT_THROWS_MESSAGE(ReadPcd(folder_ / "no.pcd"), Error, HasSubstr("No such file"));
}

// A camera of 525 px saw the scene, mirrored: each point lies on the ray of its pixel.
TEST(ReadPcd, ReadsWhatThePointCloudLibraryWrote) {
  const std::filesystem::path path =
      std::filesystem::path(HANDCRAFT_SOURCE_DIR) /
      "../shared/data/pointclouds_pcl/tutorials/correspondence_grouping/"
      "milk_cartoon_all_small_clorox.pcd";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const OrganisedCloud cloud = ReadPcd(path);
  ASSERT_EQ(cloud.width, 640);
  ASSERT_EQ(cloud.height, 480);
  int num_measured = 0;
  float farthest_off_px = 0.0F;
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      const Vector3f& point = cloud.At(u, v);
      if (!IsMeasured(point)) continue;
      ++num_measured;
      const Vector3f seen = 525.0F / point.z() * point;
      farthest_off_px = std::max({farthest_off_px,
                                  std::abs(seen.x() + static_cast<float>(u) - 319.5F),
                                  std::abs(seen.y() - static_cast<float>(v) + 239.5F)});
    }
  }
  EXPECT_LT(farthest_off_px, 0.01F);
  EXPECT_GT(num_measured, 100000);
}

}  // namespace
}  // namespace handcraft::datasets
