// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/cloud_view.h"

#include <limits>

#include "lib/core/check.h"

namespace handcraft::perception {

std::vector<Eigen::Vector3f> OrganiseIndexedCloud(std::span<const Eigen::Vector3f> points,
                                                  std::span<const std::int32_t> pixels,
                                                  int width,
                                                  int height) {
  HC_CHECK(width >= 0 && height >= 0, width, height);
  HC_CHECK(points.size() == pixels.size(), points.size(), pixels.size());
  const std::size_t num_pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<Eigen::Vector3f> organised(
      num_pixels, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    HC_CHECK(pixels[i] >= 0 && static_cast<std::size_t>(pixels[i]) < num_pixels, i, pixels[i]);
    organised[static_cast<std::size_t>(pixels[i])] = points[i];
  }
  return organised;
}

void PixelPoints::Reset(std::size_t capacity) {
  size_ = 0;
  if (capacity <= pixels_.size()) return;
  x_.resize(capacity);
  y_.resize(capacity);
  z_.resize(capacity);
  pixels_.resize(capacity);
}

}  // namespace handcraft::perception
