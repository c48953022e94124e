// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh_catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string_view>
#include <tuple>
#include <utility>

#include <toml++/toml.h>

#include "datasets/synthetic/draw.h"
#include "datasets/synthetic/object_parts.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"
#include "lib/core/sha256.h"
#include "lib/structured_text/toml_file.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFileName = "meshes.toml";

template <class T>
struct Named {
  std::string_view name;
  T value;
};
constexpr std::array<Named<float>, 4> kUnits = {
    {{"m", 1.0F}, {"cm", 0.01F}, {"mm", 0.001F}, {"inch", 0.0254F}}};
constexpr std::array<Named<UpAxis>, 3> kAxes = {
    {{"x", UpAxis::kX}, {"y", UpAxis::kY}, {"z", UpAxis::kZ}}};
constexpr std::array<Named<Finish>, 5> kFinishes = {{{"glaze", Finish::kGlaze},
                                                     {"plastic", Finish::kPlastic},
                                                     {"rubber", Finish::kRubber},
                                                     {"metal", Finish::kMetal},
                                                     {"wood", Finish::kWood}}};
constexpr std::array<Named<Family>, 5> kFamilies = {{{"trained", Family::kTrained},
                                                     {"novel", Family::kNovel},
                                                     {"taught", Family::kTaught},
                                                     {"untaught", Family::kUntaught},
                                                     {"regrasp", Family::kRegrasp}}};
constexpr std::array<std::string_view, 14> kKeys = {"file",
                                                    "class",
                                                    "family",
                                                    "licence",
                                                    "unit",
                                                    "up",
                                                    "turn_deg",
                                                    "scale",
                                                    "finish",
                                                    "graspable_finish",
                                                    "graspable_names",
                                                    "graspable_texture",
                                                    "graspable_faces",
                                                    "graspable_parts"};

// One [[mesh]] of the file.
class Entry {
 public:
  Entry(fs::path file, const toml::table& table) : file_(std::move(file)), table_(table) {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(kKeys.begin(), kKeys.end(), name) == kKeys.end()) {
        Fail(node, "\"" + name + "\" is no key of a mesh", "docs/synthetic_data.md lists them");
      }
    }
  }

  [[noreturn]] void Fail(const toml::node& node,
                         std::string reason,
                         std::string remedy = {}) const {
    throw Error({.path = file_.string(),
                 .line = node.source().begin.line,
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)});
  }

  [[nodiscard]] bool Has(std::string_view key) const { return table_.contains(key); }

  [[nodiscard]] std::string Text(std::string_view key) const {
    return TextOf(Node(key), std::string(key));
  }

  template <class T, std::size_t kSize>
  [[nodiscard]] T OneOf(std::string_view key, const std::array<Named<T>, kSize>& known) const {
    const std::string name = Text(key);
    std::string names;
    for (const Named<T>& named : known) {
      if (named.name == name) return named.value;
      names += (names.empty() ? "" : ", ") + std::string(named.name);
    }
    Fail(Node(key), std::string(key) + " is \"" + name + "\"", "give one of " + names);
  }

  [[nodiscard]] float Number(std::string_view key) const {
    return NumberOf(Node(key), std::string(key));
  }

  // Two numbers, 0 < first ≤ second ≤ 10.
  [[nodiscard]] std::pair<float, float> Range(std::string_view key) const {
    const toml::array* const range = Node(key).as_array();
    if (range == nullptr || range->size() != 2) {
      Fail(Node(key), std::string(key) + " is no list of two numbers", "write [0.9, 1.1]");
    }
    const float least = NumberOf((*range)[0], std::string(key));
    const float greatest = NumberOf((*range)[1], std::string(key));
    if (least <= 0.0F || least > greatest || greatest > 10.0F) {
      Fail(Node(key),
           std::string(key) + " does not rise from above 0 to at most 10",
           "write the smaller factor first: [0.9, 1.1]");
    }
    return {least, greatest};
  }

  [[nodiscard]] fs::path Path(std::string_view key) const {
    return PathOf(Node(key), std::string(key));
  }

  [[nodiscard]] std::vector<fs::path> Paths(std::string_view key) const {
    std::vector<fs::path> paths;
    for (const toml::node& node : List(key)) paths.push_back(PathOf(node, std::string(key)));
    return paths;
  }

  [[nodiscard]] std::vector<std::string> Texts(std::string_view key) const {
    std::vector<std::string> texts;
    for (const toml::node& node : List(key)) texts.push_back(TextOf(node, std::string(key)));
    return texts;
  }

  [[nodiscard]] const toml::node& Node(std::string_view key) const {
    const toml::node* const node = table_.get(key);
    if (node == nullptr) {
      Fail(table_,
           "a mesh has no \"" + std::string(key) + "\"",
           "give it; docs/synthetic_data.md says what it is");
    }
    return *node;
  }

  [[nodiscard]] const toml::table& table() const { return table_; }

 private:
  [[nodiscard]] std::string TextOf(const toml::node& node, const std::string& key) const {
    const auto text = node.value_exact<std::string>();
    if (!text || text->empty()) Fail(node, key + " is no text", "write one between quotes");
    return *text;
  }

  [[nodiscard]] float NumberOf(const toml::node& node, const std::string& key) const {
    const auto number = node.value<double>();
    if (!number || !std::isfinite(static_cast<float>(*number))) {
      Fail(node, key + " is no number", "write it without quotes, as in 0.5");
    }
    return static_cast<float>(*number);
  }

  [[nodiscard]] fs::path PathOf(const toml::node& node, const std::string& key) const {
    const fs::path path = TextOf(node, key);
    if (path.is_absolute() || path.lexically_normal().string().starts_with("..")) {
      Fail(node, "\"" + path.string() + "\" leaves the folder", "put the file below it");
    }
    return file_.parent_path() / path;
  }

  [[nodiscard]] const toml::array& List(std::string_view key) const {
    const toml::array* const list = Node(key).as_array();
    if (list == nullptr || list->empty())
      Fail(Node(key), std::string(key) + " is no list of texts", "write [\"…\", \"…\"]");
    return *list;
  }

  fs::path file_;
  const toml::table& table_;
};

