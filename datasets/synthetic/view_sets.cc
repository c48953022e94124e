// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/view_sets.h"

#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "datasets/synthetic/scene_files.h"
#include "datasets/synthetic/scene_parts.h"
#include "datasets/synthetic/set_folder.h"
#include "datasets/synthetic/set_lists.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxViews = 10000;

// One view to make.
struct Plan {
  const ObjectClass* kind = nullptr;
  int number = 0;  // within its class
  std::string name;
  double angle_deg = 0.0;

  [[nodiscard]] std::string Path(std::string_view folder, std::string_view ending) const {
    return ScenePath(folder, name, ending);
  }
};

bool HasPair(CloudSensor sensor) {
  return sensor != CloudSensor::kDepthCamera && sensor != CloudSensor::kPerfect;
}

// A stream of the view's own.
Rng StreamOf(const Plan& plan, const ViewSetOptions& options, std::string_view what) {
  return Rng::Stream(options.seed,
                     fmt::format("{} {} {}", plan.kind->name, NameOf(options.kind), what),
                     static_cast<std::uint64_t>(plan.number));
}

PinholeCamera CameraOf(const Plan& plan, const ViewSetOptions& options) {
  PinholeCamera camera = options.camera;
  Rng rng = StreamOf(plan, options, "camera");
  camera.base_from_camera = DrawNear(RobotCameraPose(), options.camera_noise, rng);
  return camera;
}

MovedObject Place(const Plan& plan, const Object& object, const ViewSetOptions& options) {
  const PinholeCamera camera = CameraOf(plan, options);
  if (options.kind == ViewSetKind::kMoved) {
    Rng rng = StreamOf(plan, options, "place");
    return DrawMoved(object, camera, rng);
  }
  MovedObject placed{.object = object};
  placed.angle_deg = 360.0 * plan.number / options.num_views;
  placed.base_from_object = TurntablePose(placed.angle_deg);
  if (!IsSeenWhole(object.mesh, placed.base_from_object, camera)) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("the camera does not see the {} whole", plan.kind->name),
                 .remedy = "give a camera with a wider view, or less noise"});
  }
  return placed;
}

std::vector<Plan> MakePlans(const ViewSetOptions& options) {
  std::vector<Plan> plans;
  for (const ObjectClass& kind : ClassesOf(options.family)) {
    for (int number = 0; number < options.num_views; ++number) {
      plans.push_back({&kind, number, fmt::format("{}_0000_{:02}", kind.name, number)});
    }
  }
  return plans;
}

datasets::ObjectView Describe(const Plan& plan, const ViewSetOptions& options) {
  const bool is_training =
      options.kind == ViewSetKind::kTurntable && options.family == Family::kTaught;
  return {.image = plan.Path("images", ".png"),
          .object_mask = plan.Path("object_masks", ".png"),
          .cloud = plan.Path("clouds", ".pcd"),
          .object_class = std::string(plan.kind->name),
          .instance = fmt::format("{}_0000", plan.kind->name),
          .angle_deg = plan.angle_deg,
          .split = is_training ? "train" : "test",
          .licence = std::string(kSyntheticLicence),
          .depth = plan.Path("depth", ".png"),
          .scene = plan.Path("scenes", ".toml"),
          .symmetry = std::string(NameOf(plan.kind->symmetry))};
}

// The room is that of the class: views of an object are taken in one session.
Scene BuildScene(const Plan& plan, MovedObject placed, const ViewSetOptions& options) {
  Rng room =
      Rng::Stream(options.seed, fmt::format("{} {} room", plan.kind->name, NameOf(options.kind)));
  Scene scene = DrawRobotTable(options.camera, room);
  scene.camera = CameraOf(plan, options);
  scene.objects.push_back({std::move(placed.object), placed.base_from_object, true});
  return scene;
}

SceneFiles MakeView(const Plan& plan, MovedObject placed, const ViewSetOptions& options) {
  const std::string place =
      fmt::format("angle_deg = {}\nscale = {}\n", placed.angle_deg, placed.scale);
  const Scene scene = BuildScene(plan, std::move(placed), options);
  const std::string stream = fmt::format("{} {}", NameOf(options.kind), plan.name);
  MeasuredView taken = MeasureView(scene, options.sensor, options.baseline_m, options.seed, stream);
  return {.image = std::move(taken.image),
          .object_mask = std::move(taken.view.object_mask),
          .cloud = std::move(taken.cloud),
          .depth = std::move(taken.view.depth),
          .scene = place + SceneToToml(plan.kind->name, 0, scene)};
}

