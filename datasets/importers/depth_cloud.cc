// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/depth_cloud.h"

#include <limits>

namespace handcraft::datasets {

OrganisedCloud CloudOfDepth(const BasicImage<std::uint16_t>& depth,
                            double unit_m,
                            const Pinhole& camera,
                            const Eigen::Isometry3d& base_from_camera) {
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  OrganisedCloud cloud{.width = depth.width(),
                       .height = depth.height(),
                       .base_from_camera = base_from_camera.cast<float>()};
  cloud.points.reserve(depth.values().size());
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      if (depth.At(u, v) == 0) {
        cloud.points.emplace_back(kNothing, kNothing, kNothing);
        continue;
      }
      const double z = depth.At(u, v) * unit_m;
      const Eigen::Vector3d p_in_camera(
          (u - camera.cx_px) / camera.fx_px * z, (v - camera.cy_px) / camera.fy_px * z, z);
      cloud.points.push_back((base_from_camera * p_in_camera).cast<float>());
    }
  }
  return cloud;
}

}  // namespace handcraft::datasets
