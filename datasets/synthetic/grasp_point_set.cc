// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_point_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "datasets/parallel_reporting.h"
#include "datasets/synthetic/renderer.h"
#include "datasets/synthetic/scene.h"
#include "datasets/synthetic/sensor.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"
#include "lib/perception/image_io.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr int kGeneratorVersion = 1;  // raised when the same options give other bytes
constexpr int kImagesPerInstance = 4;
constexpr int kInstancesPerTestInstance = 3;
constexpr int kSmallImagesPerClass = 24;
constexpr int kMaxImages = 1000000;
constexpr float kDepthUnitM = 0.001F;
constexpr std::string_view kLicence = "CC0-1.0";
constexpr std::string_view kParametersName = "dataset.toml";
constexpr std::array<std::string_view, 5> kFolders = {
    "images", "masks", "object_masks", "depth", "scenes"};

// One picture to make.
struct Plan {
  const ObjectClass* kind = nullptr;
  int number = 0;    // within its class
  int instance = 0;  // within its class
  std::string name;

  [[nodiscard]] std::string Path(std::string_view folder, std::string_view ending) const {
    return fmt::format("{}/{}{}", folder, name, ending);
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

datasets::LabelledImage Describe(const Plan& plan) {
  const bool is_test = plan.kind->family == Family::kNovel ||
                       plan.instance % kInstancesPerTestInstance == kInstancesPerTestInstance - 1;
  return {.image = plan.Path("images", ".png"),
          .mask = plan.Path("masks", ".png"),
          .object_class = std::string(plan.kind->name),
          .instance = fmt::format("{}_{:04}", plan.kind->name, plan.instance),
          .split = is_test ? "test" : "train",
          .licence = std::string(kLicence)};
}

std::string PoseToToml(std::string_view key, const Eigen::Isometry3f& pose) {
  const Eigen::Vector3f p = pose.translation();
  const Eigen::Quaternionf q(pose.linear());
  return fmt::format(
      "{0}_position_m = [{1}, {2}, {3}]\n{0}_quaternion_xyzw = [{4}, {5}, {6}, {7}]\n",
      key,
      p.x(),
      p.y(),
      p.z(),
      q.x(),
      q.y(),
      q.z(),
      q.w());
}

std::string ParametersToToml(const GraspPointSetOptions& options, std::size_t num_images) {
  const PinholeCamera camera;
  std::string text = fmt::format(
      "kind = \"grasp-points\"\ngenerator = {}\nfamily = \"{}\"\nseed = {}\nnum_images = {}\n",
      kGeneratorVersion,
      options.family == Family::kTrained ? "trained" : "novel",
      options.seed,
      num_images);
  text += fmt::format(
      "\n[camera]\nwidth_px = {}\nheight_px = {}\nfocal_px = {:.1f}\n"
      "centre_u_px = {:.1f}\ncentre_v_px = {:.1f}\n",
      camera.width_px,
      camera.height_px,
      camera.focal_px,
      camera.centre_u_px,
      camera.centre_v_px);
  if (options.with_right) text += fmt::format("baseline_m = {}\n", options.baseline_m);
  return text + fmt::format("\n[depth]\nunit_m = {}\n", kDepthUnitM);
}

std::string SceneToToml(const Plan& plan, const Scene& scene) {
  std::string text =
      fmt::format("class = \"{}\"\ninstance = {}\n\n[camera]\n", plan.kind->name, plan.instance);
  text += PoseToToml("base_from_camera", scene.camera.base_from_camera);
  for (const PlacedObject& placed : scene.objects) {
    if (!placed.is_target) continue;
    text += "\n[[objects]]\n" + PoseToToml("base_from_object", placed.base_from_object);
  }
  return text;
}

BasicImage<std::uint16_t> ToMillimetres(const FloatImage& depth) {
  BasicImage<std::uint16_t> millimetres(depth.width(), depth.height());
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      const float units = std::round(depth.At(u, v) / kDepthUnitM);
      millimetres.At(u, v) = static_cast<std::uint16_t>(std::min(units, 65535.0F));
    }
  }
  return millimetres;
}

