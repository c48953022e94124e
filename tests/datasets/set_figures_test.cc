// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/set_figures.h"

#include <limits>
#include <string>

#include "lib/core/error.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using testing::AddPicture;
using testing::CountedMask;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::NoiseImage;
using ::testing::Pair;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

TEST(CountFigures, CountsLabels) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  AddPicture(set, "a", NoiseImage(8, 6, 3, 1), CountedMask(8, 6, 5, 2));
  AddPicture(set, "b", NoiseImage(4, 4, 1, 2), CountedMask(4, 4, 1, 3));
  AddPicture(set, "c", NoiseImage(4, 4, 3, 3), CountedMask(4, 4, 2, 2), "test");
  set.items[1].instance = "a";
  set.items[1].object_class = "mug";
  const SetFigures<LabelFigures> figures = CountFigures(set, 2);
  EXPECT_THAT(figures.sizes, ElementsAre(Pair("4x4", 2U), Pair("8x6", 1U)));
  EXPECT_THAT(figures.licences, ElementsAre("CC0-1.0"));
  const SplitFigures<LabelFigures>& train = figures.splits.at("train");
  EXPECT_EQ(train.all.images, 2U);
  EXPECT_THAT(train.all.instances, SizeIs(1));
  EXPECT_EQ(train.all.pixels, 48U + 16U);
  EXPECT_EQ(train.all.good, 6U);
  EXPECT_EQ(train.all.bad, 5U);
  EXPECT_EQ(train.by_class.at("mug").good, 1U);
  EXPECT_EQ(figures.splits.at("test").by_class.at("object").bad, 2U);
}

TEST(CountFigures, CountsObjectsAndWhatWasMeasured) {
  const TemporaryDirectory folder;
  const ViewSet set = testing::MakeViewSet(folder.path());  // the left half is the object
  OrganisedCloud cloud = testing::FlatCloud(8, 6);
  for (const std::size_t point : {0U, 1U, 7U}) {  // two of them on the object
    cloud.points[point].setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  WritePcd(folder / "a.pcd", cloud);
  for (const int num_threads : {1, 3}) {
    const SetFigures<ViewFigures> figures = CountFigures(set, num_threads);
    EXPECT_THAT(figures.sizes, ElementsAre(Pair("8x6", 3U)));
    const ViewFigures& mug = figures.splits.at("train").by_class.at("mug");
    EXPECT_EQ(mug.views, 2U);
    EXPECT_THAT(mug.instances, ElementsAre("mug_0"));
    EXPECT_THAT(mug.angles_deg, ElementsAre(22.5));
    EXPECT_EQ(mug.views_without_angle, 1U);
    EXPECT_EQ(mug.pixels, 96U);
    EXPECT_EQ(mug.object_pixels, 48U);
    EXPECT_EQ(mug.clouds, 1U);
    EXPECT_EQ(mug.cloud_object_pixels, 24U) << "of the view that has a cloud";
    EXPECT_EQ(mug.measured, 22U);
    EXPECT_EQ(figures.splits.at("test").all.measured, 24U);
  }
}

TEST(CountFigures, RefusesACloudOfAnotherSize) {
  const TemporaryDirectory folder;
  const ViewSet set = testing::MakeViewSet(folder.path());
  WritePcd(folder / "c.pcd", testing::FlatCloud(6, 8));
  EXPECT_THROWS_MESSAGE(
      CountFigures(set, 2), Error, HasSubstr("c.pcd: the cloud is 6x8 pixels, its picture 8x6"));
}

TEST(CountPoses, CountsRowsOfEachView) {
  DemonstrationSet set;
  for (const char* view : {"a", "b", "a", "a"}) {
    set.items.push_back({"mug", std::string("mug_") + view, view, {}, {}});
  }
  set.items.push_back({"can", "can_0", "c", {}, {}});
  const auto by_class = CountPoses(set);
  ASSERT_THAT(by_class, SizeIs(2));
  const PoseFigures& mug = by_class.at("mug");
  EXPECT_EQ(mug.poses, 4U);
  EXPECT_EQ(mug.views, 2U);
  EXPECT_THAT(mug.instances, ElementsAre("mug_a", "mug_b"));
  EXPECT_EQ(mug.least_per_view, 1U);
  EXPECT_EQ(mug.most_per_view, 3U);
  PoseFigures all;
  for (const auto& [object_class, figures] : by_class) all += figures;
  EXPECT_EQ(all.poses, 5U);
  EXPECT_EQ(all.views, 3U);
  EXPECT_EQ(all.least_per_view, 1U);
}

TEST(CountPoses, CountsHolds) {
  HoldSet set;
  set.items = {{"can", "can_0", "c", {}, {}}, {"can", "can_0", "c", {}, {}}};
  EXPECT_EQ(CountPoses(set).at("can").poses, 2U);
  EXPECT_EQ(CountPoses(set).at("can").least_per_view, 2U);
}

}  // namespace
}  // namespace handcraft::datasets
