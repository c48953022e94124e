// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/obj_mesh.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

#include "datasets/formats/mesh_text.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

class ObjParser {
 public:
  ObjParser(const fs::path& path, std::string_view text) : path_(path), lines_(path, text) {}

  SurfaceMesh Parse() {
    mesh_.parts.emplace_back();
    while (lines_.Next()) ParseLine();
    return std::move(mesh_);
  }

 private:
  void ParseLine() {
    const std::string_view keyword = lines_.words().front();
    if (keyword == "v") {
      mesh_.vertices.emplace_back(lines_.Number(1), lines_.Number(2), lines_.Number(3));
    } else if (keyword == "vt") {
      mesh_.texture_coordinates.emplace_back(lines_.Number(1),
                                             lines_.words().size() > 2 ? lines_.Number(2) : 0.0F);
    } else if (keyword == "f") {
      ParseFace();
    } else if (keyword == "o") {
      BeginPart(&SurfaceMesh::Part::object);
    } else if (keyword == "g") {
      BeginPart(&SurfaceMesh::Part::group);
    } else if (keyword == "usemtl") {
      BeginPart(&SurfaceMesh::Part::material);
    } else if (keyword == "mtllib") {
      ReadMaterials();
    }
  }

  void BeginPart(std::string SurfaceMesh::Part::*name) {
    SurfaceMesh::Part part = mesh_.parts.back();
    part.*name = lines_.From(1);
    mesh_.parts.push_back(part);
  }

  void ParseFace() {
    corners_.clear();
    texture_.clear();
    for (std::size_t i = 1; i < lines_.words().size(); ++i) ParseCorner(lines_.words()[i]);
    if (corners_.size() < 3) lines_.Fail("a face has three corners or more");
    if (texture_.size() != corners_.size()) texture_.clear();
    mesh_.AddFace(corners_, texture_, static_cast<std::uint32_t>(mesh_.parts.size() - 1));
  }

  // i, i/t, i//n or i/t/n.
  void ParseCorner(std::string_view word) {
    const std::size_t slash = word.find('/');
    corners_.push_back(Index(word.substr(0, slash), mesh_.vertices.size(), "vertex"));
    if (slash == std::string_view::npos) return;
    const std::string_view rest = word.substr(slash + 1);
    const std::string_view texture = rest.substr(0, rest.find('/'));
    if (texture.empty()) return;
    texture_.push_back(Index(texture, mesh_.texture_coordinates.size(), "texture coordinate"));
  }

  // From 1, or from the end: −1 is the last one so far.
  std::uint32_t Index(std::string_view word, std::size_t count, const std::string& what) const {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    const auto last = static_cast<std::int64_t>(count);
    if (error != std::errc() || end != word.data() + word.size() || index == 0 || index > last ||
        index < -last) {
      lines_.Fail("\"" + std::string(word.substr(0, 30)) + "\" names no " + what + "; " +
                  std::to_string(count) + " are above");
    }
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : last + index);
  }

  void ReadMaterials() {
    const fs::path name = lines_.From(1);
    const bool leaves = name.is_absolute() || name.lexically_normal().string().starts_with("..");
    if (name.empty() || leaves) lines_.Fail("a file of materials lies in the folder or below it");
    const fs::path path = path_.parent_path() / name;
    if (KindOf(path) != PathKind::kFile) return;
    const std::string text = ReadTextFile(path);
    MeshText lines(path, text);
    std::optional<std::string> material;
    while (lines.Next()) {
      if (lines.words().front() == "newmtl") material = lines.From(1);
      if (lines.words().front() != "Kd" || !material) continue;
      mesh_.diffuse[*material] = {lines.Number(1), lines.Number(2), lines.Number(3)};
    }
  }

  fs::path path_;
  MeshText lines_;
  SurfaceMesh mesh_;
  std::vector<std::uint32_t> corners_, texture_;
};

}  // namespace

SurfaceMesh ParseObj(const fs::path& path, std::string_view text) {
  return ObjParser(path, text).Parse();
}

}  // namespace handcraft::datasets