Scene DrawPlanned(const Plan& plan, std::uint64_t seed) {
  const std::string name(plan.kind->name);
  Rng object_stream =
      Rng::Stream(seed, name + " object", static_cast<std::uint64_t>(plan.instance));
  std::vector<Object> targets;
  targets.reserve(static_cast<std::size_t>(plan.kind->num_objects));
  for (int i = 0; i < plan.kind->num_objects; ++i)
    targets.push_back(plan.kind->draw(object_stream));
  Rng scene_stream = Rng::Stream(seed, name + " scene", static_cast<std::uint64_t>(plan.number));
  return DrawScene(targets, scene_stream);
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

// The scene's own file comes last: where it is, the others are whole.
void MakePicture(const Plan& plan, const fs::path& root, const GraspPointSetOptions& options) {
  const fs::path last = root / plan.Path("scenes", ".toml");
  if (fs::exists(last)) return;
  const Scene scene = DrawPlanned(plan, options.seed);
  const View view = Render(scene, scene.camera);
  perception::WritePng(root / plan.Path("images", ".png"),
                       DevelopPlanned(plan, scene, view, "left", options.seed));
  perception::WritePng(root / plan.Path("masks", ".png"), view.labels);
  perception::WritePng(root / plan.Path("object_masks", ".png"), view.object_mask);
  perception::WritePng16(root / plan.Path("depth", ".png"), ToMillimetres(view.depth));
  if (options.with_right) {
    const View right = Render(scene, RightOf(scene.camera, options.baseline_m));
    perception::WritePng(root / plan.Path("images", "_right.png"),
                         DevelopPlanned(plan, scene, right, "right", options.seed));
  }
  WriteFileAtomically(last, SceneToToml(plan, scene));
}

// What a killed run may have left of a file that was being written.
void RemoveTemporaryFiles(const fs::path& folder) {
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    const std::string inner = entry.path().stem().extension().string();
    if (ending.size() == 7 && (inner == ".png" || inner == ".toml" || inner == ".csv"))
      left.push_back(entry.path());
  }
  for (const fs::path& path : left) fs::remove(path);
}

[[noreturn]] void RefuseFolder(const fs::path& path, std::string reason, std::string remedy) {
  throw Error({.kind = Error::Kind::kUsage,
               .path = path.string(),
               .reason = std::move(reason),
               .remedy = std::move(remedy)});
}

// Makes the folder, or takes up one that the same options have begun.
void PrepareFolder(const fs::path& out, const std::string& parameters) {
  const fs::path file = out / kParametersName;
  if (fs::exists(out) && !fs::is_directory(out))
    RefuseFolder(out, "is not a folder", "choose another name");
  if (fs::exists(file)) {
    if (ReadTextFile(file) != parameters) {
      RefuseFolder(file, "tells of a set made with other options", "give those, or another folder");
    }
  } else if (fs::exists(out) && !fs::is_empty(out)) {
    RefuseFolder(
        out, "is there already and is not an empty folder", "remove it or choose another name");
  }
  fs::create_directory(out);
  RemoveTemporaryFiles(out);
  WriteFileAtomically(file, parameters);
  for (const std::string_view folder : kFolders) {
    fs::create_directory(out / folder);
    RemoveTemporaryFiles(out / folder);
  }
}

void WriteSyntheticManifest(const fs::path& out, const std::vector<Plan>& plans, bool with_right) {
  std::string text = "image,mask,class,instance,split,licence,object_mask,depth,scene";
  text += with_right ? ",right_image\n" : "\n";
  for (const Plan& plan : plans) {
    const datasets::LabelledImage item = Describe(plan);
    text += fmt::format("{},{},{},{},{},{},{},{},{}",
                        item.image,
                        item.mask,
                        item.object_class,
                        item.instance,
                        item.split,
                        item.licence,
                        plan.Path("object_masks", ".png"),
                        plan.Path("depth", ".png"),
                        plan.Path("scenes", ".toml"));
    text += with_right ? "," + plan.Path("images", "_right.png") + "\n" : "\n";
  }
  WriteFileAtomically(out / "manifest.csv", text);
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
  RequireOption(num_threads >= 1, "GraspPointSetOptions.num_threads", num_threads, "1 or more");
}

datasets::LabelledImageSet MakeGraspPointSet(const fs::path& out,
                                             const GraspPointSetOptions& options) {
  options.Validate();
  const std::vector<Plan> plans = MakePlans(options);
  try {
    PrepareFolder(out, ParametersToToml(options, plans.size()));
  } catch (const fs::filesystem_error& error) {
    throw Error(
        {.path = out.string(), .reason = "cannot make the folder: " + error.code().message()});
  }
  datasets::ParallelForReporting(plans.size(),
                                 options.num_threads,
                                 options.progress,
                                 "rendering pictures",
                                 [&](std::size_t i) { MakePicture(plans[i], out, options); });
  WriteSyntheticManifest(out, plans, options.with_right);
  datasets::LabelledImageSet set{.root = out, .items = {}};
  for (const Plan& plan : plans) set.items.push_back(Describe(plan));
  return set;
}

}  // namespace handcraft::synthetic
