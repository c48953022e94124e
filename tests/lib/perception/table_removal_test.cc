// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/table_removal.h"

#include <cmath>

#include <Eigen/Geometry>

#include "lib/core/error.h"
#include "tests/lib/perception/table_scene.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

using testing::Cloud;
using ::testing::HasSubstr;
using testing::kNaN;
using testing::Table;
using testing::TableWithBlock;

std::size_t NumOff(const Cloud& cloud, const TablePlanes& table, float epsilon_m = 0.01F) {
  PixelPoints rest;
  TakePointsOffPlanes(cloud.View(), table.planes, epsilon_m, rest);
  return rest.size();
}

TEST(FindTable, FindsTheTableAndLeavesTheBlock) {
  const Cloud cloud = TableWithBlock();
  const TablePlanes table = FindTable(cloud.View(), {});
  ASSERT_EQ(table.state, TableState::kFound);
  ASSERT_EQ(table.planes.size(), 1U);
  EXPECT_GT(table.planes[0].normal.z(), 0.9999F);
  EXPECT_NEAR(table.planes[0].offset_m, 0.7F, 0.001F);
  PixelPoints rest;
  EXPECT_EQ(TakePointsOffPlanes(cloud.View(), table.planes, 0.01F, rest), 4800U);
  ASSERT_EQ(rest.size(), 400U) << "the block, and it alone";
  EXPECT_EQ(rest.Pixels().front(), 20 * 80 + 30);
  EXPECT_EQ(rest.Pixels().back(), 39 * 80 + 49);
}

TEST(FindTable, DrawsTheSameFromTheSameSeed) {
  const Cloud cloud = TableWithBlock();
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const TablePlanes first = FindTable(cloud.View(), {.seed = seed});
    const TablePlanes second = FindTable(cloud.View(), {.seed = seed});
    EXPECT_EQ(first.num_tries, second.num_tries);
    ASSERT_EQ(first.planes.size(), 1U) << seed;
    EXPECT_EQ(first.planes[0].normal, second.planes[0].normal);
    EXPECT_EQ(NumOff(cloud, first), 400U) << seed;
  }
}

// Turning cloud and up vector together changes nothing but rounding.
TEST(FindTable, DoesNotDependOnTheFrame) {
  const Eigen::AngleAxisf turn(2.1F, Eigen::Vector3f(1, -2, 0.5F).normalized());
  Cloud cloud = TableWithBlock();
  for (Eigen::Vector3f& point : cloud.points) point = turn * point;
  const TablePlanes table =
      FindTable(cloud.View(), {.up = turn * Eigen::Vector3f(0.0F, 0.0F, 3.0F)});
  ASSERT_EQ(table.planes.size(), 1U);
  EXPECT_EQ(NumOff(cloud, table), 400U);
}

TEST(FindTable, SaysThatThereIsNoPlaneWhereUpIsAnotherWay) {
  const Cloud cloud = Table(40, 30);
  const TablePlanes table = FindTable(cloud.View(), {.up = {1.0F, 0.0F, 0.0F}});
  EXPECT_EQ(table.state, TableState::kNoPlane);
  EXPECT_EQ(table.num_tries, 50);
  EXPECT_EQ(NumOff(cloud, table), 1200U);
  EXPECT_EQ(FindTable(cloud.View(), {.up = {1, 0, 0}, .max_angle_rad = 1.5708F}).state,
            TableState::kFound)
      << "any plane will do";
}

// A tilted table passes when its angle to up is allowed, and only then.
TEST(FindTable, KeepsPlanesWithinTheAngle) {
  Cloud cloud = Table(40, 30);
  for (Eigen::Vector3f& point : cloud.points) point.z() += std::tan(0.2F) * point.x();
  EXPECT_EQ(FindTable(cloud.View(), {.max_angle_rad = 0.17F}).state, TableState::kNoPlane);
  EXPECT_EQ(FindTable(cloud.View(), {.max_angle_rad = 0.23F}).state, TableState::kFound);
}

// A shelf of a sixth of the points above the table is a second support, a smaller one is an object.
TEST(FindTable, TakesEverySupportThatHoldsItsShare) {
  Cloud cloud = Table(60, 40);
  for (int v = 0; v < 40; ++v) {
    for (int u = 0; u < 20; ++u) cloud.At(u, v).z() += 0.3F;
  }
  EXPECT_EQ(FindTable(cloud.View(), {}).planes.size(), 2U);
  EXPECT_EQ(FindTable(cloud.View(), {.min_share = 0.4F}).planes.size(), 1U);
}

// A floor beyond the table's edge, too small a share to be a support itself.
TEST(TakePointsOffPlanes, LeavesOutWhatIsBelowEverySupport) {
  Cloud cloud = TableWithBlock();
  const float table_m = 0.7F;
  for (int u = 0; u < 80; ++u) {
    for (int v = 0; v < 4; ++v) cloud.At(u, v).z() = 0.0F;
  }
  const TablePlanes table = FindTable(cloud.View(), {});
  ASSERT_EQ(table.planes.size(), 1U);
  ASSERT_NEAR(table.planes[0].offset_m, table_m, 0.001F);
  EXPECT_EQ(NumOff(cloud, table), 400U) << "the block, and it alone";
  EXPECT_EQ(NumOff(cloud, {.planes = {}}), cloud.points.size());
  const Plane floor{.normal = Eigen::Vector3f::UnitZ(), .offset_m = 0.0F};
  cloud.At(0, 0).z() = 0.1F;
  EXPECT_EQ(NumOff(cloud, {.planes = {table.planes[0], floor}}), 401U) << "one stands on the floor";
}

