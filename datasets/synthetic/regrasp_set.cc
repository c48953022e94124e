// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/regrasp_set.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "datasets/formats/view_set.h"
#include "datasets/parallel_reporting.h"
#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/robot_table.h"
#include "datasets/synthetic/scene_files.h"
#include "datasets/synthetic/set_folder.h"
#include "datasets/synthetic/set_lists.h"
#include "datasets/synthetic/view_sets.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using Eigen::Isometry3f;
using Eigen::Vector3f;

constexpr int kGeneratorVersion = 1;  // raised when the same options give other bytes
constexpr int kMaxConfigurations = 10000;
constexpr int kMaxPoses = 1000000;
constexpr int kMaxDraws = 1000;

// A class's object and where a hand can hold it.
struct Subject {
  Subject(const ObjectClass& which, const RegraspOptions& options)
      : kind(&which), object(DrawInstance(which, options.seed, 0)), check(object.mesh, {}, {}) {
    Rng rng = Rng::Stream(options.seed, std::string(which.name) + " grasps");
    GraspCounts counts;
    grasps = SampleGrasps(check, options.sampler, rng, counts);
    RequireGrasps(grasps, which.name, counts);
  }

  const ObjectClass* kind;
  Object object;
  GraspCheck check;
  std::vector<Grasp> grasps;
};

Rng StreamOf(const ObjectClass& kind,
             std::string_view what,
             int number,
             const RegraspOptions& options) {
  return Rng::Stream(options.seed,
                     fmt::format("{} regrasp {}", kind.name, what),
                     static_cast<std::uint64_t>(number));
}

// One object in one place, and all that is made of it.
struct Configuration {
  const ObjectClass* kind = nullptr;
  std::string name;
  RegraspPlace place;
  std::vector<datasets::Demonstration> demonstrations;
  std::vector<datasets::Hold> holds;
  HoldCounts counts;
};

datasets::ObjectView Describe(const Configuration& made) {
  return {.image = ScenePath("images", made.name, ".png"),
          .object_mask = ScenePath("object_masks", made.name, ".png"),
          .cloud = ScenePath("clouds", made.name, ".pcd"),
          .object_class = std::string(made.kind->name),
          .instance = fmt::format("{}_0000", made.kind->name),
          .angle_deg = static_cast<double>(made.place.angle_deg),
          .split = "test",
          .licence = std::string(kSyntheticLicence),
          .depth = ScenePath("depth", made.name, ".png"),
          .scene = ScenePath("scenes", made.name, ".toml"),
          .symmetry = std::string(NameOf(made.kind->symmetry))};
}

void AddPoses(const Subject& subject,
              int number,
              const RegraspOptions& options,
              Configuration& made) {
  const auto stream = [&](std::string_view what, int i) {
    return StreamOf(*subject.kind, fmt::format("{} {}", what, number), i, options);
  };
  Rng favourites = stream("favourites", 0);
  const PlacedBeforeArm before_right{.base_from_object = made.place.base_from_object,
                                     .arm_in_base = RightArm()};
  const Demonstrator right(subject.check, subject.grasps, before_right, {}, favourites);
  const Demonstrator left(subject.check, subject.grasps, BeforeLeftArm(made.place), {}, favourites);
  const datasets::ObjectView view = Describe(made);
  for (int i = 0; i < options.poses_per_view; ++i) {
    Rng rng = stream("shown", i);
    made.demonstrations.push_back({.object_class = view.object_class,
                                   .instance = view.instance,
                                   .view = view.image,
                                   .angle_deg = view.angle_deg,
                                   .pose = right.Show(rng, made.counts.poses).base_from_grasp});
  }
  for (int i = 0; i < options.holds_per_view; ++i) {
    Rng rng = stream("holds", i);
    const ShownHold hold =
        DrawHold(right, left, subject.check.gripper(), options.rules, rng, made.counts);
    made.holds.push_back({.object_class = view.object_class,
                          .instance = view.instance,
                          .view = view.image,
                          .right = hold.right.base_from_grasp,
                          .left = hold.left.base_from_grasp});
  }
}

