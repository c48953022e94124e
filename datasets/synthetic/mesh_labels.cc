// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh_labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "datasets/formats/mesh_text.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using datasets::SurfaceMesh;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kWithinM = 0.002F;  // what still counts as within a convex part
constexpr float kSmallM = 0.002F;   // a triangle that the edge of a part need not cut
constexpr std::size_t kMostTriangles = 1000000;

[[noreturn]] void Refuse(const fs::path& path, std::string reason, std::string remedy) {
  throw Error({.path = path.string(), .reason = std::move(reason), .remedy = std::move(remedy)});
}

// The graspable triangles of a file.
using Flags = std::vector<bool>;

Flags LabelByName(const fs::path& path,
                  const SurfaceMesh& mesh,
                  const std::vector<std::string>& names) {
  Flags flags(mesh.triangles.size(), false);
  for (const std::string& name : names) {
    bool is_borne = false;
    for (std::size_t i = 0; i < flags.size(); ++i) {
      const SurfaceMesh::Part& part = mesh.parts[mesh.triangles[i].part];
      if (part.object != name && part.group != name && part.material != name) continue;
      flags[i] = is_borne = true;
    }
    if (!is_borne) {
      Refuse(path,
             "no face has the object, group or material \"" + name + "\"",
             "give a name that the file has");
    }
  }
  return flags;
}

Flags LabelByLines(const fs::path& path, const SurfaceMesh& mesh) {
  const std::string text = ReadTextFile(path);
  datasets::MeshText lines(path, text);
  Flags faces;
  while (lines.Next()) {
    if (lines.words().size() != 1) lines.Fail("one label a line is due: 0 or 1");
    faces.push_back(lines.Whole(0, 0, 1) == 1);
  }
  if (faces.size() != mesh.num_faces) {
    Refuse(path,
           "has " + std::to_string(faces.size()) + " labels; the mesh has " +
               std::to_string(mesh.num_faces) + " faces",
           "give a line a face, in the mesh file's order");
  }
  Flags flags;
  for (const SurfaceMesh::Triangle& triangle : mesh.triangles)
    flags.push_back(faces[triangle.face]);
  return flags;
}

// The half-spaces n · p ≤ d whose intersection a convex mesh is, whichever way its faces turn.
struct HalfSpace {
  Vector3f normal;
  float distance_m = 0.0F;
};

std::vector<HalfSpace> HalfSpacesOf(const SurfaceMesh& part) {
  Vector3f middle = Vector3f::Zero();
  for (const Vector3f& vertex : part.vertices) middle += vertex;
  middle /= static_cast<float>(part.vertices.size());
  std::vector<HalfSpace> spaces;
  for (const SurfaceMesh::Triangle& triangle : part.triangles) {
    const Vector3f& a = part.vertices[triangle.vertices[0]];
    Vector3f normal = (part.vertices[triangle.vertices[1]] - a)
                          .cross(part.vertices[triangle.vertices[2]] - a)
                          .normalized();
    if (!normal.allFinite() || normal.isZero()) continue;
    if (normal.dot(middle - a) > 0.0F) normal = -normal;
    spaces.push_back({normal, normal.dot(a)});
  }
  return spaces;
}

// Whether a place on the surface, and in the texture, is graspable.
using IsGraspable = std::function<bool(const Vector3f& at, const Vector2f& uv)>;
// Whether a triangle is too small to be cut.
using IsSmall = std::function<bool(const SurfaceMesh& mesh, const SurfaceMesh::Triangle& triangle)>;

class LabelCutter {
 public:
  LabelCutter(SurfaceMesh& mesh, IsGraspable is_graspable, IsSmall is_small)
      : mesh_(mesh), is_graspable_(std::move(is_graspable)), is_small_(std::move(is_small)) {}

  Flags CutAndLabel() {
    std::vector<SurfaceMesh::Triangle> whole;
    std::swap(whole, mesh_.triangles);
    for (const SurfaceMesh::Triangle& triangle : whole) Cut(triangle, 0);
    return std::move(flags_);
  }

