// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/described_views.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/datasets/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::WriteSmallSet;

TEST(DescribeViews, HoldsPlaneAndMeanOfEachView) {
  const TemporaryDirectory folder;
  WriteSmallSet(folder.path(), {0.0, 30.0, 60.0});
  const ViewSet set = ReadViewSet(folder.path());
  const auto views = DescribeViews(set, 1, {});
  ASSERT_EQ(views.size(), 6U);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double angle_rad = *set.items[i].angle_deg * std::numbers::pi / 180.0;
    EXPECT_NEAR(features::AngleBetweenLines(views[i].normal,
                                            {-std::sin(angle_rad), std::cos(angle_rad), 0.0}),
                0.0,
                1e-6);
    EXPECT_NEAR(views[i].mean_m[0], 0.3, 0.03);
  }
}

TEST(DescribeViews, IsTheSameWithAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  WriteSmallSet(folder.path(), {0.0, 30.0});
  const ViewSet set = ReadViewSet(folder.path());
  const auto one = DescribeViews(set, 1, {});
  const auto two = DescribeViews(set, 2, {});
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].normal, two[i].normal);
    EXPECT_EQ(one[i].moments, two[i].moments);
  }
}

TEST(DescribeViews, NamesTheViewThatIsOfNoUse) {
  const TemporaryDirectory folder;
  WriteSmallSet(folder.path(), {0.0});
  ViewSet set = ReadViewSet(folder.path());
  const auto describe = [&set] { static_cast<void>(DescribeViews(set, 1, {})); };
  OrganisedCloud two_points = testing::SmallView(0.0, 0.0, 0).cloud.value();
  for (std::size_t i = 38; i < two_points.points.size(); ++i) {
    two_points.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  two_points.points[2 * 16 + 4].setConstant(std::numeric_limits<float>::quiet_NaN());
  two_points.points[2 * 16 + 5].setConstant(std::numeric_limits<float>::quiet_NaN());
  WritePcd(folder / set.items[1].cloud, two_points);
  EXPECT_THROWS_MESSAGE(
      describe(),
      Error,
      AllOf(HasSubstr("wedge0.pcd"), HasSubstr("fewer than three measured points")));
  set.items[0].cloud.clear();
  EXPECT_THROWS_MESSAGE(
      describe(), Error, AllOf(HasSubstr("board0.png"), HasSubstr("has no cloud")));
}

}  // namespace
}  // namespace handcraft::datasets
