// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/rotation_cell.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/view_studies/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::MakeSmallViews;
using handcraft::testing::TemporaryDirectory;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(RotationBin, GoesRound) {
  EXPECT_EQ(RotationBin(0.0), 0U);
  EXPECT_EQ(RotationBin(-4.9), 0U);
  EXPECT_EQ(RotationBin(10.0), 1U);
  EXPECT_EQ(RotationBin(-10.0), 35U);
  EXPECT_EQ(RotationBin(355.0), 0U);
  EXPECT_EQ(RotationBin(-350.0), 1U);
  EXPECT_EQ(RotationBin(180.0), 18U);
}

TEST(IsRightRotation, KnowsHalfTurns) {
  for (const double difference : {0.0, 10.0, -10.0, 350.0, -350.0}) {
    EXPECT_TRUE(IsRightRotation(difference, "none")) << difference;
    EXPECT_TRUE(IsRightRotation(difference + 180.0, "half_turn")) << difference;
    EXPECT_FALSE(IsRightRotation(difference + 180.0, "none")) << difference;
  }
  EXPECT_FALSE(IsRightRotation(20.0, "none"));
  EXPECT_FALSE(IsRightRotation(90.0, "half_turn"));
}

TEST(FindRotations, LeavesRoundObjectsOutAndGroupsBySymmetry) {
  const TemporaryDirectory folder;
  const datasets::ViewSet data = MakeSmallViews(folder / "set", 6);
  const ViewCell cell{.id = "all", .method = "all", .factors = {}, .settings = {}};
  const ViewCellResult result = FindRotations(cell, data, nullptr, 2);
  EXPECT_THAT(result.answers.rows, ElementsAre("spray_bottle", "coffee_can", "drill"));
  for (const auto& row : result.answers.counts) {
    EXPECT_EQ(std::accumulate(row.begin(), row.end(), std::size_t{0}), 6U);
    EXPECT_EQ(row[0], 0U) << "no other view has the same angle";
  }
  ASSERT_EQ(result.groups.size(), 5U);
  EXPECT_THAT(result.answers.kinds, ElementsAre("asymmetric", "half_turn", "asymmetric"));
  EXPECT_EQ(result.groups[3].name, "asymmetric");
  EXPECT_EQ(result.groups[3].num_views, 12U);
  EXPECT_EQ(result.groups[4].name, "half_turn");
  // Asked about the very views that were learnt, every object finds itself.
  const ViewCellResult same = FindRotations(cell, data, &data, 1);
  for (const auto& row : same.answers.counts) EXPECT_EQ(row[0], 6U);
  EXPECT_EQ(same.groups[3].num_right, 12U);
}

// The dissertation's figures are of objects whose symmetry is known.
TEST(FindRotations, KeepsObjectsOfUnknownSymmetryApart) {
  const TemporaryDirectory folder;
  datasets::ViewSet data = MakeSmallViews(folder / "set", 4);
  for (datasets::ObjectView& view : data.items) {
    if (view.object_class == "drill") view.symmetry.clear();
  }
  const ViewCell cell{.id = "all", .method = "all", .factors = {}, .settings = {}};
  const ViewCellResult result = FindRotations(cell, data, nullptr, 1);
  EXPECT_THAT(result.answers.kinds, ElementsAre("asymmetric", "half_turn", "symmetry unknown"));
  ASSERT_EQ(result.groups.size(), 6U);
  EXPECT_EQ(result.groups[5].name, "symmetry unknown");
  EXPECT_EQ(result.groups[5].num_views, 4U);
}

TEST(FindRotations, RefusesViewsWithoutAngles) {
  const TemporaryDirectory folder;
  datasets::ViewSet data = MakeSmallViews(folder / "set", 1);
  const ViewCell cell{.id = "all", .method = "all", .factors = {}, .settings = {}};
  EXPECT_THROWS_MESSAGE(static_cast<void>(FindRotations(cell, data, nullptr, 1)),
                        Error,
                        HasSubstr("no other view of \"spray_bottle\" was learnt"));
  for (datasets::ObjectView& view : data.items) view.angle_deg.reset();
  EXPECT_THROWS_MESSAGE(static_cast<void>(FindRotations(cell, data, nullptr, 1)),
                        Error,
                        HasSubstr("no view has an angle"));
}

}  // namespace
}  // namespace handcraft::experiments