Configuration MakeConfiguration(const Subject& subject, int number, const RegraspOptions& options) {
  Configuration made{.kind = subject.kind,
                     .name = fmt::format("{}_0000_{:02}", subject.kind->name, number),
                     .place = {},
                     .demonstrations = {},
                     .holds = {},
                     .counts = {}};
  try {
    Rng rng = StreamOf(*subject.kind, "place", number, options);
    made.place = DrawRegraspPlace(subject.grasps, subject.check.gripper(), rng);
    AddPoses(subject, number, options, made);
  } catch (const Error& error) {
    throw Error({.kind = error.details().kind,
                 .reason = made.name + ": " + error.details().reason,
                 .remedy = error.details().remedy});
  }
  return made;
}

SceneFiles MakeView(const Configuration& made, const RegraspOptions& options) {
  const Object object = DrawInstance(*made.kind, options.seed, 0);
  Rng room = StreamOf(*made.kind, "room", 0, options);
  Scene scene = DrawRobotTable(options.camera, room);
  const Vector3f middle_m = made.place.base_from_object * Bounds(object.mesh).center();
  scene.camera.base_from_camera = LookAt(RobotCameraPose().translation(), middle_m, 0.0F);
  if (!IsSeenWhole(object.mesh, made.place.base_from_object, scene.camera)) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("the camera does not see the {} whole", made.kind->name),
                 .remedy = "give a camera with a wider view"});
  }
  scene.objects.push_back({object, made.place.base_from_object, true});
  MeasuredView taken =
      MeasureView(scene, options.sensor, options.baseline_m, options.seed, "regrasp " + made.name);
  return {.image = std::move(taken.image),
          .object_mask = std::move(taken.view.object_mask),
          .cloud = std::move(taken.cloud),
          .depth = std::move(taken.view.depth),
          .scene = fmt::format("angle_deg = {}\n", made.place.angle_deg) +
                   SceneToToml(made.kind->name, 0, scene)};
}

// Each class's places, poses and holds, class after class.
std::vector<Configuration> MakeConfigurations(const RegraspOptions& options) {
  const std::span<const ObjectClass> classes = ClassesOf(options.family);
  std::vector<std::vector<Configuration>> by_class(classes.size());
  datasets::ParallelForReporting(
      classes.size(), options.num_threads, options.progress, "finding holds", [&](std::size_t i) {
        const Subject subject(classes[i], options);
        for (int number = 0; number < options.num_configurations; ++number) {
          by_class[i].push_back(MakeConfiguration(subject, number, options));
        }
      });
  std::vector<Configuration> all;
  for (std::vector<Configuration>& of_class : by_class) {
    std::move(of_class.begin(), of_class.end(), std::back_inserter(all));
  }
  return all;
}

std::string ToToml(const RegraspOptions& options) {
  const bool has_pair =
      options.sensor != CloudSensor::kDepthCamera && options.sensor != CloudSensor::kPerfect;
  return fmt::format(
             "kind = \"regrasp\"\ngenerator = {}\nfamily = \"{}\"\nsensor = \"{}\"\nseed = {}\n"
             "num_configurations = {}\nposes_per_view = {}\nholds_per_view = {}\n",
             kGeneratorVersion,
             NameOf(options.family),
             NameOf(options.sensor),
             options.seed,
             options.num_configurations,
             options.poses_per_view,
             options.holds_per_view) +
         CameraToToml(options.camera, has_pair ? std::optional(options.baseline_m) : std::nullopt);
}

}  // namespace

