// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "datasets/formats/view_set.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_image_set.h"

namespace handcraft::testing {

/// A mask whose left half is the object.
inline Image HalfMask(int width, int height) {
  Image mask(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width / 2; ++u) mask.At(u, v) = datasets::kObject;
  }
  return mask;
}

/// A cloud in which every point is measured.
inline datasets::OrganisedCloud FlatCloud(int width, int height) {
  datasets::OrganisedCloud cloud{.width = width, .height = height};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      cloud.points.emplace_back(0.01F * static_cast<float>(u), 0.01F * static_cast<float>(v), 0.0F);
    }
  }
  return cloud;
}

/// Three views of 8 × 6 below `root`, which must exist: two of a mug, of which the second has no
/// cloud and no angle, and one of a can in the test split.
inline datasets::ViewSet MakeViewSet(const std::filesystem::path& root) {
  datasets::ViewSet set{.root = root, .items = {}};
  for (const char* name : {"a", "b", "c"}) {
    const std::string stem(name);
    const std::uint64_t seed = 1 + set.items.size();
    perception::WritePng(root / (stem + ".png"), NoiseImage(8, 6, 3, seed));
    perception::WritePng(root / (stem + "_mask.png"), HalfMask(8, 6));
    datasets::WritePcd(root / (stem + ".pcd"), FlatCloud(8, 6));
    set.items.push_back({.image = stem + ".png",
                         .object_mask = stem + "_mask.png",
                         .cloud = stem + ".pcd",
                         .object_class = stem == "c" ? "can" : "mug",
                         .instance = stem == "c" ? "can_0" : "mug_0",
                         .angle_deg = 22.5,
                         .split = stem == "c" ? "test" : "train",
                         .licence = "CC0-1.0"});
  }
  set.items[1].cloud.clear();
  set.items[1].angle_deg.reset();
  return set;
}

}  // namespace handcraft::testing
