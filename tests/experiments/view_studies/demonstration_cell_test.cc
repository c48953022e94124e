// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/demonstration_cell.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using features::TurnAboutZ;
using grasp_library::TrainingSet;
using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180.0;

ViewCell CellOf(std::initializer_list<Setting> list) {
  ViewCell cell{.id = "cell", .method = "cell", .factors = {}, .settings = {}};
  for (const Setting& setting : list) ApplyViewSetting(setting, cell.settings);
  return cell;
}

void Show(TrainingSet& set, double angle_deg, const features::Vector3& p, double hand_deg) {
  set.poses.push_back({.object_class = 0,
                       .angle_rad = angle_deg * kDegree,
                       .mean_m = {0.5, 0.0, 0.0},
                       .position_m = p,
                       .rotation = TurnAboutZ(hand_deg * kDegree),
                       .number = static_cast<std::int32_t>(set.poses.size())});
}

// A can, seen and shown unturned: hands 10 mm apart along x, the last one 100 mm further.
TrainingSet OfACan() {
  TrainingSet set{.classes = {"can"}};
  set.views.push_back({.object_class = 0, .angle_rad = 0.0, .description = {}});
  Show(set, 0.0, {0.500, 0.0, 0.0}, 0.0);
  Show(set, 0.0, {0.510, 0.0, 0.0}, 20.0);
  Show(set, 0.0, {0.524, 0.0, 0.0}, 60.0);
  Show(set, 0.0, {0.624, 0.0, 0.0}, 60.0);
  return set;
}

// The nearest other is 10, 10, 14 and 100 mm away, and turned by 20, 20, 40 and 0 degrees.
TEST(FindHeldOut, OfAHandCase) {
  const ViewCellResult result = FindHeldOut(CellOf({}), OfACan(), 1);
  ASSERT_EQ(result.groups.size(), 2U);
  EXPECT_EQ(result.groups[1].name, "all");
  EXPECT_EQ(result.groups[1].num_views, 4U);
  EXPECT_EQ(result.groups[1].num_right, 3U);
  EXPECT_EQ(result.answers.columns[3], "to 40°");
  EXPECT_EQ(result.answers.counts[0][3], 1U);
  EXPECT_EQ(result.answers.columns.back(), "too far");
  EXPECT_EQ(result.answers.counts[0].back(), 0U);
  const GroupErrors& all = result.errors.back();
  EXPECT_EQ(all.num_kept, 4U);
  EXPECT_NEAR(all.median_position_m, 0.014, 1e-12);
  EXPECT_NEAR(all.high_position_m, 0.1, 1e-12);
  EXPECT_NEAR(all.high_rotation_deg, 40.0, 1e-9);
  ASSERT_EQ(result.rejection.size(), 3U);
  EXPECT_NEAR(result.rejection[1].limit, 0.014, 1e-12);
  EXPECT_EQ(result.rejection[1].num_kept, 3U);
  EXPECT_EQ(result.rejection[1].num_right, 2U);
}

TEST(FindHeldOut, RejectsWhatIsFar) {
  const ViewCellResult result = FindHeldOut(CellOf({{"max_distance_m", "0.012"}}), OfACan(), 1);
  EXPECT_EQ(result.answers.counts[0].back(), 2U);
  EXPECT_EQ(result.groups.back().num_right, 2U);
  EXPECT_EQ(result.errors.back().num_kept, 2U);
  EXPECT_EQ(result.errors.back().num_asked, 4U);
  EXPECT_NEAR(result.errors.back().high_position_m, 0.010, 1e-12);
  EXPECT_EQ(result.rejection.size(), 3U) << "the curve does not see the setting";
}

// Of three neighbours the mean, so that the hand at 10 mm is between its neighbours.
TEST(FindHeldOut, AveragesNeighbours) {
  TrainingSet set = OfACan();
  set.poses.pop_back();
  set.poses[2].position_m[0] = 0.520;
  set.poses[2].rotation = TurnAboutZ(40.0 * kDegree);
  const ViewCellResult one = FindHeldOut(CellOf({}), set, 1);
  const ViewCellResult two = FindHeldOut(CellOf({{"neighbours", "2"}}), set, 2);
  EXPECT_EQ(one.groups.back().num_right, 3U);
  // The middle one is exact, the outer ones are off by more than before.
  EXPECT_EQ(two.answers.counts[0][0], 1U);
  EXPECT_GT(two.errors.back().high_position_m, one.errors.back().high_position_m);
}

// The same hands, shown again where the object is turned by 30 degrees: the other view is as good.
TEST(FindHeldOut, AsksTheNextViewTurned) {
  TrainingSet set = OfACan();
  for (int i = 0; i < 4; ++i) {
    const grasp_library::ShownPose& pose = set.poses[static_cast<std::size_t>(i)];
    const features::Vector3 turned =
        features::TurnedAboutZ({pose.position_m[0] - 0.5, 0.0, 0.0}, 30.0 * kDegree);
    const double hand_deg = i == 0 ? 0.0 : i == 1 ? 20.0 : 60.0;
    Show(set, 30.0, {0.5 + turned[0], turned[1], turned[2]}, hand_deg + 30.0);
  }
  const ViewCellResult result = FindHeldOut(CellOf({{"held_out", "view"}}), set, 1);
  EXPECT_EQ(result.groups.back().num_right, 8U);
  EXPECT_LT(result.errors.back().high_position_m, 1e-12);
  EXPECT_LT(result.errors.back().high_rotation_deg, 1e-5);
  // Each held out alone it is the hand case twice.
  EXPECT_EQ(FindHeldOut(CellOf({}), set, 1).groups.back().num_right, 6U);
}

TEST(FindHeldOut, RefusesALonelyDemonstration) {
  TrainingSet set = OfACan();
  set.poses.resize(1);
  EXPECT_THROWS_MESSAGE(static_cast<void>(FindHeldOut(CellOf({}), set, 1)),
                        Error,
                        HasSubstr("no other demonstration of \"can\" is left"));
  EXPECT_THROWS_MESSAGE(static_cast<void>(FindHeldOut(CellOf({{"held_out", "view"}}), OfACan(), 1)),
                        Error,
                        HasSubstr("no other demonstration"));
}

}  // namespace
}  // namespace handcraft::experiments
