// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/search_input.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "lib/perception/image_io.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/small_camera_file.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

class SearchInputTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string Path(const char* name) const { return (folder_ / name).string(); }

  TemporaryDirectory folder_;
};

Image Noise(int width, int height, std::uint64_t seed) {
  Rng rng = Rng::Stream(seed, "search_input");
  Image image(width, height, 3);
  for (int v = 0; v < height; ++v) {
    for (int i = 0; i < 3 * width; ++i)
      image.Row(v)[i] = static_cast<std::uint8_t>(rng.UniformInt(256));
  }
  return image;
}

TEST_F(SearchInputTest, ReadsACloudOfThePicturesSize) {
  datasets::OrganisedCloud cloud{.width = 3, .height = 2};
  for (int i = 0; i < 6; ++i) cloud.points.emplace_back(static_cast<float>(i), 0.0F, 1.0F);
  datasets::WritePcd(Path("c.pcd"), cloud);
  const SearchInput input{.cloud = Path("c.pcd")};
  EXPECT_EQ(CloudFor(input, Image(3, 2)).points, cloud.points);
  EXPECT_THROWS_MESSAGE(CloudFor(input, Image(2, 3)),
                        Error,
                        HasSubstr("c.pcd: the cloud is 3x2 pixels, its picture 2x3"));
  EXPECT_EQ(RegionOptions(input).table.up, Eigen::Vector3f(0, 0, 1));
}

// What a file holds decides, not its name.
TEST_F(SearchInputTest, ReadsIndexedCloudsWhateverTheirName) {
  const std::string fields =
      "FIELDS x y z rgb index\nSIZE 4 4 4 4 4\nTYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH 1\n"
      "HEIGHT 1\nPOINTS 1\nDATA ascii\n1000 2000 3000 0 4\n";
  const auto depth_m = [&](const char* name, std::optional<float> unit_m) {
    const auto cloud = CloudFor({.cloud = Path(name), .cloud_unit_m = unit_m}, Image(3, 2));
    EXPECT_FALSE(datasets::IsMeasured(cloud.points[0])) << name;
    return cloud.points[4].z();
  };
  for (const char* name : {"c.txt", "c.pcd"}) {
    WriteFileAtomically(Path(name), "# .PCD v.7 - Point Cloud Data file format\n" + fields);
    EXPECT_FLOAT_EQ(depth_m(name, std::nullopt), 3.0F) << name << ": of the Cornell data";
    WriteFileAtomically(Path(name), "VERSION 0.7\n" + fields);
    EXPECT_FLOAT_EQ(depth_m(name, std::nullopt), 3000.0F) << name;
    EXPECT_FLOAT_EQ(depth_m(name, 0.01F), 30.0F) << name;
  }
}

TEST_F(SearchInputTest, FormsACloudOfADepthPicture) {
  BasicImage<std::uint16_t> depth(160, 120, 1, 1500);
  depth.At(7, 8) = 0;
  perception::WritePng16(folder_ / "d.png", depth);
  SearchInput input{.depth = Path("d.png"), .camera = testing::CameraFile(folder_.path())};
  std::optional<perception::SearchStage> matching;
  const auto cloud = CloudFor(input, Image(160, 120), &matching);
  EXPECT_FALSE(matching);
  EXPECT_NEAR(cloud.At(0, 0).x(), -79.5F / 131.25F * 1.5F, 1e-6F);
  EXPECT_NEAR(cloud.At(0, 0).z(), 1.5F, 1e-6F);
  EXPECT_FALSE(datasets::IsMeasured(cloud.At(7, 8)));
  EXPECT_EQ(RegionOptions(input).table.up, Eigen::Vector3f(0, -1, 0));
  EXPECT_THROWS_MESSAGE(CloudFor(input, Image(161, 120)), Error, HasSubstr("camera.toml"));
  perception::WritePng16(folder_ / "d.png", BasicImage<std::uint16_t>(5, 5, 1, 1));
  EXPECT_THROWS_MESSAGE(CloudFor(input, Image(160, 120)), Error, HasSubstr("d.png: 5 × 5"));
}

