// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/stl_mesh.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "datasets/formats/mesh_text.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is read as it lies in memory");

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFaceBytes = 50;

std::uint32_t NumFaces(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes - sizeof count, sizeof count);
  return count;
}

SurfaceMesh ParseBinary(const std::filesystem::path& path, std::string_view bytes) {
  SurfaceMesh mesh;
  mesh.parts.emplace_back();
  const std::uint32_t count = NumFaces(bytes);
  mesh.vertices.reserve(std::size_t{3} * count);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + kFaceBytes * i + 12;
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3f vertex(
          numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]);
      if (!vertex.allFinite()) {
        throw Error({.path = path.string(),
                     .byte = at + 12 * corner,
                     .reason = "a vertex of face " + std::to_string(i) + " is not finite"});
      }
      mesh.vertices.push_back(vertex);
    }
    mesh.AddFace(std::array<std::uint32_t, 3>{first, first + 1, first + 2}, {}, 0);
  }
  return mesh;
}

class StlText {
 public:
  StlText(const std::filesystem::path& path, std::string_view text) : lines_(path, text) {}

  SurfaceMesh Parse() {
    while (lines_.Next()) ParseSolid();
    return std::move(mesh_);
  }

 private:
  void ParseSolid() {
    Require("solid", 0);
    mesh_.parts.push_back({.object = lines_.From(1), .group = {}, .material = {}});
    for (Advance("endsolid"); lines_.words().front() != "endsolid"; Advance("endsolid")) {
      ParseFacet();
    }
  }

  void ParseFacet() {
    Require("facet", 0);
    Advance("outer loop");
    Require("outer", 0);
    Require("loop", 1);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int i = 0; i < 3; ++i) {
      Advance("vertex");
      Require("vertex", 0);
      mesh_.vertices.emplace_back(lines_.Number(1), lines_.Number(2), lines_.Number(3));
    }
    Advance("endloop");
    Require("endloop", 0);
    Advance("endfacet");
    Require("endfacet", 0);
    mesh_.AddFace(std::array<std::uint32_t, 3>{first, first + 1, first + 2},
                  {},
                  static_cast<std::uint32_t>(mesh_.parts.size() - 1));
  }

  void Advance(const std::string& due) {
    if (!lines_.Next()) lines_.Fail("the file ends here; " + due + " is due", "get it whole");
  }

  void Require(std::string_view word, std::size_t i) const {
    if (lines_.words().size() <= i || lines_.words()[i] != word) {
      lines_.Fail("\"" + std::string(word) + "\" is due here");
    }
  }

  MeshText lines_;
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh ParseStl(const std::filesystem::path& path, std::string_view bytes) {
  const bool can_be_binary = bytes.size() >= kHeaderBytes;
  const std::uint64_t due =
      can_be_binary ? kHeaderBytes + std::uint64_t{kFaceBytes} * NumFaces(bytes) : kHeaderBytes;
  if (can_be_binary && bytes.size() == due) return ParseBinary(path, bytes);
  if (bytes.starts_with("solid")) return StlText(path, bytes).Parse();
  const std::string count = can_be_binary ? std::to_string(NumFaces(bytes)) : "its head";
  throw Error({.path = path.string(),
               .byte = bytes.size(),
               .reason = "has " + std::to_string(bytes.size()) + " bytes; " + std::to_string(due) +
                         " are due for " + count + (can_be_binary ? " faces" : ""),
               .remedy = "get it whole"});
}

}  // namespace handcraft::datasets