// A class's name becomes part of names of files.
std::string ParseClass(const Entry& entry) {
  std::string name = entry.Text("class");
  const bool is_plain = std::all_of(name.begin(), name.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
  });
  if (!is_plain || name.size() > 60) {
    entry.Fail(entry.Node("class"), "class is \"" + name + "\"", "use a-z, 0-9 and _, up to 60");
  }
  return name;
}

MeshFileOptions ParseFileOptions(const Entry& entry) {
  MeshFileOptions options;
  if (entry.Has("unit")) options.unit_m = entry.OneOf("unit", kUnits);
  if (entry.Has("up")) options.up = entry.OneOf("up", kAxes);
  if (entry.Has("turn_deg")) {
    options.turn_rad = entry.Number("turn_deg") * std::numbers::pi_v<float> / 180.0F;
  }
  int num_ways = 0;
  for (const std::string_view way :
       {"graspable_names", "graspable_texture", "graspable_faces", "graspable_parts"}) {
    num_ways += entry.Has(way) ? 1 : 0;
  }
  if (num_ways != 1) {
    entry.Fail(entry.table(),
               "a mesh has " + std::to_string(num_ways) + " keys that say what is graspable",
               "give one of graspable_names, _texture, _faces and _parts");
  }
  if (entry.Has("graspable_names")) options.names = entry.Texts("graspable_names");
  if (entry.Has("graspable_texture")) options.texture = entry.Path("graspable_texture");
  if (entry.Has("graspable_faces")) options.face_labels = entry.Path("graspable_faces");
  if (entry.Has("graspable_parts")) options.parts = entry.Paths("graspable_parts");
  return options;
}

CatalogueMesh ParseMesh(const Entry& entry) {
  CatalogueMesh mesh;
  mesh.object_class = ParseClass(entry);
  mesh.family = entry.OneOf("family", kFamilies);
  mesh.licence = entry.Text("licence");
  if (entry.Has("scale")) {
    std::tie(mesh.least_scale, mesh.greatest_scale) = entry.Range("scale");
  }
  if (entry.Has("finish")) mesh.finish = entry.OneOf("finish", kFinishes);
  if (entry.Has("graspable_finish")) {
    mesh.graspable_finish = entry.OneOf("graspable_finish", kFinishes);
  }
  mesh.labelled = ReadMeshFile(entry.Path("file"), ParseFileOptions(entry));
  return mesh;
}