TEST_F(SearchInputTest, MatchesAPair) {
  const Image left = Noise(160, 120, 1);
  Image right = Noise(160, 120, 2);
  for (int v = 0; v < 120; ++v) std::copy_n(left.Row(v) + 3 * 11, 3 * 149, right.Row(v));
  perception::WritePng(folder_ / "r.png", right);
  const SearchInput input{.right = Path("r.png"),
                          .camera = testing::CameraFile(folder_.path(), "baseline_m = 0.12\n")};
  std::optional<perception::SearchStage> matching;
  const auto cloud = CloudFor(input, left, &matching);
  ASSERT_TRUE(matching);
  EXPECT_EQ(matching->name, "matched");
  EXPECT_EQ(matching->num_pixels,
            static_cast<std::size_t>(
                std::count_if(cloud.points.begin(), cloud.points.end(), datasets::IsMeasured)));
  EXPECT_GT(matching->num_pixels, 0U);
  EXPECT_GT(matching->time_ms, 0.0);
  EXPECT_NEAR(cloud.At(100, 60).z(), 131.25F * 0.12F / 11.0F, 0.02F);
  SearchInput block = input;
  block.stereo_method = SearchInput::kBlock;
  const auto by_blocks = CloudFor(block, left);
  EXPECT_NEAR(by_blocks.At(100, 60).z(), 131.25F * 0.12F / 11.0F, 0.02F);
  EXPECT_NE(std::memcmp(by_blocks.points.data(),
                        cloud.points.data(),
                        cloud.points.size() * sizeof(Eigen::Vector3f)),
            0)
      << "block matching leaves other pixels open";
  EXPECT_THROWS_MESSAGE(
      CloudFor({.right = Path("r.png"), .camera = testing::CameraFile(folder_.path())}, left),
      Error,
      HasSubstr("no baseline_m in [camera]"));
}

TEST_F(SearchInputTest, RefusesARightPictureOfAnotherSize) {
  perception::WritePng(folder_ / "r.png", Noise(150, 120, 2));
  const SearchInput input{.right = Path("r.png"),
                          .camera = testing::CameraFile(folder_.path(), "baseline_m = 0.12\n")};
  EXPECT_THROWS_MESSAGE(
      CloudFor(input, Noise(160, 120, 1)), Error, HasSubstr("r.png: 150 × 120 pixels"));
}

TEST(RequireSearchFits, RefusesWhatDoesNotGoTogether) {
  const auto refuses = [](const SearchInput& input, std::size_t num_inputs, const char* message) {
    EXPECT_THROWS_MESSAGE(RequireSearchFits(input, num_inputs), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(RequireSearchFits({}, 5));
  EXPECT_NO_THROW(RequireSearchFits({.cloud = "c"}, 1));
  EXPECT_NO_THROW(RequireSearchFits({.depth = "d", .camera = "c"}, 1));
  refuses({.cloud = "c", .depth = "d"}, 1, "exclude each other");
  refuses({.cloud = "c"}, 2, "give one INPUT");
  refuses({.depth = "d"}, 1, "--depth and --right need --camera");
  refuses({.cloud = "c", .camera = "t"}, 1, "--camera is read by --depth and --right alone");
  EXPECT_NO_THROW(
      RequireSearchFits({.right = "r", .camera = "t", .stereo_method = SearchInput::kBlock}, 1));
  refuses({.depth = "d", .camera = "c", .cloud_unit_m = 1.0F}, 1, "--cloud-unit needs --cloud");
  refuses({.cloud = "c", .stereo_method = SearchInput::kBlock}, 1, "--stereo-method needs --right");
  refuses({.up = {0, 0, 1}}, 1, "--up needs --cloud, --depth or --right");
  refuses({.up_angle_deg = 5.0}, 1, "--up-angle needs --cloud, --depth or --right");
  refuses({.table_distance_m = 0.02}, 1, "--table-distance needs --cloud, --depth or --right");
  refuses({.cloud = "c", .up = {0, 0, 0}}, 1, "--up is 0 0 0; it must be of a finite length");
  refuses({.cloud = "c", .up = {0, NAN, 1}}, 1, "--up is 0 nan 1");
}

TEST(RegionOptions, TakesTheOptionsGiven) {
  const auto options = RegionOptions(
      {.cloud = "c", .up = {1, 2, 3}, .up_angle_deg = 90.0, .table_distance_m = 0.02});
  EXPECT_EQ(options.table.up, Eigen::Vector3f(1, 2, 3));
  EXPECT_NEAR(options.table.max_angle_rad, std::acos(0.0F), 1e-6F);
  EXPECT_EQ(options.table.epsilon_m, 0.02F);
  EXPECT_NO_THROW(options.Validate());
}

TEST(SearchTable, ListsTheStages) {
  perception::SearchRegion region;
  region.stages = {{"picture", 307200, 0.0}, {"region", 12429, 1.256}};
  EXPECT_EQ(SearchTable(region),
            "stage    pixels  time [ms]\n"
            "picture  307200       0.00\n"
            "region    12429       1.26\n"
            "all           -       1.26\n");
}

TEST(SearchJson, TellsStatePlanesAndStages) {
  perception::SearchRegion region;
  region.state = perception::SearchState::kFound;
  region.table = {{Eigen::Vector3f(0, 0, 1), 0.7F}};
  region.stages = {{"picture", 307200, 0.5}};
  region.crop = {1, 2, 3, 4};
  EXPECT_EQ(SearchJson(region).dump(),
            R"({"found":true,"message":"The region was found.","crop":{"u_px":1,"v_px":2,)"
            R"("width_px":3,"height_px":4},"table":[{"normal":[0.0,0.0,1.0],"offset_m":0.7}],)"
            R"("stages":[{"name":"picture","num_pixels":307200,"time_ms":0.5}]})");
}

}  // namespace
}  // namespace handcraft::tools
