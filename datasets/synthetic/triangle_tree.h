// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "datasets/synthetic/mesh.h"
#include "datasets/synthetic/oriented_box.h"

namespace handcraft::synthetic {

/// A mesh's triangles in a tree of axis-aligned boxes, to find quickly whether a box touches its
/// surface. (A box wholly within a closed mesh touches no surface.) May be asked by many threads.
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh);

  /// Whether any triangle has a point in common with the box, which is in the mesh's frame.
  [[nodiscard]] bool Touches(const OrientedBox& box) const;

 private:
  struct Node {
    Eigen::AlignedBox3f box;
    std::uint32_t begin = 0;  ///< triangles of a leaf
    std::uint32_t end = 0;
    std::uint32_t right = 0;  ///< its left child follows a node; 0 for a leaf
  };

  void Build(std::span<Triangle> triangles, std::uint32_t begin);
  [[nodiscard]] bool AnyTouches(const Node& leaf, const OrientedBox& box) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace handcraft::synthetic
