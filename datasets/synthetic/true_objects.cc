// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/true_objects.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "datasets/formats/scene_file.h"
#include "datasets/synthetic/view_sets.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kKinds = {"turntable", "moved", "demonstrations"};
constexpr double kMost = 9007199254740992.0;  // whole numbers up to it are exact

// What dataset.toml tells of the drawing of objects.
struct Drawing {
  Family family = Family::kTaught;
  std::uint64_t seed = 1;
};

Drawing ReadDrawing(const fs::path& path) {
  const toml::table root = ReadTomlFile(path);
  const TomlTable table(path.string(), root, "");
  const std::string kind = table.Text("kind");
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
    table.Fail(table.Node("kind"),
               "kind is \"" + kind + "\"; turntable, moved or demonstrations is due");
  }
  const auto version = static_cast<int>(table.Number("generator", 0.0, 1e6));
  if (version != kViewGeneratorVersion) {
    table.Fail(
        table.Node("generator"),
        fmt::format(
            "made by version {} of the generator; this is {}", version, kViewGeneratorVersion),
        "make the set again");
  }
  return {FamilyNamed(table.Text("family")),
          static_cast<std::uint64_t>(table.Number("seed", 0.0, kMost))};
}

const ObjectClass& ClassNamed(const std::string& name, Family family, const fs::path& scene) {
  const std::span<const ObjectClass> classes = ClassesOf(family);
  const auto found = std::find_if(
      classes.begin(), classes.end(), [&](const ObjectClass& kind) { return kind.name == name; });
  if (found != classes.end()) return *found;
  throw Error(
      {.path = scene.string(),
       .reason = fmt::format("class \"{}\" is none of the family {}", name, NameOf(family))});
}

}  // namespace

TrueObject DrawTrueObject(const datasets::ViewSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const datasets::ObjectView& view = set.items[index];
  if (view.scene.empty()) {
    throw Error({.path = (set.root / view.image).string(),
                 .reason = "the view has no scene, which tells where the object stands",
                 .remedy = "give a set that handcraft data synth has made"});
  }
  const fs::path path = set.root / view.scene;
  const datasets::SceneRecord scene = datasets::ReadSceneFile(path);
  if (scene.base_from_objects.size() != 1) {
    throw Error({.path = path.string(),
                 .reason = fmt::format("{} objects; one is due", scene.base_from_objects.size())});
  }
  const Drawing drawing = ReadDrawing(path.parent_path().parent_path() / "dataset.toml");
  const ObjectClass& kind = ClassNamed(scene.object_class, drawing.family, path);
  TrueObject object{.mesh = DrawInstance(kind, drawing.seed, static_cast<int>(scene.instance)).mesh,
                    .base_from_object = scene.base_from_objects.front().cast<float>()};
  const auto scale = static_cast<float>(scene.scale);
  for (Eigen::Vector3f& vertex : object.mesh.vertices) vertex *= scale;
  return object;
}

}  // namespace handcraft::synthetic