// The dissertation's rule: a plane of few neighbours is tilted by their noise, and other
// neighbourhoods have to take what it leaves; fitted again to all points near it, one is enough.
TEST(FindTable, NeedsFewerPlanesWhenTheyAreFittedAgain) {
  const Cloud cloud = Table(160, 120, 0.7F, 0.003F);
  const TableRemovalOptions literal{.neighbourhood_px = 3,
                                    .max_tries = 200,
                                    .enough_removed = 0.99F,
                                    .min_share = 0.0F,
                                    .refinements = 0};
  TableRemovalOptions refined = literal;
  refined.refinements = 2;
  const TablePlanes by_text = FindTable(cloud.View(), literal);
  const TablePlanes ours = FindTable(cloud.View(), refined);
  EXPECT_EQ(ours.planes.size(), 1U);
  EXPECT_GT(by_text.planes.size(), 1U);
  EXPECT_LE(NumOff(cloud, ours), NumOff(cloud, by_text) + 200);
}

TEST(FindTable, HasNoPointsInAnEmptyCloud) {
  const TablePlanes table = FindTable(CloudView(), {});
  EXPECT_EQ(table.state, TableState::kNoPoints);
  EXPECT_TRUE(table.planes.empty());
}

TEST(FindTable, HasNoPointsWhereAllDepthsAreNaN) {
  Cloud cloud = Table(40, 30);
  for (Eigen::Vector3f& point : cloud.points) point.setConstant(kNaN);
  EXPECT_EQ(FindTable(cloud.View(), {}).state, TableState::kNoPoints);
  EXPECT_EQ(NumOff(cloud, {}), 0U);
}

TEST(FindTable, HasNoPlaneInOnePointOrOnePlace) {
  Cloud cloud = Table(40, 30);
  for (Eigen::Vector3f& point : cloud.points) point.setConstant(1.0F);
  EXPECT_EQ(FindTable(cloud.View(), {}).state, TableState::kNoPlane);
  Cloud single{.points = {{0, 0, 1}}, .width = 1, .height = 1};
  EXPECT_EQ(FindTable(single.View(), {}).state, TableState::kNoPlane);
}

TEST(FindTable, HasNoPlaneInNoise) {
  Cloud cloud = Table(40, 30);
  Rng rng = Rng::Stream(3, "noise");
  for (Eigen::Vector3f& point : cloud.points) {
    for (float& x : point) x = static_cast<float>(rng.Uniform());
  }
  EXPECT_EQ(FindTable(cloud.View(), {}).state, TableState::kNoPlane);
}

TEST(FindTable, WorksWithHolesAndInfinities) {
  Cloud cloud = TableWithBlock();
  for (std::size_t i = 0; i < cloud.points.size(); i += 3) cloud.points[i].setConstant(kNaN);
  cloud.At(5, 5).x() = std::numeric_limits<float>::infinity();
  const TablePlanes table = FindTable(cloud.View(), {});
  EXPECT_EQ(table.state, TableState::kFound);
  EXPECT_NEAR(table.planes[0].offset_m, 0.7F, 0.001F);
}

TEST(FindTable, RefusesACloudOfAnotherSize) {
  const Cloud cloud = Table(4, 3);
  EXPECT_THROWS_MESSAGE(
      FindTable({cloud.points, 4, 4}, {}), std::logic_error, HasSubstr("12, 4, 4"));
}

TEST(TableRemovalOptions, RefusesWhatCannotBe) {
  const auto refuses = [](const TableRemovalOptions& options, const std::string& message) {
    EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("TableRemovalOptions." + message));
  };
  EXPECT_NO_THROW(TableRemovalOptions().Validate());
  EXPECT_NO_THROW(TableRemovalOptions{.max_angle_rad = 1.5708F}.Validate());
  refuses({.up = {0, 0, 0}}, "up is 0; it must be of a finite length above 0");
  refuses({.up = {kNaN, 0, 0}}, "up");
  refuses({.max_angle_rad = 0.0F}, "max_angle_rad is 0; it must be in (0, pi/2]");
  refuses({.max_angle_rad = 2.0F}, "max_angle_rad is 2");
  refuses({.epsilon_m = -0.5F}, "epsilon_m is -0.5");
  refuses({.epsilon_m = kNaN}, "epsilon_m is nan");
  refuses({.neighbourhood_px = 0}, "neighbourhood_px is 0");
  refuses({.neighbourhood_m = 11.0F}, "neighbourhood_m is 11");
  refuses({.min_neighbours = 2}, "min_neighbours is 2");
  refuses({.max_tries = 0}, "max_tries is 0");
  refuses({.enough_removed = 1.5F}, "enough_removed is 1.5");
  refuses({.min_share = -1.0F}, "min_share is -1");
  refuses({.refinements = 11}, "refinements is 11");
  refuses({.max_samples = 99}, "max_samples is 99");
}

}  // namespace
}  // namespace handcraft::perception
