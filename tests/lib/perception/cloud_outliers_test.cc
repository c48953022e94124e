// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/cloud_outliers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Quartiles 2 and 4, so Step = 3.
TEST(FenceOf, GivesTheThresholdsByHand) {
  const std::vector<float> values = {5, 1, 3, 2, 4};
  EXPECT_EQ(FenceOf(values, {}), (Fence{-1.0F, 7.0F}));
  EXPECT_EQ(FenceOf(values, {.step = 0.0F}), (Fence{2.0F, 4.0F}));
}

// R: quantile(c(1, 2, 3, 10), c(.25, .75)) is 1.75 and 4.75.
TEST(FenceOf, InterpolatesBetweenOrderStatistics) {
  EXPECT_EQ(FenceOf(std::vector<float>{10, 3, 1, 2}, {.step = 1.0F}), (Fence{-1.25F, 7.75F}));
}

TEST(FenceOf, TakesNoneOneAndEqualValues) {
  EXPECT_EQ(FenceOf({}, {}), Fence());
  EXPECT_EQ(FenceOf(std::vector<float>{3.5F}, {}), (Fence{3.5F, 3.5F}));
  EXPECT_EQ(FenceOf(std::vector<float>(50, -2.25F), {}), (Fence{-2.25F, -2.25F}));
}

// Against a full sort; the sample's quartiles lie within its own error of the exact ones.
TEST(FenceOf, AgreesWithSorting) {
  Rng rng = Rng::Stream(1, "fence");
  for (const std::size_t size : {7U, 100U, 16384U, 100000U}) {
    std::vector<float> values(size);
    for (float& value : values) value = static_cast<float>(rng.Normal());
    const Fence fence = FenceOf(values, {.step = 0.0F});
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double q) {
      const double rank = q * static_cast<double>(size - 1);
      const auto i = static_cast<std::size_t>(rank);
      const double part = rank - static_cast<double>(i);
      const double low = values[i];
      return low + part * (static_cast<double>(values[std::min(i + 1, size - 1)]) - low);
    };
    const double tolerance = size > 16384 ? 0.04 : 1e-6;  // √(¼ · ¾ / 14286) / 0.318, threefold
    EXPECT_NEAR(fence.lower, quantile(0.25), tolerance) << size;
    EXPECT_NEAR(fence.upper, quantile(0.75), tolerance) << size;
  }
}

PixelPoints Points(const std::vector<Eigen::Vector3f>& list) {
  PixelPoints points;
  points.Reset(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) points.Add(list[i], static_cast<std::int32_t>(i));
  return points;
}

TEST(RemoveOutliers, LooksAtEachAxis) {
  std::vector<Eigen::Vector3f> list;
  list.reserve(12);
  for (int i = 0; i < 9; ++i) list.push_back(Eigen::Vector3f::Constant(static_cast<float>(i)));
  list.emplace_back(100, 4, 4);
  list.emplace_back(4, -100, 4);
  list.emplace_back(4, 4, 100);
  PixelPoints points = Points(list);
  RemoveOutliers(points, {});
  EXPECT_THAT(points.Pixels(), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(RemoveOutliers, KeepsWhatLiesOnTheThreshold) {
  std::vector<Eigen::Vector3f> list;
  list.reserve(5);
  for (const float x : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F}) list.emplace_back(x, 0, 0);
  PixelPoints points = Points(list);
  RemoveOutliers(points, {.step = 0.0F});
  EXPECT_THAT(points.Pixels(), ElementsAre(1, 2, 3));
}

TEST(RemoveOutliers, RemovesFliersFromAnObject) {
  Rng rng = Rng::Stream(2, "fliers");
  std::vector<Eigen::Vector3f> list;
  for (int i = 0; i < 2000; ++i) {
    Eigen::Vector3f point;
    for (float& x : point) x = static_cast<float>(0.1 * rng.Uniform());
    if (i % 100 == 0) point[i / 100 % 3] += 1.0F;
    list.push_back(point);
  }
  PixelPoints points = Points(list);
  RemoveOutliers(points, {});
  EXPECT_EQ(points.size(), 1980U);
}

TEST(RemoveOutliers, TakesAnEmptyCloud) {
  PixelPoints points;
  RemoveOutliers(points, {});
  EXPECT_TRUE(points.empty());
}

TEST(CloudOutlierOptions, RefusesWhatCannotBe) {
  EXPECT_NO_THROW(CloudOutlierOptions().Validate());
  EXPECT_THROWS_MESSAGE(CloudOutlierOptions{.step = -1.0F}.Validate(),
                        Error,
                        HasSubstr("CloudOutlierOptions.step is -1; it must be in [0, 100]"));
  EXPECT_THROWS_MESSAGE(
      CloudOutlierOptions{.step = std::nanf("")}.Validate(), Error, HasSubstr("step is nan"));
  EXPECT_THROWS_MESSAGE(
      CloudOutlierOptions{.max_samples = 3}.Validate(), Error, HasSubstr("max_samples is 3"));
}

}  // namespace
}  // namespace handcraft::perception
