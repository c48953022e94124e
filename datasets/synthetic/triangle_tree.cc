// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

constexpr std::size_t kMostInLeaf = 4;
constexpr std::size_t kDeepest = 40;  // halves of 2³² triangles

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) {
  triangles_.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    triangles_.push_back({mesh.vertices[face.vertices[0]],
                          mesh.vertices[face.vertices[1]],
                          mesh.vertices[face.vertices[2]]});
  }
  if (!triangles_.empty()) Build(triangles_, 0);
}

// Halves the triangles at the median of their middles along the longest side.
void TriangleTree::Build(std::span<Triangle> triangles, std::uint32_t begin) {
  const std::size_t at = nodes_.size();
  Node node;
  node.begin = begin;
  node.end = begin + static_cast<std::uint32_t>(triangles.size());
  for (const Triangle& triangle : triangles) {
    for (const Vector3f& corner : triangle) node.box.extend(corner);
  }
  nodes_.push_back(node);
  if (triangles.size() <= kMostInLeaf) return;
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const auto middle = [axis](const Triangle& triangle) {
    return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
  };
  const std::size_t half = triangles.size() / 2;
  std::nth_element(triangles.begin(),
                   triangles.begin() + static_cast<std::ptrdiff_t>(half),
                   triangles.end(),
                   [&](const Triangle& a, const Triangle& b) { return middle(a) < middle(b); });
  Build(triangles.first(half), begin);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  Build(triangles.subspan(half), begin + static_cast<std::uint32_t>(half));
}

bool TriangleTree::AnyTouches(const Node& leaf, const OrientedBox& box) const {
  const std::span<const Triangle> triangles(triangles_);
  const auto own = triangles.subspan(leaf.begin, leaf.end - leaf.begin);
  return std::any_of(
      own.begin(), own.end(), [&](const Triangle& triangle) { return Overlap(box, triangle); });
}

bool TriangleTree::Touches(const OrientedBox& box) const {
  if (nodes_.empty()) return false;
  const Eigen::AlignedBox3f around = Around(box);
  std::array<std::uint32_t, kDeepest> waiting{};
  std::size_t num_waiting = 1;
  while (num_waiting > 0) {
    const std::uint32_t at = waiting[--num_waiting];
    const Node& node = nodes_[at];
    if (!node.box.intersects(around)) continue;
    if (node.right == 0) {
      if (AnyTouches(node, box)) return true;
      continue;
    }
    HC_CHECK(num_waiting + 2 <= kDeepest, num_waiting);
    waiting[num_waiting++] = node.right;
    waiting[num_waiting++] = at + 1;
  }
  return false;
}

}  // namespace handcraft::synthetic
