// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/demonstration_set.h"
#include "datasets/synthetic/demonstrator.h"
#include "datasets/synthetic/view_sets.h"

namespace handcraft::synthetic {

/// How many poses are shown.
enum class PoseQuota {
  kSmall,  ///< 40 a view
  kFull,  ///< of the taught classes as many as in Table 4.1, spread over the views; 333 a view, the
          ///< mean of those, of others
};

/// The most poses a view that can be asked for by their number.
inline constexpr int kMaxPosesPerView = 1000000;

/// What is made: a turntable, and poses shown for each of its views.
struct DemonstrationOptions {
  /// The turntable: family, sensor, seed, threads and so on; its `kind` is not looked at.
  ViewSetOptions views = {.num_views = 12};
  PoseQuota quota = PoseQuota::kSmall;
  int poses_per_view = 0;  ///< instead; 0: as `quota` says; to kMaxPosesPerView
  Gripper gripper = {};
  GraspRules rules = {};
  GraspSamplerOptions sampler = {};
  DemonstratorOptions demonstrator = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// What became of the poses of one class.
struct ClassReport {
  std::string object_class;
  std::size_t num_poses = 0;
  GraspCounts sampled;         ///< poses looked at all over the object
  GraspCounts shown;           ///< tries to show one
  float least_width_m = 0.0F;  ///< between the contacts
  float mean_width_m = 0.0F;
  float greatest_width_m = 0.0F;
};

/// Poses of a class to show in one of its views: an even share of all, the first views one more.
[[nodiscard]] int NumPoses(const ObjectClass& kind, int view, const DemonstrationOptions& options);

struct MadeDemonstrations {
  datasets::DemonstrationSet set;
  std::vector<ClassReport> reports;
  std::size_t num_views = 0;
  Written written;
};

/// Makes a demonstration set (docs/synthetic_data.md): a view set of the turntable, and poses of
/// the right hand (RightArm, Demonstrator). The pose of a number depends on seed, class, view and
/// number alone, so a larger set begins, in each view, with the smaller one. dataset.toml comes
/// first, demonstrations.csv last; when called again, whether it was stopped or not, the views that
/// are whole are kept and the poses found again (WriteList); the bytes are those of a run that was
/// not stopped. Throws Error as MakeViews and PrepareSetFolder do, and kNoResult naming class and
/// view when the hand or the arm cannot grasp an object.
[[nodiscard]] MadeDemonstrations MakeDemonstrations(const std::filesystem::path& out,
                                                    const DemonstrationOptions& options);

}  // namespace handcraft::synthetic
