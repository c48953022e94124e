// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "lib/core/rng.h"
#include "lib/perception/image_io.h"

namespace handcraft::testing {

/// A noisy cloud of 32 × 24 pixels: a bulge in the middle for "ball", a slope for "ramp", a flat
/// middle that is narrow for "post" and wide for any other name; a tenth of the points is missing.
inline datasets::OrganisedCloud SomeCloud(const std::string& shape, Rng& rng) {
  datasets::OrganisedCloud cloud{.width = 32, .height = 24};
  for (int v = 0; v < 24; ++v) {
    for (int u = 0; u < 32; ++u) {
      const float x = (static_cast<float>(u) - 15.5F) / 100.0F;
      const float y = (static_cast<float>(v) - 11.5F) / 100.0F;
      float depth = 0.6F + 0.002F * static_cast<float>(rng.Normal());
      if (shape == "ball") depth -= 0.05F - 4.0F * (x * x + y * y);
      if (shape == "ramp") depth += y;
      cloud.points.emplace_back(depth, -x, -y);
      if (rng.UniformInt(10) == 0) {
        cloud.points.back().setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
  return cloud;
}

/// The object of such a cloud: the middle of the picture, narrow for "post".
inline Image SomeObjectMask(const std::string& shape) {
  Image mask(32, 24);
  const int margin = shape == "post" ? 12 : 5;
  for (int v = 4; v < 20; ++v) {
    for (int u = margin; u < 32 - margin; ++u) mask.At(u, v) = datasets::kObject;
  }
  return mask;
}

/// `num_views` views of each shape in a new folder, turned by equal angles, all in the split
/// "train". Drawn from `seed`.
inline datasets::ViewSet WriteObjectViews(const std::filesystem::path& root,
                                          const std::vector<std::string>& shapes,
                                          int num_views = 4,
                                          std::uint64_t seed = 1) {
  std::filesystem::create_directories(root);
  datasets::ViewSet set{.root = root, .items = {}};
  for (const std::string& shape : shapes) {
    for (int i = 0; i < num_views; ++i) {
      Rng rng = Rng::Stream(seed, shape, static_cast<std::uint64_t>(i));
      const std::string stem = shape + "_" + std::to_string(i);
      perception::WritePng(root / (stem + ".png"), Image(32, 24));
      perception::WritePng(root / (stem + "_mask.png"), SomeObjectMask(shape));
      datasets::WritePcd(root / (stem + ".pcd"), SomeCloud(shape, rng));
      set.items.push_back({.image = stem + ".png",
                           .object_mask = stem + "_mask.png",
                           .cloud = stem + ".pcd",
                           .object_class = shape,
                           .instance = shape + "_0",
                           .angle_deg = 360.0 * i / num_views,
                           .split = "train"});
    }
  }
  datasets::WriteViews(set);
  return set;
}

}  // namespace handcraft::testing
