// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/features/grasp_library.h"

namespace handcraft::grasp_library {

/// An object of a class, seen at an angle.
struct SeenView {
  std::size_t object_class = 0;
  double angle_rad = 0.0;  ///< about z; any number of turns
  features::ViewDescription description = {};
};

/// A pose of the hand that was shown for such an object.
struct ShownPose {
  std::size_t object_class = 0;
  double angle_rad = 0.0;         ///< of the object in the view it was shown in
  features::Vector3 mean_m = {};  ///< p_m of the object's cloud in that view
  features::Vector3 position_m = {};
  features::Quaternion rotation = {};  ///< length 1 within 1e-3; scaled to 1
  std::int32_t number = 0;             ///< which demonstration this is
};

/// Classes, what was seen of them and what was shown.
struct TrainingSet {
  std::vector<std::string> classes = {};
  std::vector<SeenView> views = {};
  std::vector<ShownPose> poses = {};
};

struct Options {
  features::ComparedMoments compared_moments = features::RotationRule{}.moments;
  int num_candidates = 0;             ///< nearest by plane that are compared, to 64; 0: all
  double angle_weight = 1.0;          ///< of the angle between planes [1/rad]; 0 to 1e6
  double rejection_distance_m = 0.0;  ///< farther from any demonstration is rejected; 0: never

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("compared_moments", features::NameOf(compared_moments));
    visit("num_candidates", num_candidates);
    visit("angle_weight", angle_weight);
    visit("rejection_distance_m", rejection_distance_m);
  }
};

/// Orders views and poses by class, and the poses by angle (rising) into k-d trees, positions from
/// p_m. Nothing is estimated but the spread of moments (features::MomentScales). The same set gives
/// the same library. Throws Error(kBadInput) for no class, and for a class without a view or
/// without a pose, naming it; std::logic_error for a class number out of range.
/// Source: dissertation sections 4.2.1.2, 4.2.3 and 4.2.4.
[[nodiscard]] features::GraspLibrary TrainGraspLibrary(const TrainingSet& set,
                                                       const Options& options = {});

}  // namespace handcraft::grasp_library