void RegraspOptions::Validate() const {
  if (family == Family::kTrained || family == Family::kNovel) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "RegraspOptions.family is " + std::string(NameOf(family)) +
                           "; it must be taught, untaught or regrasp"});
  }
  RequireOption(num_configurations >= 1 && num_configurations <= kMaxConfigurations,
                "RegraspOptions.num_configurations",
                num_configurations,
                fmt::format("from 1 to {}", kMaxConfigurations));
  RequireOption(poses_per_view >= 1 && poses_per_view <= kMaxPoses,
                "RegraspOptions.poses_per_view",
                poses_per_view,
                fmt::format("from 1 to {}", kMaxPoses));
  RequireOption(holds_per_view >= 1 && holds_per_view <= kMaxPoses,
                "RegraspOptions.holds_per_view",
                holds_per_view,
                fmt::format("from 1 to {}", kMaxPoses));
  RequireOption(baseline_m > 0.0F && baseline_m <= 1.0F,
                "RegraspOptions.baseline_m",
                baseline_m,
                "in (0, 1]");
  RequireOption(num_threads >= 1, "RegraspOptions.num_threads", num_threads, "1 or more");
  camera.Validate();
  sampler.Validate();
  rules.Validate();
}

RegraspPlace DrawRegraspPlace(const std::vector<Grasp>& grasps, const Gripper& gripper, Rng& rng) {
  for (int draws = 0; draws < kMaxDraws; ++draws) {
    const Vector3f at_m(Between(rng, 0.05F, 0.25F), Between(rng, -0.65F, -0.45F), 0.0F);
    RegraspPlace place{.angle_deg = Between(rng, 0.0F, 359.99F)};
    place.base_from_object = Eigen::Translation3f(at_m) * TurntablePose(place.angle_deg);
    const Isometry3f object_from_base = place.base_from_object.inverse();
    const ArmReach right = RightArm().In(object_from_base);
    const ArmReach left = LeftArm().In(object_from_base);
    const auto reaches = [&](const ArmReach& arm) {
      return std::count_if(grasps.begin(), grasps.end(), [&](const Grasp& grasp) {
        return arm.Check(grasp.object_from_grasp, gripper) == GraspFault::kNone;
      });
    };
    if (reaches(left) > 0) continue;
    if (10 * reaches(right) >= static_cast<std::ptrdiff_t>(grasps.size())) return place;
  }
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "no place where the right arm alone reaches the object in " +
                         std::to_string(kMaxDraws) + " draws"});
}

PlacedBeforeArm BeforeLeftArm(const RegraspPlace& place) {
  PlacedBeforeArm before{.base_from_object = place.base_from_object, .arm_in_base = LeftArm()};
  before.arm_in_base.shoulder_m.y() += place.base_from_object.translation().y();
  return before;
}

MadeRegrasps MakeRegraspSet(const fs::path& out, const RegraspOptions& options) {
  options.Validate();
  PrepareSetFolder(out, ToToml(options), kViewFolders);
  const std::vector<Configuration> all = MakeConfigurations(options);
  datasets::ViewSet views{.root = out, .items = {}};
  MadeRegrasps made{.demonstrations = {.root = out, .items = {}},
                    .holds = {.root = out, .items = {}},
                    .counts = {},
                    .num_views = all.size(),
                    .written = {}};
  made.written.num_pictures = CountWritten(
      all.size(), options.num_threads, options.progress, "rendering views", [&](std::size_t i) {
        return WriteUnlessWhole(out, all[i].name, [&] { return MakeView(all[i], options); });
      });
  for (const Configuration& one : all) {
    views.items.push_back(Describe(one));
    std::copy(one.demonstrations.begin(),
              one.demonstrations.end(),
              std::back_inserter(made.demonstrations.items));
    std::copy(one.holds.begin(), one.holds.end(), std::back_inserter(made.holds.items));
    made.counts.Add(one.counts);
  }
  WriteList(views, made.written);
  WriteList(made.demonstrations, made.written);
  WriteList(made.holds, made.written);
  return made;
}

}  // namespace handcraft::synthetic
