// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_point_set.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "datasets/parallel_reporting.h"
#include "datasets/synthetic/renderer.h"
#include "datasets/synthetic/scene.h"
#include "datasets/synthetic/scene_files.h"
#include "datasets/synthetic/sensor.h"
#include "datasets/synthetic/set_folder.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr int kGeneratorVersion = 1;  // raised when the same options give other bytes
constexpr int kImagesPerInstance = 4;
constexpr int kInstancesPerTestInstance = 3;
constexpr int kSmallImagesPerClass = 24;
constexpr int kMaxImages = 1000000;
constexpr std::array<std::string_view, 5> kFolders = {
    "images", "masks", "object_masks", "depth", "scenes"};

// One picture to make.
struct Plan {
  const ObjectClass* kind = nullptr;
  int number = 0;    // within its class
  int instance = 0;  // within its class
  std::string name;

  [[nodiscard]] std::string Path(std::string_view folder, std::string_view ending) const {
    return ScenePath(folder, name, ending);
  }
};

int NumImages(const ObjectClass& kind, std::size_t index, const GraspPointSetOptions& options) {
  const auto num_classes = static_cast<int>(ClassesOf(options.family).size());
  if (options.num_images > 0) {
    const int left_over = options.num_images % num_classes;
    return options.num_images / num_classes + (static_cast<int>(index) < left_over ? 1 : 0);
  }
  return options.size == SetSize::kSmall ? kSmallImagesPerClass : kind.num_images_full;
}

std::vector<Plan> MakePlans(const GraspPointSetOptions& options) {
  std::vector<Plan> plans;
  const std::span<const ObjectClass> classes = ClassesOf(options.family);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    for (int number = 0; number < NumImages(classes[i], i, options); ++number) {
      const int instance = number / kImagesPerInstance;
      plans.push_back(
          {&classes[i],
           number,
           instance,
           fmt::format("{}_{:04}_{}", classes[i].name, instance, number % kImagesPerInstance)});
    }
  }
  return plans;
}

datasets::LabelledImage Describe(const Plan& plan, bool with_right) {
  const bool is_test = plan.kind->family == Family::kNovel ||
                       plan.kind->family == Family::kUntaught ||
                       plan.instance % kInstancesPerTestInstance == kInstancesPerTestInstance - 1;
  datasets::LabelledImage item{.image = plan.Path("images", ".png"),
                               .mask = plan.Path("masks", ".png"),
                               .object_class = std::string(plan.kind->name),
                               .instance = fmt::format("{}_{:04}", plan.kind->name, plan.instance),
                               .split = is_test ? "test" : "train",
                               .licence = std::string(kSyntheticLicence)};
  item.others.emplace(datasets::kObjectMask, plan.Path("object_masks", ".png"));
  item.others.emplace(datasets::kDepth, plan.Path("depth", ".png"));
  item.others.emplace(datasets::kScene, plan.Path("scenes", ".toml"));
  if (with_right) item.others.emplace(datasets::kRightImage, plan.Path("images", "_right.png"));
  return item;
}

std::string ParametersToToml(const GraspPointSetOptions& options, std::size_t num_images) {
  const std::string text = fmt::format(
      "kind = \"grasp-points\"\ngenerator = {}\nfamily = \"{}\"\nseed = {}\nnum_images = {}\n",
      kGeneratorVersion,
      NameOf(options.family),
      options.seed,
      num_images);
  return text + CameraToToml(options.camera,
                             options.with_right ? std::optional(options.baseline_m) : std::nullopt);
}

Scene DrawPlanned(const Plan& plan, const GraspPointSetOptions& options) {
  const std::uint64_t seed = options.seed;
  const std::string name(plan.kind->name);
  Rng object_stream =
      Rng::Stream(seed, name + " object", static_cast<std::uint64_t>(plan.instance));
  std::vector<Object> targets;
  targets.reserve(static_cast<std::size_t>(plan.kind->num_objects));
  for (int i = 0; i < plan.kind->num_objects; ++i)
    targets.push_back(plan.kind->draw(object_stream));
  Rng scene_stream = Rng::Stream(seed, name + " scene", static_cast<std::uint64_t>(plan.number));
  Scene scene = DrawScene(targets, scene_stream);
  const Eigen::Isometry3f base_from_camera = scene.camera.base_from_camera;
  scene.camera = options.camera;
  scene.camera.base_from_camera = base_from_camera;
  return scene;
}

Image DevelopPlanned(const Plan& plan,
                     const Scene& scene,
                     const View& view,
                     std::string_view side,
                     std::uint64_t seed) {
  Rng noise = Rng::Stream(seed,
                          fmt::format("{} {} noise", plan.kind->name, side),
                          static_cast<std::uint64_t>(plan.number));
  return Develop(view.light, scene.sensor, noise);
}

void MakePicture(const Plan& plan, const fs::path& root, const GraspPointSetOptions& options) {
  if (IsWritten(root, plan.name)) return;
  const Scene scene = DrawPlanned(plan, options);
  const View view = Render(scene, scene.camera);
  SceneFiles files{.image = DevelopPlanned(plan, scene, view, "left", options.seed),
                   .mask = view.labels,
                   .object_mask = view.object_mask,
                   .depth = view.depth,
                   .scene = SceneToToml(plan.kind->name, plan.instance, scene)};
  if (options.with_right) {
    const View right = Render(scene, RightOf(scene.camera, options.baseline_m));
    files.right_image = DevelopPlanned(plan, scene, right, "right", options.seed);
  }
  WriteSceneFiles(root, plan.name, files);
}

}  // namespace

void GraspPointSetOptions::Validate() const {
  RequireOption(num_images >= 0 && num_images <= kMaxImages,
                "GraspPointSetOptions.num_images",
                num_images,
                fmt::format("from 0 to {}", kMaxImages));
  RequireOption(baseline_m > 0.0F && baseline_m <= 1.0F,
                "GraspPointSetOptions.baseline_m",
                static_cast<double>(baseline_m),
                "in (0, 1]");
  camera.Validate();
  RequireOption(num_threads >= 1, "GraspPointSetOptions.num_threads", num_threads, "1 or more");
}

datasets::LabelledImageSet MakeGraspPointSet(const fs::path& out,
                                             const GraspPointSetOptions& options) {
  options.Validate();
  const std::vector<Plan> plans = MakePlans(options);
  PrepareSetFolder(out, ParametersToToml(options, plans.size()), kFolders);
  datasets::ParallelForReporting(plans.size(),
                                 options.num_threads,
                                 options.progress,
                                 "rendering pictures",
                                 [&](std::size_t i) { MakePicture(plans[i], out, options); });
  datasets::LabelledImageSet set{.root = out, .items = {}};
  for (const Plan& plan : plans) set.items.push_back(Describe(plan, options.with_right));
  datasets::WriteManifest(set);
  return set;
}

}  // namespace handcraft::synthetic
