// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/loft.h"
#include "datasets/synthetic/scene.h"

namespace handcraft::synthetic::testing {

/// A slab with its top on z = 0 and a box of 0.1 × 0.1 × 0.1 m on it, the target, whose upper half
/// is graspable, under a light straight above; seen from above by a camera of 160 × 120 pixels.
inline Scene SmallScene() {
  Scene scene;
  Object slab{.mesh = RoundedBox({4.0F, 4.0F, 0.1F}, 0.01F, {}), .materials = {{}}};
  Transform(slab.mesh, Eigen::Isometry3f(Eigen::Translation3f(0.0F, 0.0F, -0.1F)));
  scene.objects.push_back({slab});
  const std::vector<Station> stations = {
      {0.0F, 0.0F, {}}, {0.05F, 0.0F, {0, true}}, {0.1F, 0.0F, {0, true}}};
  scene.objects.push_back(
      {{.mesh = Extrude(RoundedRectangle({0.1F, 0.1F}, 0.002F), stations), .materials = {{}}},
       Eigen::Isometry3f::Identity(),
       true});
  scene.light.centre_m = {0.0F, 0.0F, 2.0F};
  scene.camera = {.width_px = 160,
                  .height_px = 120,
                  .focal_px = 131.25F,
                  .centre_u_px = 79.5F,
                  .centre_v_px = 59.5F,
                  .base_from_camera = LookAt({0.0F, -0.02F, 1.0F}, Eigen::Vector3f::Zero(), 0.0F)};
  return scene;
}

}  // namespace handcraft::synthetic::testing
