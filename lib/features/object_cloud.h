// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace handcraft::features {

/// Farther than that from the origin along any axis [m], a point counts as not measured, so that no
/// sum or difference overflows.
inline constexpr float kMaxCoordinate_m = 1e6F;

/// Fewer measured points are no object.
inline constexpr std::size_t kMinObjectPoints = 3;

/// An object's part of an organised cloud in the caller's memory [m]. For a box of the picture,
/// point to its first pixel and give its width and height.
struct ObjectCloud {
  const float* points = nullptr;  ///< x, y, z of pixel (u, v) at v · row_stride + u · point_stride
  int width = 0;                  ///< [px]
  int height = 0;                 ///< [px]
  std::ptrdiff_t row_stride = 0;       ///< floats from one row to the next
  std::ptrdiff_t point_stride = 3;     ///< floats from one point to the next, ≥ 3
  const std::uint8_t* mask = nullptr;  ///< pixel (u, v) is the object's where not 0; null: all are
  std::ptrdiff_t mask_stride = 0;      ///< bytes from one row to the next

  [[nodiscard]] const float* Point(int u, int v) const noexcept {
    return points + v * row_stride + u * point_stride;
  }
  /// Whether the point at `p` was measured: its coordinates are finite and at most
  /// kMaxCoordinate_m.
  [[nodiscard]] static bool IsMeasured(const float* p) noexcept {
    return std::fabs(p[0]) <= kMaxCoordinate_m && std::fabs(p[1]) <= kMaxCoordinate_m &&
           std::fabs(p[2]) <= kMaxCoordinate_m;
  }
  /// Whether the pixel is the object's and was measured.
  [[nodiscard]] bool Has(int u, int v) const noexcept {
    return (mask == nullptr || mask[v * mask_stride + u] != 0) && IsMeasured(Point(u, v));
  }
};

/// The smallest box that holds the object's measured pixels; empty when there are none.
struct PixelExtent {
  int u_begin = 0;  ///< [px]
  int u_end = 0;
  int v_begin = 0;
  int v_end = 0;

  [[nodiscard]] int Width() const noexcept { return u_end - u_begin; }
  [[nodiscard]] int Height() const noexcept { return v_end - v_begin; }
};

/// Looks at each row from its two ends; does not allocate.
[[nodiscard]] PixelExtent FindExtent(const ObjectCloud& cloud) noexcept;

}  // namespace handcraft::features
