// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene_files.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "datasets/parallel_reporting.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"
#include "lib/core/sha256.h"
#include "lib/perception/image_io.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr float kDepthUnitM = 0.001F;

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

// A number that TOML takes for a float: the shortest text that reads back the same.
std::string FloatToToml(float value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

constexpr std::string_view kRecordStart = "\n[files]\n";

// The table [files], which tells what the other files are and what stands before it.
std::string Record(const fs::path& root, std::string_view name, std::string_view scene) {
  using Place = std::pair<std::string_view, std::string_view>;
  Sha256 digest;
  for (const auto& [folder, ending] : {Place("images", ".png"),
                                       Place("images", "_right.png"),
                                       Place("masks", ".png"),
                                       Place("object_masks", ".png"),
                                       Place("clouds", ".pcd"),
                                       Place("depth", ".png")}) {
    const std::string path = ScenePath(folder, name, ending);
    if (!Exists(root / path)) continue;
    digest.Update(path);
    digest.Update(std::string_view("\0", 1));
    digest.Update(Sha256Hex(ReadFile(root / path)));
    digest.Update("\n");
  }
  digest.Update(scene);
  return fmt::format("{}sha256 = \"{}\"\n", kRecordStart, digest.HexDigest());
}

}  // namespace

std::string ScenePath(std::string_view folder, std::string_view name, std::string_view ending) {
  return fmt::format("{}/{}{}", folder, name, ending);
}

bool IsWhole(const fs::path& root, std::string_view name) {
  const fs::path path = root / ScenePath("scenes", name, ".toml");
  if (!Exists(path)) return false;
  const std::string text = ReadTextFile(path);
  const std::string scene = text.substr(0, text.rfind(kRecordStart));
  return text == scene + Record(root, name, scene);
}

void WriteSceneFiles(const fs::path& root, std::string_view name, const SceneFiles& files) {
  const auto write = [&](std::string_view folder, std::string_view ending, const Image& image) {
    if (!image.empty()) perception::WritePng(root / ScenePath(folder, name, ending), image);
  };
  write("images", ".png", files.image);
  write("images", "_right.png", files.right_image);
  write("masks", ".png", files.mask);
  write("object_masks", ".png", files.object_mask);
  if (!files.cloud.points.empty()) {
    datasets::WritePcd(root / ScenePath("clouds", name, ".pcd"), files.cloud);
  }
  if (!files.depth.empty()) {
    perception::WritePng16(root / ScenePath("depth", name, ".png"), ToMillimetres(files.depth));
  }
  WriteFileAtomically(root / ScenePath("scenes", name, ".toml"),
                      files.scene + Record(root, name, files.scene));
}

bool WriteUnlessWhole(const fs::path& root,
                      std::string_view name,
                      const std::function<SceneFiles()>& make) {
  if (IsWhole(root, name)) return false;
  WriteSceneFiles(root, name, make());
  return true;
}

std::size_t CountWritten(std::size_t num_scenes,
                         int num_threads,
                         const Progress& progress,
                         std::string_view stage,
                         const std::function<bool(std::size_t)>& write) {
  std::atomic<std::size_t> num_written = 0;
  datasets::ParallelForReporting(num_scenes, num_threads, progress, stage, [&](std::size_t i) {
    if (write(i)) ++num_written;
  });
  return num_written;
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

std::string CameraToToml(const PinholeCamera& camera, std::optional<float> baseline_m) {
  std::string text = fmt::format(
      "\n[camera]\nwidth_px = {}\nheight_px = {}\nfocal_px = {}\n"
      "centre_u_px = {}\ncentre_v_px = {}\n",
      camera.width_px,
      camera.height_px,
      FloatToToml(camera.focal_px),
      FloatToToml(camera.centre_u_px),
      FloatToToml(camera.centre_v_px));
  if (baseline_m) text += fmt::format("baseline_m = {}\n", *baseline_m);
  return text + fmt::format("\n[depth]\nunit_m = {}\n", kDepthUnitM);
}

std::string SceneToToml(std::string_view object_class, int instance, const Scene& scene) {
  std::string text =
      fmt::format("class = \"{}\"\ninstance = {}\n\n[camera]\n", object_class, instance);
  text += PoseToToml("base_from_camera", scene.camera.base_from_camera);
  for (const PlacedObject& placed : scene.objects) {
    if (!placed.is_target) continue;
    text += "\n[[objects]]\n" + PoseToToml("base_from_object", placed.base_from_object);
  }
  return text;
}

}  // namespace handcraft::synthetic
