// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_point_set.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "datasets/synthetic/mesh_catalogue.h"
#include "datasets/synthetic/renderer.h"
#include "datasets/synthetic/scene.h"
#include "datasets/synthetic/scene_files.h"
#include "datasets/synthetic/sensor.h"
#include "datasets/synthetic/set_folder.h"
#include "datasets/synthetic/set_lists.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr int kGeneratorVersion = 2;  // raised when the same options give other bytes
constexpr int kImagesPerInstance = 4;
constexpr int kInstancesPerTestInstance = 3;
constexpr int kInstancesPerMesh = 3;
constexpr int kSmallImagesPerClass = 24;
constexpr int kMeshImagesFull = 120;
constexpr std::array<std::string_view, 5> kFolders = {
    "images", "masks", "object_masks", "depth", "scenes"};

// What is told apart by its name: a class of drawn objects, of a catalogue's meshes, or of both.
struct Kind {
  std::string name;
  Family family = Family::kTrained;
  Object (*draw)(Rng& rng) = nullptr;  // nothing: meshes alone
  int num_objects = 1;
  int num_images_full = kMeshImagesFull;
  std::vector<const CatalogueMesh*> meshes = {};

  // The mesh that an instance is of; nothing: it is drawn.
  [[nodiscard]] const CatalogueMesh* MeshOf(int instance) const {
    if (meshes.empty()) return nullptr;
    const auto number = static_cast<std::size_t>(instance);
    if (draw == nullptr) return meshes[number % meshes.size()];
    if (number % kInstancesPerMesh != 0) return nullptr;
    return meshes[number / kInstancesPerMesh % meshes.size()];
  }
};

// One picture to make.
struct Plan {
  const Kind* kind = nullptr;
  int number = 0;    // within its class
  int instance = 0;  // within its class
  std::string name;

  [[nodiscard]] std::string Path(std::string_view folder, std::string_view ending) const {
    return ScenePath(folder, name, ending);
  }
};

std::vector<Kind> MakeKinds(const GraspPointSetOptions& options, const MeshCatalogue& catalogue) {
  std::vector<Kind> kinds;
  for (const ObjectClass& known : ClassesOf(options.family)) {
    kinds.push_back({std::string(known.name),
                     known.family,
                     known.draw,
                     known.num_objects,
                     known.num_images_full,
                     {}});
  }
  for (const CatalogueMesh& mesh : catalogue.meshes) {
    if (mesh.family != options.family) continue;
    auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& known) {
      return known.name == mesh.object_class;
    });
    if (kind == kinds.end()) {
      kind = kinds.insert(kinds.end(), {.name = mesh.object_class, .family = mesh.family});
    }
    kind->meshes.push_back(&mesh);
  }
  return kinds;
}

int NumImages(const Kind& kind,
              std::size_t index,
              const GraspPointSetOptions& options,
              int num_kinds) {
  if (options.num_images > 0) {
    const int left_over = options.num_images % num_kinds;
    return options.num_images / num_kinds + (static_cast<int>(index) < left_over ? 1 : 0);
  }
  return options.size == SetSize::kSmall ? kSmallImagesPerClass : kind.num_images_full;
}

std::vector<Plan> MakePlans(const GraspPointSetOptions& options, const std::vector<Kind>& kinds) {
  std::vector<Plan> plans;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const int num_images = NumImages(kinds[i], i, options, static_cast<int>(kinds.size()));
    for (int number = 0; number < num_images; ++number) {
      const int instance = number / kImagesPerInstance;
      plans.push_back(
          {&kinds[i],
           number,
           instance,
           fmt::format("{}_{:04}_{}", kinds[i].name, instance, number % kImagesPerInstance)});
    }
  }
  return plans;
}

bool IsTest(const Plan& plan) {
  const Family family = plan.kind->family;
  if (family == Family::kNovel || family == Family::kUntaught) return true;
  const bool is_third = plan.instance % kInstancesPerTestInstance == kInstancesPerTestInstance - 1;
  return is_third && plan.kind->MeshOf(plan.instance) == nullptr;
}

