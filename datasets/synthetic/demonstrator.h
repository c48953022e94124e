// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "datasets/formats/pose_columns.h"
#include "datasets/synthetic/arm_reach.h"
#include "datasets/synthetic/grasp_sampler.h"

namespace handcraft::synthetic {

/// How a person who shows grasps to a robot is imagined.
struct DemonstratorOptions {
  int num_favourites = 16;         ///< regions and approaches of a view; 1 ... 1000
  float position_sd_m = 0.006F;    ///< scatter about a favourite along each axis; 0 ... 0.1
  float rotation_sd_rad = 0.09F;   ///< and about each axis; 0 ... 1
  float metres_per_radian = 0.1F;  ///< what a turn weighs beside a distance, when favourites are
                                   ///< spread; in (0, 10]
  int num_tries = 2000;            ///< to show one pose, before there is none; 1 ... 10⁶

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// A pose that was shown, in the base frame, and what the hand would hold there.
struct ShownGrasp {
  datasets::EndEffectorPose base_from_grasp;  ///< EndEffectorPose::Rounded
  ContactPlaces contacts;
};

/// An object that stands before an arm.
struct PlacedBeforeArm {
  Eigen::Isometry3f base_from_object = Eigen::Isometry3f::Identity();  ///< turned about z alone
  ArmReach arm_in_base;
};

/// The pose, as it stands in a file, in an object's frame: what is checked of a shown pose.
[[nodiscard]] Eigen::Isometry3f InObject(const datasets::EndEffectorPose& base_from_grasp,
                                         const Eigen::Isometry3f& base_from_object);

/// Shows poses by which an arm can grasp an object where it stands, as a person would who moves the
/// arm by hand (dissertation, section 4.2.1.2).
///
/// Of the grasps within reach a few are favourites: the first one drawn, each further one the
/// farthest from all before (distance of centres + metres_per_radian · angle between the
/// rotations), so that they lie all over the object. Some are liked better: weight −ln(u), u
/// uniform in (0, 1). A pose is a favourite drawn by weight, moved and turned about its own axes by
/// normal scatter, rounded as files keep it, and drawn again until it passes every check of `check`
/// and `arm`.
class Demonstrator {
 public:
  /// Chooses the favourites. The check, of the object, must outlive the demonstrator; `grasps` are
  /// the object's. Same state of the generator, same favourites. Throws Error(kNoResult) when no
  /// grasp is within reach, kUsage for options that break their rules.
  Demonstrator(const GraspCheck& check,
               std::span<const Grasp> grasps,
               const PlacedBeforeArm& place,
               const DemonstratorOptions& options,
               Rng& rng);

  /// One pose. `counts` gains what came of each try. Throws Error(kNoResult) when num_tries gave
  /// none. Same state of the generator, same pose.
  [[nodiscard]] ShownGrasp Show(Rng& rng, GraspCounts& counts) const;

  [[nodiscard]] const std::vector<Grasp>& favourites() const noexcept { return favourites_; }

 private:
  [[nodiscard]] const Grasp& DrawFavourite(Rng& rng) const;

  const GraspCheck* check_;
  PlacedBeforeArm place_;
  ArmReach arm_in_object_;
  DemonstratorOptions options_;
  std::vector<Grasp> favourites_;
  std::vector<double> weight_up_to_;
};

}  // namespace handcraft::synthetic
