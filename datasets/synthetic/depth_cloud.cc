// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/depth_cloud.h"

#include <cmath>
#include <limits>

#include "lib/core/check.h"

namespace handcraft::synthetic {

datasets::OrganisedCloud CloudFromDepth(const FloatImage& depth_m, const PinholeCamera& camera) {
  HC_CHECK(depth_m.width() == camera.width_px && depth_m.height() == camera.height_px,
           depth_m.width(),
           depth_m.height());
  datasets::OrganisedCloud cloud{.width = camera.width_px,
                                 .height = camera.height_px,
                                 .base_from_camera = camera.base_from_camera};
  cloud.points.assign(depth_m.values().size(),
                      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  std::size_t i = 0;
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u, ++i) {
      const float depth = depth_m.At(u, v);
      if (!(depth > 0.0F) || !std::isfinite(depth)) continue;
      cloud.points[i] =
          camera.Origin() + depth * camera.Ray(static_cast<float>(u), static_cast<float>(v));
    }
  }
  return cloud;
}

}  // namespace handcraft::synthetic
