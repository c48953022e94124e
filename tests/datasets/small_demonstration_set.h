// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/view_set.h"
#include "datasets/synthetic/camera.h"
#include "lib/perception/image_io.h"

namespace handcraft::testing {

/// Half a metre above the table, looking straight down: x of the base goes up in the picture.
inline synthetic::PinholeCamera FromAbove() {
  synthetic::PinholeCamera camera{.width_px = 80,
                                  .height_px = 60,
                                  .focal_px = 100.0F,
                                  .centre_u_px = 39.5F,
                                  .centre_v_px = 29.5F};
  camera.base_from_camera.linear() << 0, -1, 0, -1, 0, 0, 0, 0, -1;
  camera.base_from_camera.translation() = Eigen::Vector3f(0.0F, 0.0F, 0.5F);
  return camera;
}

/// A hand that comes from below: its stem hangs below the grasp centre.
inline datasets::EndEffectorPose Reaching(const Eigen::Vector3d& at_m) {
  datasets::EndEffectorPose pose;
  pose.position_m = at_m;
  return pose;
}

/// Gray views of 80 × 60 below `root`, which must exist, with views.csv: a square in the middle is
/// the object, the cloud is flat.
inline datasets::ObjectView AddGrayView(const std::filesystem::path& root,
                                        const std::string& name) {
  const synthetic::PinholeCamera camera = FromAbove();
  datasets::OrganisedCloud cloud{.width = camera.width_px, .height = camera.height_px};
  cloud.base_from_camera = camera.base_from_camera;
  Image mask(camera.width_px, camera.height_px);
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      const Eigen::Vector3f ray = camera.Ray(static_cast<float>(u), static_cast<float>(v));
      cloud.points.push_back(camera.Origin() + 0.5F * ray);
      if (std::abs(u - 40) < 8 && std::abs(v - 30) < 8) mask.At(u, v) = datasets::kObject;
    }
  }
  datasets::WritePcd(root / (name + ".pcd"), cloud);
  perception::WritePng(root / (name + "_mask.png"), mask);
  perception::WritePng(root / (name + ".png"), Image(camera.width_px, camera.height_px, 1, 100));
  return {.image = name + ".png",
          .object_mask = name + "_mask.png",
          .cloud = name + ".pcd",
          .object_class = name.substr(0, 3),
          .instance = name.substr(0, 3),
          .split = "train"};
}

/// Two such views of a mug and one of a can, with a pose shown in each.
inline datasets::DemonstrationSet MakeDemonstrationSet(const std::filesystem::path& root) {
  datasets::ViewSet views{.root = root, .items = {}};
  datasets::DemonstrationSet poses{.root = root, .items = {}};
  for (const char* name : {"mug_0", "mug_1", "can_0"}) {
    views.items.push_back(AddGrayView(root, name));
    const datasets::ObjectView& view = views.items.back();
    poses.items.push_back({.object_class = view.object_class,
                           .instance = view.instance,
                           .view = view.image,
                           .angle_deg = {},
                           .pose = Reaching({0.0, 0.0, 0.1})});
  }
  datasets::WriteViews(views);
  datasets::WriteDemonstrations(poses);
  return poses;
}

}  // namespace handcraft::testing