// The tables [[mesh]] that the file holds, and nothing else.
std::vector<const toml::table*> TablesOf(const fs::path& file, const toml::table& root) {
  const auto fail = [&](const toml::node& node, std::string reason) {
    throw Error(
        {.path = file.string(),
         .line = node.source().begin.line,
         .reason = std::move(reason),
         .remedy = "give a table [[mesh]] for each mesh; docs/synthetic_data.md lists keys"});
  };
  std::vector<const toml::table*> tables;
  for (const auto& [key, node] : root) {
    const toml::array* const list = node.as_array();
    if (key.str() != "mesh" || list == nullptr) {
      fail(node, "\"" + std::string(key.str()) + "\" is not a table [[mesh]]");
    }
    for (const toml::node& entry : *list) {
      if (!entry.is_table()) fail(entry, "a mesh is not a table [[mesh]]");
      tables.push_back(entry.as_table());
    }
  }
  if (tables.empty()) fail(root, "no table [[mesh]]");
  return tables;
}

std::string FingerprintOf(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (KindOf(entry.path()) != PathKind::kFile) continue;
    files[entry.path().lexically_relative(folder).generic_string()] = entry.path();
  }
  Sha256 hash;
  for (const auto& [name, path] : files) {
    hash.Update(name + std::string(1, '\0') + Sha256Hex(ReadFile(path)) + "\n");
  }
  return hash.HexDigest();
}

Material DrawFinish(Finish finish, Rng& rng) {
  switch (finish) {
    case Finish::kGlaze:
      return DrawGlaze(rng);
    case Finish::kPlastic:
      return DrawVividPlastic(rng);
    case Finish::kRubber:
      return DrawDarkRubber(rng);
    case Finish::kMetal:
      return DrawMetal(rng);
    case Finish::kWood:
      break;
  }
  Material wood =
      Painted(FromHsv(0.08F, Between(rng, 0.4F, 0.6F), Between(rng, 0.5F, 0.8F)), 0.02F);
  wood.second = 0.55F * wood.base;
  wood.pattern = Pattern::kWood;
  wood.seed = Between(rng, 0.0F, 500.0F);
  return wood;
}

}  // namespace

MeshCatalogue ReadMeshCatalogue(const fs::path& folder) {
  const fs::path file = folder / kFileName;
  if (KindOf(folder) == PathKind::kFile) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = folder.string(),
                 .reason = "is a file; a folder with a meshes.toml is due",
                 .remedy = "docs/synthetic_data.md describes one"});
  }
  if (KindOf(file) != PathKind::kFile) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = folder.string(),
                 .reason = Exists(folder) ? "holds no meshes.toml, which says what its meshes are"
                                          : "no such folder",
                 .remedy = "docs/synthetic_data.md describes one"});
  }
  const toml::table table = ReadTomlFile(file);
  MeshCatalogue catalogue;
  for (const toml::table* const entry : TablesOf(file, table)) {
    catalogue.meshes.push_back(ParseMesh(Entry(file, *entry)));
  }
  catalogue.fingerprint = FingerprintOf(folder);
  return catalogue;
}

Object DrawCatalogueObject(const CatalogueMesh& mesh, Rng& rng) {
  Object object{.mesh = mesh.labelled.mesh, .materials = {}};
  const float scale = Between(rng, mesh.least_scale, mesh.greatest_scale);
  for (Eigen::Vector3f& vertex : object.mesh.vertices) vertex *= scale;
  for (const std::optional<Colour>& diffuse : mesh.labelled.diffuse) {
    const Material drawn = DrawFinish(mesh.finish, rng);
    object.materials.push_back(diffuse ? Painted(*diffuse, drawn.specular) : drawn);
  }
  if (mesh.graspable_finish) {
    const auto index = static_cast<std::uint8_t>(object.materials.size());
    object.materials.push_back(DrawFinish(*mesh.graspable_finish, rng));
    for (Face& face : object.mesh.faces) {
      if (face.surface.graspable) face.surface.material = index;
    }
  }
  return object;
}

}  // namespace handcraft::synthetic
