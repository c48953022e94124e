// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/scene_file.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/structured_text/toml_file.h"

namespace handcraft::datasets {
namespace {

// One table of the file.
class SceneTable {
 public:
  // `name` stands in messages, as in " in [camera]".
  SceneTable(const std::filesystem::path& path, const toml::table& table, std::string name)
      : path_(path), table_(table), name_(std::move(name)) {}

  [[nodiscard]] std::string Text(const std::string& key) const {
    const toml::node& node = Need(key);
    std::string text = node.value_exact<std::string>().value_or("");
    if (text.empty()) Fail(node, key + " is no text");
    return text;
  }

  [[nodiscard]] std::int64_t Number(const std::string& key) const {
    const toml::node& node = Need(key);
    if (!node.is_integer() || *node.value<std::int64_t>() < 0) {
      Fail(node, key + " is no whole number from 0 on");
    }
    return *node.value<std::int64_t>();
  }

  // The two keys of a pose.
  [[nodiscard]] Eigen::Isometry3d Pose(const std::string& pose) const {
    const std::vector<double> p = Numbers(pose + "_position_m", 3);
    const std::string key = pose + "_quaternion_xyzw";
    const std::vector<double> q = Numbers(key, 4);
    const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
    constexpr double kTolerance = 1e-3;
    const double length = rotation.norm();
    if (std::abs(length - 1.0) > kTolerance) {
      Fail(Need(key), key + " has length " + NumberToText(length) + "; 1 is due");
    }
    return Eigen::Translation3d(p[0], p[1], p[2]) * rotation.normalized();
  }

  [[nodiscard]] double Scale() const {
    const toml::node* const node = table_.get("scale");
    if (node == nullptr) return 1.0;
    const std::optional<double> scale = node->value<double>();
    if (scale && !node->is_boolean() && std::isfinite(*scale) && *scale > 0.0) return *scale;
    Fail(*node, "scale is no number above 0");
  }

 private:
  [[noreturn]] void Fail(const toml::node& at, std::string reason) const {
    throw Error({.path = path_.string(),
                 .line = at.source().begin.line,
                 .reason = std::move(reason),
                 .remedy = "see docs/datasets.md, Scene"});
  }

  [[nodiscard]] const toml::node& Need(const std::string& key) const {
    const toml::node* const node = table_.get(key);
    if (node != nullptr) return *node;
    Fail(table_, "no " + key + name_);
  }

  [[nodiscard]] std::vector<double> Numbers(const std::string& key, std::size_t count) const {
    const toml::node& node = Need(key);
    std::vector<double> numbers;
    if (const toml::array* const list = node.as_array()) {
      for (const toml::node& item : *list) {
        const std::optional<double> number = item.value<double>();
        if (!number || item.is_boolean() || !std::isfinite(*number)) break;
        numbers.push_back(*number);
      }
      if (numbers.size() == count && list->size() == count) return numbers;
    }
    Fail(node, key + " is no list of " + std::to_string(count) + " finite numbers");
  }

  const std::filesystem::path& path_;
  const toml::table& table_;
  std::string name_;
};

[[noreturn]] void FailWithout(const std::filesystem::path& path, const std::string& table) {
  throw Error({.path = path.string(),
               .reason = "no table " + table,
               .remedy = "see docs/datasets.md, Scene"});
}

}  // namespace

SceneRecord ReadSceneFile(const std::filesystem::path& path) {
  const toml::table root = ReadTomlFile(path);
  if (root.empty()) throw Error({.path = path.string(), .reason = "the file is empty"});
  const SceneTable top(path, root, "");
  SceneRecord scene{.object_class = top.Text("class"), .instance = top.Number("instance")};
  const toml::table* const camera = root["camera"].as_table();
  if (camera == nullptr) FailWithout(path, "[camera]");
  scene.base_from_camera = SceneTable(path, *camera, " in [camera]").Pose("base_from_camera");
  const toml::array* const objects = root["objects"].as_array();
  if (objects == nullptr || objects->empty()) FailWithout(path, "[[objects]]");
  for (const toml::node& node : *objects) {
    const toml::table* const object = node.as_table();
    if (object == nullptr) FailWithout(path, "[[objects]]");
    scene.base_from_objects.push_back(
        SceneTable(path, *object, " in one of [[objects]]").Pose("base_from_object"));
  }
  scene.scale = top.Scale();
  return scene;
}

}  // namespace handcraft::datasets
