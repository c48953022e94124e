// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "datasets/formats/view_set.h"
#include "datasets/synthetic/measured_view.h"
#include "datasets/synthetic/object_classes.h"
#include "datasets/synthetic/robot_table.h"
#include "datasets/synthetic/set_folder.h"
#include "lib/core/progress.h"

namespace handcraft::synthetic {

enum class ViewSetKind {
  kTurntable,  ///< at the origin, turned about z by equal steps from view to view
  kMoved,      ///< in random places, turned and scaled at random
};

/// Its name on the command line and in dataset.toml: turntable, moved.
[[nodiscard]] std::string_view NameOf(ViewSetKind kind);

/// What is made: views of one physical object of each class of the family.
struct ViewSetOptions {
  ViewSetKind kind = ViewSetKind::kTurntable;
  Family family = Family::kTaught;  ///< one whose classes are single objects
  int num_views = 36;               ///< of each class; from 1 to 10000
  CloudSensor sensor = CloudSensor::kStereo;
  CameraNoise camera_noise = {};  ///< between the views
  PinholeCamera camera = {};      ///< its intrinsics; it stands at RobotCameraPose
  float baseline_m = 0.12F;       ///< of the stereo sensors
  std::uint64_t seed = 1;
  int num_threads = 1;  ///< changes no byte
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Raised when the same options give other bytes.
inline constexpr int kViewGeneratorVersion = 1;

/// The folders of a set of views.
inline constexpr std::array<std::string_view, 5> kViewFolders = {
    "images", "object_masks", "clouds", "depth", "scenes"};

/// The physical object that is instance `instance` of a class in every kind of set of this seed:
/// the object of a turntable is the one that is moved and grasped.
[[nodiscard]] Object DrawInstance(const ObjectClass& kind, std::uint64_t seed, int instance);

/// base_from_object on the turntable.
[[nodiscard]] Eigen::Isometry3f TurntablePose(double angle_deg);

/// The lines of dataset.toml that tell the options; `kind` is the first one's value.
[[nodiscard]] std::string ViewSetToToml(std::string_view kind, const ViewSetOptions& options);

struct MadeViews {
  datasets::ViewSet set;
  Written written;
};

/// Renders and measures the views that are not whole (IsWhole) into the folders of `root`, which
/// must be there (PrepareSetFolder), and returns the list of all, which is not written. The split
/// is `train` for the turntable of the taught family, else `test`. Throws Error when it cannot
/// write, and when the camera does not see an object whole.
[[nodiscard]] MadeViews MakeViews(const std::filesystem::path& root, const ViewSetOptions& options);

/// Makes a view set (docs/synthetic_data.md): dataset.toml first and views.csv last, so that a
/// folder without it is one that is not finished. Called again, whether it was stopped or not, it
/// keeps the views that are whole and makes the others (WriteList); the bytes are those of a run
/// that was not stopped. Throws Error as MakeViews and PrepareSetFolder do.
MadeViews MakeViewSet(const std::filesystem::path& out, const ViewSetOptions& options);

}  // namespace handcraft::synthetic
