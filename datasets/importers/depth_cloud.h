// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include <Eigen/Geometry>

#include "datasets/formats/organised_cloud.h"
#include "lib/core/image.h"

namespace handcraft::datasets {

/// A camera without distortion: what is at (x, y, z) in its optical frame is seen at
/// u = fx · x / z + cx, v = fy · y / z + cy, (0, 0) the middle of the first pixel.
struct Pinhole {
  double fx_px = 0.0;
  double fy_px = 0.0;
  double cx_px = 0.0;
  double cy_px = 0.0;
};

/// The points that depths along the optical axis stand for, in units of `unit_m` [m]; 0 is NaN:
/// nothing was measured.
[[nodiscard]] OrganisedCloud CloudOfDepth(const BasicImage<std::uint16_t>& depth,
                                          double unit_m,
                                          const Pinhole& camera,
                                          const Eigen::Isometry3d& base_from_camera);

}  // namespace handcraft::datasets
