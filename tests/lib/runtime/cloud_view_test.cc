// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/cloud_view.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace handcraft::runtime {
namespace {

const float kPoints[24] = {};
const std::uint8_t kMask[8] = {};
const hc_cloud kCloud = {kPoints, 4, 2, 12, 3, kMask, 4};

TEST(CloudView, KeepsWhatTheCallerSaid) {
  ASSERT_TRUE(IsCloud(kCloud));
  const features::ObjectCloud view = ViewOf(kCloud);
  EXPECT_EQ(view.Point(3, 1), kPoints + 21);
  EXPECT_EQ(view.width, 4);
  EXPECT_EQ(view.height, 2);
  EXPECT_EQ(view.mask, kMask);
  EXPECT_EQ(view.mask_stride, 4);
}

TEST(CloudView, RefusesWhatCannotBeRead) {
  const auto is_refused = [](auto change) {
    hc_cloud cloud = kCloud;
    change(cloud);
    return !IsCloud(cloud);
  };
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.points = nullptr; }));
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.width = 0; }));
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.height = -1; }));
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.width = std::numeric_limits<std::int32_t>::max(); }));
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.point_stride = 2; }));
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.row_stride = 11; }));
  EXPECT_TRUE(is_refused([](hc_cloud& c) { c.mask_stride = 3; }));
  EXPECT_FALSE(is_refused([](hc_cloud& c) {
    c.mask = nullptr;
    c.mask_stride = 0;
  }));
}

}  // namespace
}  // namespace handcraft::runtime
