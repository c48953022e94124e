// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <Eigen/Geometry>

namespace handcraft::synthetic {

/// A box with its middle at the origin of its own frame, anywhere in another.
struct OrientedBox {
  Eigen::Isometry3f frame_from_box = Eigen::Isometry3f::Identity();
  Eigen::Vector3f half_size_m = Eigen::Vector3f::Zero();
};

/// The corners of a triangle, in the frame of the boxes.
using Triangle = std::array<Eigen::Vector3f, 3>;

/// The box between two corners of an axis-aligned one, moved by a motion.
[[nodiscard]] OrientedBox MovedBox(const Eigen::AlignedBox3f& box,
                                   const Eigen::Isometry3f& frame_from_source);

/// The smallest axis-aligned box around it.
[[nodiscard]] Eigen::AlignedBox3f Around(const OrientedBox& box);

/// Whether two boxes have a point in common: none of the 15 axes on which convex polyhedra of these
/// kinds can be told apart does so (separating axis theorem). Boxes that touch, or miss each other
/// by less than a micrometre, count as overlapping.
/// Source: Gottschalk, Lin and Manocha, "OBBTree", 1996, section 5.
[[nodiscard]] bool Overlap(const OrientedBox& a, const OrientedBox& b);

/// The same for a box and a triangle, whose plane and edges give 13 axes. A triangle may have no
/// area. Source: Akenine-Möller, "Fast 3D triangle-box overlap testing", 2001.
[[nodiscard]] bool Overlap(const OrientedBox& box, const Triangle& triangle);

}  // namespace handcraft::synthetic
