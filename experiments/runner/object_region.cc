// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/object_region.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "datasets/formats/organised_cloud.h"
#include "datasets/formats/set_fingerprint.h"
#include "datasets/importers/depth_cloud.h"
#include "datasets/synthetic/camera_file.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/path_kind.h"
#include "lib/perception/image_io.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr double kDepthUnitM = 0.001;  // docs/datasets.md: depth pictures hold millimetres
constexpr const char* kParameters = "dataset.toml";
constexpr double kFarthestM = 1000.0;

std::vector<double> Numbers(const TomlTable& table, std::string_view key, std::size_t count) {
  const toml::array* const array = table.Node(key).as_array();
  if (array == nullptr || array->size() != count) {
    table.Fail(table.Node(key), std::string(key) + " is no list of its numbers");
  }
  std::vector<double> numbers;
  for (const toml::node& node : *array) {
    const auto number = node.value<double>();
    if (!number || !(std::abs(*number) <= kFarthestM)) {
      table.Fail(node, std::string(key) + " holds what is no number");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

Eigen::Isometry3d ReadCameraPose(const fs::path& scene) {
  const toml::table parsed = ReadTomlFile(scene);
  const TomlTable camera = TomlTable(scene.string(), parsed, "").Table("camera");
  const std::vector<double> p = Numbers(camera, "base_from_camera_position_m", 3);
  const std::vector<double> q = Numbers(camera, "base_from_camera_quaternion_xyzw", 4);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(p[0], p[1], p[2]);
  pose.linear() = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
  return pose;
}

bool HasDepth(const datasets::LabelledImage& item) {
  return !item.Companion(datasets::kCloud).empty() ||
         (!item.Companion(datasets::kDepth).empty() && !item.Companion(datasets::kScene).empty());
}

datasets::OrganisedCloud CloudOf(const datasets::LabelledImageSet& set,
                                 const datasets::LabelledImage& item,
                                 const Image& picture) {
  const std::string cloud = item.Companion(datasets::kCloud);
  if (!cloud.empty()) {
    return datasets::ReadCloudOfPicture(set.root / cloud, datasets::SizeOf(picture));
  }
  const std::string depth = item.Companion(datasets::kDepth);
  const std::string scene = item.Companion(datasets::kScene);
  const synthetic::PinholeCamera camera = synthetic::ReadCameraFile(set.root / kParameters).camera;
  return datasets::CloudOfDepth(perception::ReadImage16(set.root / depth),
                                kDepthUnitM,
                                {.fx_px = camera.focal_px,
                                 .fy_px = camera.focal_px,
                                 .cx_px = camera.centre_u_px,
                                 .cy_px = camera.centre_v_px},
                                ReadCameraPose(set.root / scene));
}

}  // namespace

perception::SearchRegion FindObjectRegion(const datasets::LabelledImageSet& set,
                                          std::size_t item,
                                          const Image& picture) {
  HC_CHECK(HasDepth(set.items.at(item)), set.items[item].image);
  const datasets::OrganisedCloud cloud = CloudOf(set, set.items.at(item), picture);
  if (cloud.width != picture.width() || cloud.height != picture.height()) {
    throw Error({.path = (set.root / set.items[item].image).string(),
                 .reason = "is of another size than its cloud"});
  }
  perception::SearchRegionFinder finder({});
  return finder.Find(picture, {cloud.points, cloud.width, cloud.height});
}

std::string DepthFingerprint(const datasets::LabelledImageSet& set) {
  const std::filesystem::path parameters = set.root / kParameters;
  const auto digest_of = [&](const std::string& file) {
    return file.empty() ? std::string() : datasets::FileDigest(set.root / file);
  };
  std::vector<std::string> lines;
  for (const datasets::LabelledImage& item : set.items) {
    lines.push_back(datasets::FingerprintLine(item.image,
                                              {digest_of(item.Companion(datasets::kCloud)),
                                               digest_of(item.Companion(datasets::kDepth)),
                                               digest_of(item.Companion(datasets::kScene))}));
  }
  if (Exists(parameters)) lines.push_back(datasets::FileDigest(parameters));
  return datasets::FingerprintOf(std::move(lines));
}

void RequireDepth(const datasets::LabelledImageSet& set) {
  const auto lacks = [](const datasets::LabelledImage& item) { return !HasDepth(item); };
  const auto first = std::find_if(set.items.begin(), set.items.end(), lacks);
  if (first == set.items.end()) return;
  throw Error(
      {.path = (set.root / first->image).string(),
       .reason = fmt::format("has neither a cloud nor a depth picture with its scene, as {} of {} "
                             "pictures; methods with region = \"object\" need one",
                             std::count_if(first, set.items.end(), lacks),
                             set.items.size()),
       .remedy = "leave these methods out (--methods), or take pictures with depth"});
}

}  // namespace handcraft::experiments
