// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/formats/view_set.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets::testing {

/// An upright board that is wider at one end, seen head-on and turned about z by `angle_deg`, in
/// 16 × 12 pixels; `p_m` of its cloud is about (`x_m`, 0, 0.05).
inline LoadedView SmallView(double angle_deg, double x_m, int narrowing) {
  LoadedView view{.image = Image(16, 12, 3, 90), .object_mask = Image(16, 12), .cloud = {}};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  OrganisedCloud& cloud = view.cloud.emplace();
  cloud.width = 16;
  cloud.height = 12;
  cloud.points.assign(16 * 12, Eigen::Vector3f(nan, nan, nan));
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  for (int v = 2; v < 10; ++v) {
    for (int u = 2; u < 14 - v * narrowing / 4; ++u) {
      const double along_m = 0.01 * (u - 7.5);
      view.object_mask.At(u, v) = kObject;
      cloud.points[static_cast<std::size_t>(16 * v + u)] =
          Eigen::Vector3d(
              x_m + along_m * std::cos(angle_rad), along_m * std::sin(angle_rad), 0.01 * (11 - v))
              .cast<float>();
    }
  }
  return view;
}

/// Writes a view set of two classes ("board", "wedge") at these angles, with three poses shown for
/// each view, approach axis forwards and down.
inline void WriteSmallSet(const std::filesystem::path& root,
                          const std::vector<double>& angles_deg,
                          double x_m = 0.3) {
  for (const char* folder : {"images", "masks", "clouds"}) {
    std::filesystem::create_directories(root / folder);
  }
  ViewSet set{.root = root, .items = {}};
  DemonstrationSet shown{.root = root, .items = {}};
  for (const std::string& name : {std::string("board"), std::string("wedge")}) {
    for (const double angle_deg : angles_deg) {
      const std::string stem = name + std::to_string(static_cast<int>(angle_deg));
      const LoadedView view = SmallView(angle_deg, x_m, name == "board" ? 0 : 3);
      const ObjectView item{.image = "images/" + stem + ".png",
                            .object_mask = "masks/" + stem + ".png",
                            .cloud = "clouds/" + stem + ".pcd",
                            .object_class = name,
                            .instance = name + "_1",
                            .angle_deg = angle_deg,
                            .split = "train"};
      perception::WritePng(root / item.image, view.image);
      perception::WritePng(root / item.object_mask, view.object_mask);
      WritePcd(root / item.cloud, *view.cloud);
      set.items.push_back(item);
      for (int i = 0; i < 3; ++i) {
        shown.items.push_back({.object_class = name,
                               .instance = item.instance,
                               .view = item.image,
                               .angle_deg = angle_deg,
                               .pose = {.position_m = {x_m, 0.02 * i, 0.05 + 0.01 * i},
                                        .rotation = Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0)}});
      }
    }
  }
  WriteViews(set);
  WriteDemonstrations(shown);
}

}  // namespace handcraft::datasets::testing
