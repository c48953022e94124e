// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/cloud_view.h"

#include <cstdint>

namespace handcraft::runtime {
namespace {

// So that offsets in floats never overflow.
constexpr std::int32_t kMaxSide = 1 << 20;
constexpr std::int64_t kMaxStride = std::int64_t{1} << 40;

bool IsBetween(std::int64_t value, std::int64_t low, std::int64_t high) noexcept {
  return value >= low && value <= high;
}

}  // namespace

bool IsCloud(const hc_cloud& cloud) noexcept {
  return cloud.points != nullptr && IsBetween(cloud.width, 1, kMaxSide) &&
         IsBetween(cloud.height, 1, kMaxSide) &&
         IsBetween(cloud.point_stride, 3, kMaxStride / kMaxSide) &&
         IsBetween(cloud.row_stride, cloud.point_stride * (cloud.width - 1) + 3, kMaxStride) &&
         (cloud.mask == nullptr || IsBetween(cloud.mask_stride, cloud.width, kMaxStride));
}

features::ObjectCloud ViewOf(const hc_cloud& cloud) noexcept {
  return {.points = cloud.points,
          .width = cloud.width,
          .height = cloud.height,
          .row_stride = cloud.row_stride,
          .point_stride = cloud.point_stride,
          .mask = cloud.mask,
          .mask_stride = cloud.mask_stride};
}

}  // namespace handcraft::runtime
