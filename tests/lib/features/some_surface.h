// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include "lib/core/rng.h"
#include "lib/features/cell_normals.h"

namespace handcraft::testing {

/// Points of a bent sheet and of a board that stands on its edge, with normals that tilt at random.
/// All numbers are floats.
inline std::vector<features::SurfacePoint> SomeSurface(int num_points = 300) {
  Rng rng(7);
  const auto centred = [&rng](double width) { return width * (rng.Uniform() - 0.5); };
  const auto rounded = [](double value) { return static_cast<double>(static_cast<float>(value)); };
  std::vector<features::SurfacePoint> surface;
  for (int i = 0; i < num_points; ++i) {
    const double x = std::floor(centred(1.0) * 1024.0) / 1024.0;
    const double y = std::floor(centred(0.625) * 1024.0) / 1024.0;
    const bool is_sheet = i % 3 != 0;
    features::Vector3 normal = {centred(0.3) + (is_sheet ? 0.6 * x : 0.0),
                                centred(0.3) - (is_sheet ? 0.0 : 1.0),
                                centred(0.3) - (is_sheet ? 1.0 : 0.0)};
    const double length = std::sqrt(features::Dot(normal, normal));
    for (double& value : normal) value = rounded(value / length);
    features::SurfacePoint point{.point_m = {x, y, 0.3 * x * x}, .normal = normal};
    if (!is_sheet) point.point_m = {x, 0.3125, y};
    for (double& value : point.point_m) value = rounded(value);
    surface.push_back(point);
  }
  return surface;
}

}  // namespace handcraft::testing
