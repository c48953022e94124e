// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handcraft::experiments {

/// Where the hand's grasp centre goes.
enum class GraspPosition {
  kGraspPoint,     ///< to p_g, as in the dissertation: a demonstration gives the rotation alone
  kDemonstration,  ///< to where the demonstration had it, brought to the object
};
/// Its name in files: grasp_point, demonstration.
[[nodiscard]] std::string_view NameOf(GraspPosition position) noexcept;

/// The components of grasp planning, one field each: another one is another value.
struct GraspPlanOptions {
  /// p_g: the best pixel of this grasp-point model, or the pixel (u, v) of a click.
  std::filesystem::path grasp_point_model = {};
  std::optional<std::array<int, 2>> grasp_pixel = std::nullopt;
  /// Layer 1: a model of kind object_class, or the class as told.
  std::filesystem::path object_class_model = {};
  std::string object_class = {};
  /// What becomes of an object that the model takes for none of its classes: no plan, or one for
  /// the nearest class.
  bool take_nearest_class = false;
  std::filesystem::path grasp_library = {};  ///< layers 2 and 3
  int num_neighbours = 1;                    ///< demonstrations averaged; 1 to 32
  GraspPosition position = GraspPosition::kDemonstration;
  /// Demonstrations of the class at that angle that are tried, nearest first, until the arm reaches
  /// one; 1 to 64. Those after the first only where their distance from p_g is at most
  /// max_attempt_distance_m (0: any) and the library's own limit.
  int max_attempts = 16;
  double max_attempt_distance_m = 0.0;
  std::filesystem::path robot = {};  ///< robot file of the arm
  /// Whether the arm may be another than that of the demonstrations: other joint names.
  bool any_arm = false;
  /// Joint values that solutions are to be near; empty: the middle of the limits.
  std::vector<double> reference_joints = {};
  /// tip_from_grasp_centre: where the hand's grasp centre is in the arm's tip frame. By default the
  /// Barrett hand on a Barrett arm: 0.235 m from the wrist, whose flange (the tip) is at 0.06 m.
  std::array<double, 3> grasp_centre_m = {0.0, 0.0, 0.175};
  std::array<double, 4> grasp_centre_xyzw = {0.0, 0.0, 0.0, 1.0};

  /// Throws Error(kUsage) naming what is missing, given twice or out of range.
  void Validate() const;
};

/// Reads a plan file; paths in it are relative to its folder:
///
///     [grasp_point]
///     model = "grasp_points.safetensors"     # or: pixel = [320, 240]
///     [object_class]
///     model = "object_class.safetensors"     # or: name = "mug"
///     none_of_these = "refuse"               # optional; or "nearest": plan for the nearest class
///     [grasp_library]
///     model = "grasp_library.safetensors"
///     neighbours = 1                         # optional
///     position = "demonstration"             # optional; or "grasp_point"
///     attempts = 16                          # optional
///     attempt_distance_m = 0.05              # optional
///     [robot]
///     file = "right_arm.toml"
///     any_arm = false                        # optional
///     reference = [0.0, …]                   # optional
///     [hand]                                 # optional
///     grasp_centre_m = [0.0, 0.0, 0.175]
///     grasp_centre_xyzw = [0.0, 0.0, 0.0, 1.0]
///
/// Tables may be missing: what they say may come from elsewhere. Throws Error with path and line
/// for unknown keys and values of another type or range. Does not call Validate().
[[nodiscard]] GraspPlanOptions ReadGraspPlanFile(const std::filesystem::path& path);

}  // namespace handcraft::experiments
