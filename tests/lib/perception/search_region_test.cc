// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/search_region.h"

#include <algorithm>
#include <set>

#include "lib/core/error.h"
#include "tests/lib/perception/table_scene.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

using testing::Cloud;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kNaN;
using testing::PictureOfBlock;
using testing::Table;
using testing::TableWithBlock;

SearchRegion Find(const Image& image, const Cloud& cloud, const SearchRegionOptions& options = {}) {
  return SearchRegionFinder(options).Find(image, cloud.View());
}

std::vector<std::string> NamesOf(const SearchRegion& region) {
  std::vector<std::string> names;
  names.reserve(region.stages.size());
  for (const SearchStage& stage : region.stages) names.emplace_back(stage.name);
  return names;
}

// The block is 20 × 20: its outline is in the region, its middle and the table are not.
TEST(SearchRegion, IsTheOutlineOfTheBlock) {
  for (const int channels : {1, 3}) {
    const SearchRegion region = Find(PictureOfBlock(channels), TableWithBlock());
    ASSERT_EQ(region.state, SearchState::kFound);
    EXPECT_TRUE(region.HasRegion());
    ASSERT_EQ(region.table.size(), 1U);
    EXPECT_EQ(region.crop.u_px, 26);
    EXPECT_EQ(region.crop.v_px, 16);
    EXPECT_EQ(region.crop.width, 28);
    EXPECT_EQ(region.crop.height, 28);
    EXPECT_EQ(region.mask.At(30, 30), 255);
    EXPECT_EQ(region.mask.At(49, 30), 255);
    EXPECT_EQ(region.mask.At(40, 30), 0) << "inside";
    EXPECT_EQ(region.mask.At(5, 5), 0) << "on the table";
  }
}

TEST(SearchRegion, CountsThePixelsOfEachStage) {
  const SearchRegion region = Find(PictureOfBlock(), TableWithBlock());
  EXPECT_THAT(
      NamesOf(region),
      ElementsAre(
          "picture", "measured", "off the table", "without outliers", "crop", "edges", "region"));
  EXPECT_EQ(region.stages[0].num_pixels, 4800U);
  EXPECT_EQ(region.stages[1].num_pixels, 4800U);
  EXPECT_EQ(region.stages[2].num_pixels, 400U);
  EXPECT_EQ(region.stages[3].num_pixels, 400U);
  EXPECT_EQ(region.stages[4].num_pixels, 784U) << "28 × 28";
  EXPECT_EQ(region.stages[6].num_pixels, PixelsOf(region.mask).size());
  for (const SearchStage& stage : region.stages) EXPECT_GE(stage.time_ms, 0.0) << stage.name;
}

// Every pixel of the region is beside an edge, and every pixel beside an edge is in it: with a
// gradient threshold below one step, the only edge pixels of one bright pixel column are its sides.
TEST(SearchRegion, IsThreeByThreeAroundEdges) {
  const SearchRegion region = Find(PictureOfBlock(), TableWithBlock());
  for (const std::int32_t pixel : PixelsOf(region.mask)) {
    const int u = pixel % 80;
    const int v = pixel / 80;
    const bool is_near_outline = (std::abs(u - 30) <= 2 || std::abs(u - 49) <= 2 ||
                                  std::abs(v - 20) <= 2 || std::abs(v - 39) <= 2);
    EXPECT_TRUE(is_near_outline) << u << ' ' << v;
  }
}

// A printed mark beside the block, within its box: in the box's region, not in the outline's.
TEST(SearchRegion, LeavesOutTheTablesEdgesUnlessTheBoxIsAskedFor) {
  Cloud cloud = TableWithBlock();
  Image image = PictureOfBlock();
  for (int v = 20; v < 30; ++v) {
    for (int u = 30; u < 40; ++u) {  // the block is L-shaped, and the mark lies in its corner
      cloud.At(u, v).z() = 0.7F;
      image.At(u, v) = 40;
    }
  }
  for (int v = 20; v < 24; ++v) {
    for (int u = 30; u < 34; ++u) image.At(u, v) = 250;
  }
  const SearchRegion outline = Find(image, cloud, {.margin_px = 2});
  const SearchRegion box = Find(image, cloud, {.shape = CropShape::kBox, .margin_px = 2});
  EXPECT_EQ(outline.mask.At(33, 22), 0);
  EXPECT_EQ(box.mask.At(33, 22), 255);
  EXPECT_EQ(box.stages[4].num_pixels, 576U) << "24 × 24";
  for (const std::int32_t pixel : PixelsOf(outline.mask)) {
    EXPECT_EQ(box.mask.values()[static_cast<std::size_t>(pixel)], 255);
  }
}

