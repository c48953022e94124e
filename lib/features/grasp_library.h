// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/features/grasp_search.h"

namespace handcraft::features {

/// What was shown of several classes of objects: the arrays of a model of kind "grasp_library"
/// (docs/model_format.md § 11), in its order.
struct GraspLibrary {
  RotationRule rule = {};
  std::vector<std::int32_t> view_begins = {};   ///< num_classes + 1, rising: a class's views
  std::vector<double> view_angles_rad = {};     ///< num_views, in [0, 2π)
  std::vector<double> view_normals = {};        ///< num_views × 3, of length 1
  std::vector<double> view_moments = {};        ///< num_views × kNumMoments
  std::vector<double> moment_scales = {};       ///< num_classes × kNumMoments, > 0
  std::vector<std::int32_t> angle_begins = {};  ///< num_classes + 1, rising: a class's shown angles
  std::vector<double> shown_angles_rad = {};    ///< num_angles, in [0, 2π)
  std::vector<double> shown_means_m = {};       ///< num_angles × 3: p_m when the poses were shown
  std::vector<std::int32_t> pose_begins = {};   ///< num_angles + 1, rising: an angle's poses
  std::vector<double> positions_m = {};         ///< num_poses × 3, from p_m; each angle's a tree
  std::vector<double> rotations = {};           ///< num_poses × 4
  std::vector<std::int32_t> numbers = {};       ///< num_poses: which demonstration each is
  std::optional<double> rejection_distance_m = {};  ///< farther ones hold nothing

  [[nodiscard]] std::size_t NumClasses() const noexcept {
    return view_begins.empty() ? 0 : view_begins.size() - 1;
  }
  /// One class's part; the library must outlive it.
  [[nodiscard]] ShownClass Class(std::size_t number) const noexcept;
};

}  // namespace handcraft::features
