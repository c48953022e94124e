// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "lib/core/image.h"
#include "lib/core/rng.h"
#include "lib/perception/cloud_view.h"

namespace handcraft::perception::testing {

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A cloud with its own points.
struct Cloud {
  std::vector<Eigen::Vector3f> points = {};
  int width = 0;
  int height = 0;

  [[nodiscard]] CloudView View() const { return {points, width, height}; }
  [[nodiscard]] Eigen::Vector3f& At(int u, int v) {
    return points[static_cast<std::size_t>(v * width + u)];
  }
};

/// Pixel (u, v) lies 5 mm · u along y and 5 mm · v along x: a table at `height_m` with noise.
inline Cloud Table(int width, int height, float height_m = 0.7F, float noise_m = 0.001F) {
  Rng rng = Rng::Stream(1, "table");
  Cloud cloud{.points = {}, .width = width, .height = height};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      cloud.points.emplace_back(0.005F * static_cast<float>(v),
                                0.005F * static_cast<float>(u),
                                height_m + noise_m * static_cast<float>(rng.Normal()));
    }
  }
  return cloud;
}

/// An 80 × 60 table with a block on columns 30…49, rows 20…39, whose top rises from 5 to 14.5 cm
/// above it: no horizontal plane.
inline Cloud TableWithBlock() {
  Cloud cloud = Table(80, 60);
  for (int v = 20; v < 40; ++v) {
    for (int u = 30; u < 50; ++u) cloud.At(u, v).z() += 0.05F + 0.005F * static_cast<float>(u - 30);
  }
  return cloud;
}

/// Its picture: a dark table, a bright block.
inline Image PictureOfBlock(int channels = 1) {
  Image image(80, 60, channels, 40);
  for (int v = 20; v < 40; ++v) {
    for (int u = 30; u < 50; ++u) {
      for (int c = 0; c < channels; ++c) image.At(u, v, c) = 200;
    }
  }
  return image;
}

}  // namespace handcraft::perception::testing
