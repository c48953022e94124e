// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace handcraft::perception {

/// Whether something was measured there: all three coordinates are finite.
[[nodiscard]] inline bool IsMeasured(const Eigen::Vector3f& point) { return point.allFinite(); }

/// An organised cloud in somebody else's memory: one point [m] for each pixel of a picture,
/// row-major; NaN where nothing was measured.
struct CloudView {
  std::span<const Eigen::Vector3f> points = {};  ///< width · height of them
  int width = 0;                                 ///< [px]
  int height = 0;                                ///< [px]
};

/// Lays an indexed cloud out as an organised one: point i belongs to pixel pixels[i] = v · width +
/// u. Of several points of one pixel the last stays; pixels without one are NaN. Throws
/// std::logic_error on a pixel outside the picture or lists of different lengths.
[[nodiscard]] std::vector<Eigen::Vector3f> OrganiseIndexedCloud(
    std::span<const Eigen::Vector3f> points,
    std::span<const std::int32_t> pixels,
    int width,
    int height);

/// Points and the pixels they belong to, coordinate by coordinate. Keeps its memory when it is
/// cleared, so that frame after frame takes none.
class PixelPoints {
 public:
  /// Empties it and makes room for `capacity` points.
  void Reset(std::size_t capacity);
  /// The capacity must not be exceeded; not checked.
  void Add(const Eigen::Vector3f& point, std::int32_t pixel) noexcept {
    x_[size_] = point.x();
    y_[size_] = point.y();
    z_[size_] = point.z();
    pixels_[size_++] = pixel;
  }
  /// Keeps the points for which keep(x, y, z) holds, in their order.
  template <class Keep>
  void Filter(const Keep& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const bool stays = keep(x_[i], y_[i], z_[i]);
      x_[kept] = x_[i];
      y_[kept] = y_[i];
      z_[kept] = z_[i];
      pixels_[kept] = pixels_[i];
      kept += stays ? 1 : 0;
    }
    size_ = kept;
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  /// Axis 0, 1 or 2 of all points.
  [[nodiscard]] std::span<const float> Coordinates(int axis) const noexcept {
    return std::span(axis == 0 ? x_ : axis == 1 ? y_ : z_).first(size_);
  }
  [[nodiscard]] std::span<const std::int32_t> Pixels() const noexcept {
    return std::span(pixels_).first(size_);
  }
  [[nodiscard]] Eigen::Vector3f Point(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }

 private:
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
  std::vector<std::int32_t> pixels_;
  std::size_t size_ = 0;
};

}  // namespace handcraft::perception
