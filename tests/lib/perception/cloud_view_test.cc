// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/cloud_view.h"

#include <limits>

#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(IsMeasured, TakesFiniteCoordinatesAlone) {
  EXPECT_TRUE(IsMeasured({0.0F, -1.0F, 1e30F}));
  EXPECT_FALSE(IsMeasured({kNaN, 0.0F, 0.0F}));
  EXPECT_FALSE(IsMeasured({0.0F, kInfinity, 0.0F}));
  EXPECT_FALSE(IsMeasured({0.0F, 0.0F, -kInfinity}));
}

TEST(OrganiseIndexedCloud, PutsPointsAtTheirPixels) {
  const std::vector<Eigen::Vector3f> points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const std::vector<std::int32_t> pixels = {5, 0, 5};
  const auto organised = OrganiseIndexedCloud(points, pixels, 3, 2);
  ASSERT_EQ(organised.size(), 6U);
  EXPECT_EQ(organised[0], points[1]);
  EXPECT_EQ(organised[5], points[2]) << "the last of a pixel stays";
  for (const std::size_t i : {1, 2, 3, 4}) EXPECT_FALSE(IsMeasured(organised[i])) << i;
  EXPECT_TRUE(OrganiseIndexedCloud({}, {}, 0, 0).empty());
}

TEST(OrganiseIndexedCloud, RefusesPixelsOutsideThePicture) {
  const std::vector<Eigen::Vector3f> points(1);
  const auto organise = [&](std::int32_t pixel) {
    const std::vector<std::int32_t> pixels = {pixel};
    return OrganiseIndexedCloud(points, pixels, 3, 2);
  };
  EXPECT_THROWS_MESSAGE(organise(6), std::logic_error, HasSubstr("0, 6"));
  EXPECT_THROWS_MESSAGE(organise(-1), std::logic_error, HasSubstr("0, -1"));
  EXPECT_THROWS_MESSAGE(
      OrganiseIndexedCloud(points, {}, 3, 2), std::logic_error, HasSubstr("1, 0"));
}

TEST(PixelPoints, KeepsOrderWhenFiltered) {
  PixelPoints points;
  EXPECT_TRUE(points.empty());
  points.Reset(4);
  for (int i = 0; i < 4; ++i) {
    const auto x = static_cast<float>(i);
    points.Add({x, 10.0F + x, 20.0F + x}, 7 * i);
  }
  points.Filter([](float x, float, float) { return x != 1.0F; });
  EXPECT_THAT(points.Pixels(), ElementsAre(0, 14, 21));
  EXPECT_THAT(points.Coordinates(0), ElementsAre(0.0F, 2.0F, 3.0F));
  EXPECT_THAT(points.Coordinates(1), ElementsAre(10.0F, 12.0F, 13.0F));
  EXPECT_THAT(points.Coordinates(2), ElementsAre(20.0F, 22.0F, 23.0F));
  EXPECT_EQ(points.Point(1), Eigen::Vector3f(2.0F, 12.0F, 22.0F));
  points.Reset(2);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace handcraft::perception
