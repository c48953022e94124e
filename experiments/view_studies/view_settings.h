// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "experiments/grasp_planning/grasp_plan_options.h"
#include "experiments/object_classes/object_class_training.h"
#include "experiments/runner/setting.h"
#include "lib/features/object_rotation.h"

namespace handcraft::experiments {

/// What is not there when a demonstration is looked for among the others of its class.
enum class HeldOutPart : std::uint8_t {
  kDemonstration,  ///< it alone: the others of its view are asked
  kView,           ///< all of its view: those of the view nearest by angle are asked
};
[[nodiscard]] std::string_view NameOf(HeldOutPart part) noexcept;

/// Which answers of layer 1 are taken back: "none of these".
enum class ClassRejection : std::uint8_t {
  kNone,
  /// Those whose margin is below the threshold that svm::CalibrateRejection finds on the views of
  /// all other classes asked about, novel those for which "none of these" is right: no class is
  /// judged by a threshold that it helped to set.
  kCalibrated,
};
[[nodiscard]] std::string_view NameOf(ClassRejection rejection) noexcept;

/// Where to grasp, when no model tells it.
enum class GraspClick : std::uint8_t {
  kPicture,  ///< the middle of the picture, where a turntable has its object
  kObject,   ///< the middle of the object's pixels
};
[[nodiscard]] std::string_view NameOf(GraspClick click) noexcept;

/// Layer 3, and the plans that end with it.
struct GraspSettings {
  std::size_t num_neighbours = 1;  ///< demonstrations averaged
  double max_distance_m = 0.0;     ///< a nearest one that is farther is rejected; 0: none is
  HeldOutPart held_out = HeldOutPart::kDemonstration;
  int max_attempts = 16;  ///< demonstrations tried until the arm reaches one
  std::string robot = "models/robots/dual_wam/right_arm.toml";  ///< robot file of the arm
  std::string grasp_points = {};  ///< model that tells where to grasp; empty: a click
  GraspClick click = GraspClick::kPicture;
  bool is_class_told = false;  ///< the right class, in place of the classifier's
  GraspPosition position = GraspPosition::kGraspPoint;  ///< where the hand's grasp centre goes
};

/// What a cell of a study of views does: how it describes a cloud, how it tells classes apart, how
/// it finds the most similar view and the nearest demonstrations.
struct ViewSettings {
  ObjectClassOptions classes = {};
  ClassRejection rejection = ClassRejection::kNone;
  features::RotationRule rotation = {};
  GraspSettings grasps = {};
  std::size_t num_classes = 0;  ///< the first ones alone; 0: all
};

/// The keys of settings, in the order in which cells are told apart by them.
[[nodiscard]] std::span<const std::string_view> ViewSettingKeys();

/// Reads one setting into `settings`. Throws Error(kUsage) that names key, value and rule for a key
/// that is none and a value that does not fit it.
void ApplyViewSetting(const Setting& setting, ViewSettings& settings);

}  // namespace handcraft::experiments
