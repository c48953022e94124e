// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/synthetic/hold_sampler.h"
#include "datasets/synthetic/measured_view.h"
#include "datasets/synthetic/set_folder.h"
#include "lib/core/progress.h"

namespace handcraft::synthetic {

/// What is made: objects that stand where the right arm alone can grasp them, as the robot sees
/// them, and what it takes to pass them to the left hand.
struct RegraspOptions {
  Family family = Family::kRegrasp;
  int num_configurations = 10;  ///< places and turns of each object; 1 ... 10000
  int poses_per_view = 40;      ///< of the right hand alone; 1 ... 10⁶
  int holds_per_view = 20;      ///< pairs of poses of both hands; 1 ... 10⁶
  CloudSensor sensor = CloudSensor::kStereo;
  float baseline_m = 0.12F;   ///< of the stereo sensors; in (0, 1]
  PinholeCamera camera = {};  ///< its intrinsics; it stands where RobotCameraPose is and looks at
                              ///< the object
  GraspSamplerOptions sampler = {};
  HoldRules rules = {};
  std::uint64_t seed = 1;
  int num_threads = 1;  ///< changes no byte
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// One object in one place.
struct RegraspPlace {
  Eigen::Isometry3f base_from_object = Eigen::Isometry3f::Identity();
  float angle_deg = 0.0F;  ///< about z, in [0, 360)
};

/// Draws places on the robot's right, x from 0.05 to 0.25 m and y from −0.65 to −0.45 m, all
/// equally likely, and turns, until the right arm reaches at least a tenth of the object's grasps
/// and the left one none (the problem of section 5.1). Throws Error(kNoResult) when it has not
/// after 1000 draws. Same state of the generator, same place.
[[nodiscard]] RegraspPlace DrawRegraspPlace(const std::vector<Grasp>& grasps,
                                            const Gripper& gripper,
                                            Rng& rng);

/// The left arm for choosing its pose of a hold: as if the object stood, as it is turned, before
/// the middle of the robot ("as if it was located in both manipulators' reachability spaces",
/// section 5.2.3).
[[nodiscard]] PlacedBeforeArm BeforeLeftArm(const RegraspPlace& place);

struct MadeRegrasps {
  datasets::DemonstrationSet demonstrations;
  datasets::HoldSet holds;
  HoldCounts counts;
  std::size_t num_views = 0;
  Written written;
};

/// Makes a regrasp set (docs/synthetic_data.md): a view set, the right hand's demonstrations and
/// holds of both hands for each view. Everything depends on seed, class, configuration and number
/// alone. dataset.toml comes first, holds.csv last; when called again, whether it was
/// stopped or not, the views that are whole are kept and all else is found again (WriteList); the
/// bytes are those of a run that was not stopped. Throws Error as PrepareSetFolder does, kUsage
/// when the camera does not see an object whole, and kNoResult naming the class when it cannot be
/// grasped or held by both hands.
[[nodiscard]] MadeRegrasps MakeRegraspSet(const std::filesystem::path& out,
                                          const RegraspOptions& options);

}  // namespace handcraft::synthetic
