// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/synthetic/view_sets.h"
#include "experiments/runner/setting.h"
#include "experiments/runner/study_entries.h"
#include "experiments/view_studies/view_settings.h"

namespace handcraft::experiments {

/// What is asked of every view.
enum class ViewTask : std::uint8_t {
  kObjectClass,     ///< which object it shows (dissertation, section 4.3.1)
  kObjectRotation,  ///< how the object, whose class is known, is turned (section 4.3.2)
  /// How the hand is held, of a known object and angle: one demonstration from the others
  /// (section 4.2.4). `train` is a demonstration set.
  kNearestDemonstration,
  /// From picture and cloud to joint values, and how long each layer takes (Table 4.5). Needs
  /// `demonstrations`.
  kGraspPlan,
  /// As kGraspPlan, and whether the hand would hold the true object at the pose that was planned
  /// (Figures 4.8 to 4.10). Views are made ones.
  kGraspSuccess,
};
[[nodiscard]] std::string_view NameOf(ViewTask task) noexcept;

/// Whether a grasp is planned for every view.
[[nodiscard]] bool IsOfPlans(ViewTask task) noexcept;

/// Where views come from: a folder, or made to order.
struct ViewSource {
  std::string folder = {};  ///< view set; empty: made
  std::string split = {};   ///< of the folder's views those of this split; empty: all
  /// Families of made objects whose classes are taken together.
  std::vector<synthetic::Family> families = {};
  synthetic::ViewSetKind kind = synthetic::ViewSetKind::kTurntable;
  synthetic::CloudSensor sensor = synthetic::CloudSensor::kStereo;
  int num_views = 36;  ///< of each object
  /// Poses shown for each view, which make it a demonstration set of one family; 0: views alone.
  int num_poses = 0;
  int num_sets = 1;        ///< each with other objects, whose classes are counted apart
  std::uint64_t seed = 1;  ///< of the first set; the next has the next
};

/// A study of what views of objects tell (docs/studies.md).
struct ViewStudy {
  std::string name;
  std::string title;
  std::string question = {};
  ViewTask task = ViewTask::kObjectClass;
  ViewSource train;
  /// None: each view of `train` in turn is left out and asked about.
  std::optional<ViewSource> test = {};
  std::optional<ViewSource> demonstrations = {};  ///< demonstration set, of plans
  /// Of a class of `test` the classes of `train` that are right for it, or kNoneOfThese; one that
  /// is not named is right as itself.
  std::map<std::string, std::vector<std::string>> associations = {};
  /// Groups of classes that are asked about, counted together beside "all".
  std::map<std::string, std::vector<std::string>> groups = {};
  std::vector<Setting> settings = {};  ///< of all cells, before their own
  std::vector<Method> methods = {};    ///< at least one
  std::vector<Factor> factors = {};
  std::string claim_source = {};              ///< "Table 4.2"
  std::map<std::string, double> claims = {};  ///< percent right that a publication has, by group
  std::map<std::string, double> claimed_ms = {};  ///< and times, by the names of ours
};

/// The classes of `train` that are right for a class of `test`: itself, where the study associates
/// none with it.
[[nodiscard]] std::vector<std::string> RightClasses(const ViewStudy& study,
                                                    const std::string& object_class);

/// Whether a study file is one of views: it has the key `task`.
[[nodiscard]] bool IsViewStudy(std::string_view text, const std::string& source);

/// Reads a study file (TOML). Every key must be known and every setting fit its rule. Throws Error
/// with path and line; `source` stands for the path.
[[nodiscard]] ViewStudy ParseViewStudy(std::string_view text,
                                       const std::string& source,
                                       StudySize size);

/// One combination of methods and factors.
struct ViewCell {
  std::string id;  ///< "grid,kernel=poly"
  std::string method;
  std::vector<Setting> factors;
  ViewSettings settings;
};
[[nodiscard]] std::vector<ViewCell> MakeViewCells(const ViewStudy& study);

/// One line an entry that results depend on, "key = value", in a fixed order.
[[nodiscard]] std::vector<std::string> CanonicalLines(const ViewStudy& study);

}  // namespace handcraft::experiments