datasets::LabelledImage Describe(const Plan& plan, bool with_right) {
  const CatalogueMesh* const mesh = plan.kind->MeshOf(plan.instance);
  datasets::LabelledImage item{
      .image = plan.Path("images", ".png"),
      .mask = plan.Path("masks", ".png"),
      .object_class = plan.kind->name,
      .instance = fmt::format("{}_{:04}", plan.kind->name, plan.instance),
      .split = IsTest(plan) ? "test" : "train",
      .licence = mesh == nullptr ? std::string(kSyntheticLicence) : mesh->licence};
  item.others.emplace(datasets::kObjectMask, plan.Path("object_masks", ".png"));
  item.others.emplace(datasets::kDepth, plan.Path("depth", ".png"));
  item.others.emplace(datasets::kScene, plan.Path("scenes", ".toml"));
  if (with_right) item.others.emplace(datasets::kRightImage, plan.Path("images", "_right.png"));
  return item;
}

std::string ParametersToToml(const GraspPointSetOptions& options,
                             const MeshCatalogue& catalogue,
                             std::size_t num_images) {
  std::string text = fmt::format(
      "kind = \"grasp-points\"\ngenerator = {}\nfamily = \"{}\"\nseed = {}\nnum_images = {}\n",
      kGeneratorVersion,
      NameOf(options.family),
      options.seed,
      num_images);
  if (options.surroundings == Surroundings::kBare) text += "surroundings = \"bare\"\n";
  if (!catalogue.meshes.empty()) text += fmt::format("meshes = \"{}\"\n", catalogue.fingerprint);
  return text + CameraToToml(options.camera,
                             options.with_right ? std::optional(options.baseline_m) : std::nullopt);
}

Scene DrawPlanned(const Plan& plan, const GraspPointSetOptions& options) {
  const std::uint64_t seed = options.seed;
  const std::string& name = plan.kind->name;
  Rng object_stream =
      Rng::Stream(seed, name + " object", static_cast<std::uint64_t>(plan.instance));
  std::vector<Object> targets;
  targets.reserve(static_cast<std::size_t>(plan.kind->num_objects));
  const CatalogueMesh* const mesh = plan.kind->MeshOf(plan.instance);
  for (int i = 0; i < plan.kind->num_objects; ++i) {
    targets.push_back(mesh == nullptr ? plan.kind->draw(object_stream)
                                      : DrawCatalogueObject(*mesh, object_stream));
  }
  Rng scene_stream = Rng::Stream(seed, name + " scene", static_cast<std::uint64_t>(plan.number));
  Scene scene = DrawScene(targets, scene_stream);
  if (options.surroundings == Surroundings::kBare) MakeBare(scene);
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

SceneFiles MakePicture(const Plan& plan, const GraspPointSetOptions& options) {
  const Scene scene = DrawPlanned(plan, options);
  const View view = Render(scene, scene.camera);
  SceneFiles files;
  files.image = DevelopPlanned(plan, scene, view, "left", options.seed);
  files.mask = view.labels;
  files.object_mask = view.object_mask;
  files.depth = view.depth;
  files.scene = SceneToToml(plan.kind->name, plan.instance, scene);
  if (options.with_right) {
    const View right = Render(scene, RightOf(scene.camera, options.baseline_m));
    files.right_image = DevelopPlanned(plan, scene, right, "right", options.seed);
  }
  return files;
}

}  // namespace

void GraspPointSetOptions::Validate() const {
  RequireOption(num_images >= 0 && num_images <= kMaxImages,
                "GraspPointSetOptions.num_images",
                num_images,
                fmt::format("from 0 to {}", kMaxImages));
  RequireOption(baseline_m > 0.0F && baseline_m <= 1.0F,
                "GraspPointSetOptions.baseline_m",
                baseline_m,
                "in (0, 1]");
  camera.Validate();
  RequireOption(num_threads >= 1, "GraspPointSetOptions.num_threads", num_threads, "1 or more");
}

MadeImages MakeGraspPointSet(const fs::path& out, const GraspPointSetOptions& options) {
  options.Validate();
  const MeshCatalogue catalogue =
      options.meshes.empty() ? MeshCatalogue{} : ReadMeshCatalogue(options.meshes);
  const std::vector<Kind> kinds = MakeKinds(options, catalogue);
  const std::vector<Plan> plans = MakePlans(options, kinds);
  PrepareSetFolder(out, ParametersToToml(options, catalogue, plans.size()), kFolders);
  MadeImages made{.set = {.root = out, .items = {}}, .written = {}};
  made.written.num_pictures = CountWritten(
      plans.size(),
      options.num_threads,
      options.progress,
      "rendering pictures",
      [&](std::size_t i) {
        return WriteUnlessWhole(out, plans[i].name, [&] { return MakePicture(plans[i], options); });
      });
  for (const Plan& plan : plans) made.set.items.push_back(Describe(plan, options.with_right));
  WriteList(made.set, made.written);
  return made;
}

}  // namespace handcraft::synthetic