 private:
  void Cut(const SurfaceMesh::Triangle& triangle, int depth) {
    constexpr int kDeepest = 7;
    const bool is_room = mesh_.triangles.size() < kMostTriangles;
    if (depth == kDeepest || !is_room || is_small_(mesh_, triangle) || HasOneLabel(triangle)) {
      mesh_.triangles.push_back(triangle);
      flags_.push_back(LabelAt(triangle, Vector3f::Constant(1.0F / 3.0F)));
      return;
    }
    SurfaceMesh::Triangle middle = triangle;  // its corners: the middles of the edges from each
    for (std::size_t i = 0; i < 3; ++i) AddMiddle(triangle, i, middle);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t before = (i + 2) % 3;
      SurfaceMesh::Triangle corner = triangle;
      corner.vertices = {triangle.vertices[i], middle.vertices[i], middle.vertices[before]};
      corner.texture = {triangle.texture[i], middle.texture[i], middle.texture[before]};
      Cut(corner, depth + 1);
    }
    Cut(middle, depth + 1);
  }

  void AddMiddle(const SurfaceMesh::Triangle& triangle,
                 std::size_t corner,
                 SurfaceMesh::Triangle& middle) {
    const std::size_t next = (corner + 1) % 3;
    middle.vertices[corner] = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.emplace_back(0.5F * (mesh_.vertices[triangle.vertices[corner]] +
                                        mesh_.vertices[triangle.vertices[next]]));
    if (triangle.texture[0] == SurfaceMesh::kNone) return;
    middle.texture[corner] = static_cast<std::uint32_t>(mesh_.texture_coordinates.size());
    mesh_.texture_coordinates.emplace_back(0.5F *
                                           (mesh_.texture_coordinates[triangle.texture[corner]] +
                                            mesh_.texture_coordinates[triangle.texture[next]]));
  }

  // The label at the point with these weights of the corners.
  [[nodiscard]] bool LabelAt(const SurfaceMesh::Triangle& triangle, const Vector3f& weights) const {
    Vector3f at = Vector3f::Zero();
    Vector2f uv = Vector2f::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const float weight = weights[static_cast<Eigen::Index>(i)];
      at += weight * mesh_.vertices[triangle.vertices[i]];
      if (triangle.texture[i] == SurfaceMesh::kNone) continue;
      uv += weight * mesh_.texture_coordinates[triangle.texture[i]];
    }
    return is_graspable_(at, uv);
  }

  // Looks along the edges and the lines to the middle in steps of an eighth.
  [[nodiscard]] bool HasOneLabel(const SurfaceMesh::Triangle& triangle) const {
    constexpr int kSteps = 8;
    const Vector3f middle = Vector3f::Constant(1.0F / 3.0F);
    const bool label = LabelAt(triangle, middle);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vector3f from = Vector3f::Unit(i);
      const Vector3f to = Vector3f::Unit((i + 1) % 3);
      for (int step = 0; step < kSteps; ++step) {
        const float t = static_cast<float>(step) / kSteps;
        if (LabelAt(triangle, from + t * (to - from)) != label) return false;
        if (LabelAt(triangle, from + t * (middle - from)) != label) return false;
      }
    }
    return true;
  }

  SurfaceMesh& mesh_;
  IsGraspable is_graspable_;
  IsSmall is_small_;
  Flags flags_;
};

Flags LabelByParts(SurfaceMesh& mesh, const MeshFileOptions& options) {
  std::vector<std::vector<HalfSpace>> parts;
  for (const fs::path& path : options.parts) {
    SurfaceMesh part = datasets::ReadSurfaceMesh(path);
    const Eigen::Matrix3f object_from_file = options.ObjectFromFile();
    for (Vector3f& vertex : part.vertices) vertex = object_from_file * vertex;
    parts.push_back(HalfSpacesOf(part));
    if (parts.back().size() < 4) Refuse(path, "encloses no volume; a convex part does", "");
  }
  const auto is_within = [&](const Vector3f& at, const Vector2f&) {
    return std::any_of(parts.begin(), parts.end(), [&](const std::vector<HalfSpace>& part) {
      return std::all_of(part.begin(), part.end(), [&](const HalfSpace& space) {
        return space.normal.dot(at) <= space.distance_m + kWithinM;
      });
    });
  };
  const auto is_small = [](const SurfaceMesh& whole, const SurfaceMesh::Triangle& triangle) {
    const Vector3f& a = whole.vertices[triangle.vertices[0]];
    const Vector3f& b = whole.vertices[triangle.vertices[1]];
    const Vector3f& c = whole.vertices[triangle.vertices[2]];
    return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) <= kSmallM;
  };
  return LabelCutter(mesh, is_within, is_small).CutAndLabel();
}

// A picture that the file's texture coordinates lead to; beyond its edges it goes on anew.
class LabelTexture {
 public:
  explicit LabelTexture(const fs::path& path)
      : image_(perception::ReadImage(path, perception::Channels::kGray)) {}

  [[nodiscard]] bool IsMarked(const Vector2f& uv) const {
    return image_.At(Pixel(uv.x(), image_.width()), Pixel(1.0F - uv.y(), image_.height())) >= 128;
  }

  [[nodiscard]] Vector2f ToPixels(const Vector2f& uv) const {
    return {uv.x() * static_cast<float>(image_.width()),
            uv.y() * static_cast<float>(image_.height())};
  }

 private:
  static int Pixel(float share, int size) {
    const auto pixel = static_cast<int>((share - std::floor(share)) * static_cast<float>(size));
    return std::min(pixel, size - 1);
  }

  Image image_;
};

Flags LabelByTexture(const fs::path& path, SurfaceMesh& mesh, const fs::path& texture_path) {
  for (const SurfaceMesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t at : triangle.texture) {
      if (at != SurfaceMesh::kNone && mesh.texture_coordinates[at].allFinite()) continue;
      Refuse(path,
             "face " + std::to_string(triangle.face) + " has no texture coordinates",
             "unwrap the mesh, or mark what is graspable in another way");
    }
  }
  const LabelTexture texture(texture_path);
  const auto is_marked = [&](const Vector3f&, const Vector2f& uv) { return texture.IsMarked(uv); };
  const auto is_small = [&](const SurfaceMesh& whole, const SurfaceMesh::Triangle& triangle) {
    constexpr float kSmallPx = 4.0F;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector2f& from = whole.texture_coordinates[triangle.texture[i]];
      const Vector2f& to = whole.texture_coordinates[triangle.texture[(i + 1) % 3]];
      if (!(texture.ToPixels(to - from).norm() <= kSmallPx)) return false;
    }
    return true;
  };
  return LabelCutter(mesh, is_marked, is_small).CutAndLabel();
}

}  // namespace

std::vector<bool> LabelTriangles(const fs::path& path,
                                 SurfaceMesh& mesh,
                                 const MeshFileOptions& options) {
  if (!options.names.empty()) return LabelByName(path, mesh, options.names);
  if (!options.texture.empty()) return LabelByTexture(path, mesh, options.texture);
  if (!options.face_labels.empty()) return LabelByLines(options.face_labels, mesh);
  return LabelByParts(mesh, options);
}

}  // namespace handcraft::synthetic