// Tells the plan by how much the object is turned, too.
bool WriteView(Plan& plan, const fs::path& root, const ViewSetOptions& options) {
  MovedObject placed = Place(plan, DrawInstance(*plan.kind, options.seed, 0), options);
  plan.angle_deg = placed.angle_deg;
  return WriteUnlessWhole(
      root, plan.name, [&] { return MakeView(plan, std::move(placed), options); });
}

}  // namespace

std::string_view NameOf(ViewSetKind kind) {
  return kind == ViewSetKind::kTurntable ? "turntable" : "moved";
}

void ViewSetOptions::Validate() const {
  if (family == Family::kTrained || family == Family::kNovel) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "ViewSetOptions.family is " + std::string(NameOf(family)) +
                           "; it must be taught, untaught or regrasp"});
  }
  RequireOption(num_views >= 1 && num_views <= kMaxViews,
                "ViewSetOptions.num_views",
                num_views,
                fmt::format("from 1 to {}", kMaxViews));
  RequireOption(camera_noise.position_m >= 0.0F && camera_noise.position_m <= 0.05F,
                "CameraNoise.position_m",
                camera_noise.position_m,
                "from 0 to 0.05");
  RequireOption(camera_noise.angle_deg >= 0.0F && camera_noise.angle_deg <= 5.0F,
                "CameraNoise.angle_deg",
                camera_noise.angle_deg,
                "from 0 to 5");
  camera.Validate();
  RequireOption(baseline_m > 0.0F && baseline_m <= 1.0F,
                "ViewSetOptions.baseline_m",
                baseline_m,
                "in (0, 1]");
  RequireOption(num_threads >= 1, "ViewSetOptions.num_threads", num_threads, "1 or more");
}

Object DrawInstance(const ObjectClass& kind, std::uint64_t seed, int instance) {
  Rng rng =
      Rng::Stream(seed, std::string(kind.name) + " object", static_cast<std::uint64_t>(instance));
  return kind.draw(rng);
}

Eigen::Isometry3f TurntablePose(double angle_deg) {
  return UprightPose(Eigen::Vector3f::Zero(),
                     static_cast<float>(angle_deg) * std::numbers::pi_v<float> / 180.0F);
}

std::string ViewSetToToml(std::string_view kind, const ViewSetOptions& options) {
  const std::string text = fmt::format(
      "kind = \"{}\"\ngenerator = {}\nfamily = \"{}\"\nsensor = \"{}\"\nseed = {}\nnum_views = {}\n"
      "camera_noise_m = {}\ncamera_noise_deg = {}\n",
      kind,
      kViewGeneratorVersion,
      NameOf(options.family),
      NameOf(options.sensor),
      options.seed,
      options.num_views,
      options.camera_noise.position_m,
      options.camera_noise.angle_deg);
  return text +
         CameraToToml(options.camera,
                      HasPair(options.sensor) ? std::optional(options.baseline_m) : std::nullopt);
}

MadeViews MakeViews(const fs::path& root, const ViewSetOptions& options) {
  options.Validate();
  std::vector<Plan> plans = MakePlans(options);
  MadeViews made{.set = {.root = root, .items = {}}, .written = {}};
  made.written.num_pictures = CountWritten(
      plans.size(), options.num_threads, options.progress, "rendering views", [&](std::size_t i) {
        return WriteView(plans[i], root, options);
      });
  for (const Plan& plan : plans) made.set.items.push_back(Describe(plan, options));
  return made;
}

MadeViews MakeViewSet(const fs::path& out, const ViewSetOptions& options) {
  options.Validate();
  PrepareSetFolder(out, ViewSetToToml(NameOf(options.kind), options), kViewFolders);
  MadeViews made = MakeViews(out, options);
  WriteList(made.set, made.written);
  return made;
}

}  // namespace handcraft::synthetic
