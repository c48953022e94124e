// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_cloud.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/lib/features/some_object.h"

namespace handcraft::features {
namespace {

using testing::SomeObject;

bool SameBox(const PixelExtent& a, const PixelExtent& b) {
  return a.u_begin == b.u_begin && a.u_end == b.u_end && a.v_begin == b.v_begin &&
         a.v_end == b.v_end;
}

PixelExtent BruteForceExtent(const ObjectCloud& cloud) {
  PixelExtent extent{.u_begin = cloud.width, .u_end = 0, .v_begin = cloud.height, .v_end = 0};
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      if (!cloud.Has(u, v)) continue;
      extent.u_begin = std::min(extent.u_begin, u);
      extent.u_end = std::max(extent.u_end, u + 1);
      extent.v_begin = std::min(extent.v_begin, v);
      extent.v_end = std::max(extent.v_end, v + 1);
    }
  }
  return extent.v_end == 0 ? PixelExtent{} : extent;
}

TEST(ObjectCloud, ExtentIsTheBoxOfMeasuredPixels) {
  for (const int width : {1, 7, 8, 9, 40}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      SomeObject object(width, 13, seed);
      EXPECT_TRUE(SameBox(FindExtent(object.View()), BruteForceExtent(object.View()))) << width;
      ObjectCloud whole = object.View();
      whole.mask = nullptr;
      EXPECT_TRUE(SameBox(FindExtent(whole), BruteForceExtent(whole))) << width;
    }
  }
}

TEST(ObjectCloud, OneMeasuredPixelIsABoxOfOne) {
  SomeObject object(20, 10);
  std::fill(object.points.begin(), object.points.end(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(SameBox(FindExtent(object.View()), {}));
  const std::size_t pixel = 5 * 20 + 11;
  std::fill_n(object.points.begin() + 3 * pixel, 3, 0.25F);
  EXPECT_TRUE(SameBox(FindExtent(object.View()), {11, 12, 5, 6}));
  object.mask[pixel] = 0;
  EXPECT_TRUE(SameBox(FindExtent(object.View()), {}));
}

TEST(ObjectCloud, WhatIsNotFiniteOrAbsurdlyFarIsNotMeasured) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 1.1e6F}) {
    for (int axis = 0; axis < 3; ++axis) {
      float point[3] = {1.0F, -1.0F, 1e6F};
      EXPECT_TRUE(ObjectCloud::IsMeasured(point));
      point[axis] = bad;
      EXPECT_FALSE(ObjectCloud::IsMeasured(point)) << bad << " on axis " << axis;
    }
  }
}

TEST(ObjectCloud, OfNoPixelsHasNoExtent) { EXPECT_TRUE(SameBox(FindExtent({}), {})); }

}  // namespace
}  // namespace handcraft::features