TEST(SearchRegion, IsTheSameFromAFinderThatHasSeenOthers) {
  SearchRegionFinder finder({});
  const Cloud cloud = TableWithBlock();
  const SearchRegion first = finder.Find(PictureOfBlock(), cloud.View());
  EXPECT_EQ(finder.Find(Image(30, 20), Table(30, 20).View()).state, SearchState::kNothingLeft);
  EXPECT_EQ(finder.Find(PictureOfBlock(), cloud.View()).mask.values(), first.mask.values());
}

TEST(SearchRegion, SaysThatTheCloudIsEmpty) {
  const SearchRegion region = Find(Image(), Cloud());
  EXPECT_EQ(region.state, SearchState::kNoPoints);
  EXPECT_FALSE(region.HasRegion());
  EXPECT_THAT(NamesOf(region), ElementsAre("picture", "measured", "off the table"));
}

TEST(SearchRegion, SaysThatAllDepthsAreNaN) {
  Cloud cloud = TableWithBlock();
  for (Eigen::Vector3f& point : cloud.points) point.setConstant(kNaN);
  const SearchRegion region = Find(PictureOfBlock(), cloud);
  EXPECT_EQ(region.state, SearchState::kNoPoints);
  EXPECT_TRUE(PixelsOf(region.mask).empty());
}

TEST(SearchRegion, GoesOnWithoutATable) {
  const SearchRegion region =
      Find(PictureOfBlock(), TableWithBlock(), {.table = {.up = {1.0F, 0.0F, 0.0F}}});
  EXPECT_EQ(region.state, SearchState::kNoTable);
  EXPECT_TRUE(region.HasRegion());
  EXPECT_EQ(region.stages[2].num_pixels, 4800U);
}

TEST(SearchRegion, SaysThatNothingStandsOnTheTable) {
  const SearchRegion region = Find(PictureOfBlock(), Table(80, 60));
  EXPECT_EQ(region.state, SearchState::kNothingLeft);
  EXPECT_EQ(region.crop.width, 0);
}

TEST(SearchRegion, SaysThatThereAreNoEdges) {
  const SearchRegion region = Find(Image(80, 60, 3, 77), TableWithBlock());
  EXPECT_EQ(region.state, SearchState::kNoEdges);
  EXPECT_EQ(region.stages.back().name, "edges");
  EXPECT_EQ(region.stages.back().num_pixels, 0U);
}

TEST(SearchRegion, TakesObjectsAtThePicturesBorder) {
  Cloud cloud = Table(80, 60);
  Image image(80, 60, 1, 40);
  for (int v = 0; v < 20; ++v) {
    for (int u = 0; u < 20; ++u) {
      cloud.At(u, v).z() += 0.05F + 0.005F * static_cast<float>(u);
      image.At(u, v) = 200;
    }
  }
  const SearchRegion region = Find(image, cloud);
  ASSERT_EQ(region.state, SearchState::kFound);
  EXPECT_EQ(region.crop.u_px, 0);
  EXPECT_EQ(region.crop.v_px, 0);
  EXPECT_EQ(region.mask.At(19, 5), 255);
}

TEST(SearchRegion, HasAMessageForEachState) {
  std::set<std::string_view> messages;
  for (const SearchState state : {SearchState::kFound,
                                  SearchState::kNoTable,
                                  SearchState::kNoPoints,
                                  SearchState::kNothingLeft,
                                  SearchState::kNoEdges}) {
    EXPECT_TRUE(messages.insert(MessageOf(state)).second);
    EXPECT_THAT(std::string(MessageOf(state)), ::testing::EndsWith("."));
  }
}

TEST(SearchRegion, RefusesPicturesOfAnotherSize) {
  EXPECT_THROWS_MESSAGE(
      Find(Image(79, 60), TableWithBlock()), std::logic_error, HasSubstr("79, 60, 80, 60"));
}

TEST(SearchRegionOptions, RefusesWhatCannotBe) {
  const auto refuses = [](const SearchRegionOptions& options, const std::string& message) {
    EXPECT_THROWS_MESSAGE(SearchRegionFinder{options}, Error, HasSubstr(message));
  };
  refuses({.table = {.epsilon_m = 0.0F}}, "TableRemovalOptions.epsilon_m is 0");
  refuses({.outliers = {.step = -1.0F}}, "CloudOutlierOptions.step is -1");
  refuses({.margin_px = 101}, "SearchRegionOptions.margin_px is 101; it must be 0 to 100");
  refuses({.canny_low = 200.0F}, "SearchRegionOptions.canny_low is 200");
  refuses({.canny_high = 20000.0F}, "SearchRegionOptions.canny_high is 20000");
}

}  // namespace
}  // namespace handcraft::perception
