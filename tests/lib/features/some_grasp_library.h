// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lib/core/rng.h"
#include "lib/features/grasp_library.h"

namespace handcraft::features::testing {

/// Adds the poses of one more shown angle, numbered on from those there are.
inline void AddShownAngle(GraspLibrary& library,
                          double angle_rad,
                          const std::vector<Vector3>& positions_m,
                          const std::vector<Quaternion>& rotations) {
  library.shown_angles_rad.push_back(angle_rad);
  library.shown_means_m.insert(library.shown_means_m.end(), {0.1, 0.2, 0.3});
  const std::int32_t first = library.pose_begins.back();
  for (const std::size_t i : TreeOrder(positions_m)) {
    library.positions_m.insert(
        library.positions_m.end(), positions_m[i].begin(), positions_m[i].end());
    library.rotations.insert(library.rotations.end(), rotations[i].begin(), rotations[i].end());
    library.numbers.push_back(first + static_cast<std::int32_t>(i));
  }
  library.pose_begins.push_back(first + static_cast<std::int32_t>(positions_m.size()));
}

/// Two classes, seen every 30° and shown every 90°, twenty poses each time; drawn from a fixed
/// seed.
inline GraspLibrary SomeGraspLibrary() {
  constexpr double kDegree = std::numbers::pi / 180.0;
  GraspLibrary library;
  library.view_begins = library.angle_begins = library.pose_begins = {0};
  Rng rng(7);
  for (std::int32_t c = 1; c <= 2; ++c) {
    std::vector<double> moments;
    for (int i = 0; i < 12; ++i) {
      const double angle_rad = 30.0 * i * kDegree;
      library.view_angles_rad.push_back(angle_rad);
      library.view_normals.insert(library.view_normals.end(),
                                  {std::cos(angle_rad), std::sin(angle_rad), 0.0});
      for (std::size_t k = 0; k < kNumMoments; ++k) {
        moments.push_back(k % kMomentsPerHalf == 0 ? 500.0 + 100.0 * rng.Uniform()
                                                   : 0.1 * rng.Normal());
      }
    }
    const HalvesMoments scales = MomentScales(moments);
    library.view_moments.insert(library.view_moments.end(), moments.begin(), moments.end());
    library.moment_scales.insert(library.moment_scales.end(), scales.begin(), scales.end());
    for (int i = 0; i < 4; ++i) {
      std::vector<Vector3> positions;
      std::vector<Quaternion> rotations;
      for (int k = 0; k < 20; ++k) {
        positions.push_back({0.1 * rng.Normal(), 0.1 * rng.Normal(), 0.1 * rng.Normal()});
        rotations.push_back(TurnAboutZ(6.0 * rng.Uniform()));
      }
      AddShownAngle(library, 90.0 * i * kDegree, positions, rotations);
    }
    library.view_begins.push_back(12 * c);
    library.angle_begins.push_back(4 * c);
  }
  library.rejection_distance_m = 0.05;
  return library;
}

}  // namespace handcraft::features::testing
