// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "datasets/synthetic/loft.h"
#include "datasets/synthetic/material.h"
#include "datasets/synthetic/mesh.h"
#include "lib/core/rng.h"

/// Parts that bottles, cans, tools and boxes are put together from. Measures are the builders' own;
/// lengths in metres.
namespace handcraft::synthetic {

/// A cross-section of a body that stands about the z axis: the superellipse
/// |(x − shift)/a|ⁿ + |y/b|ⁿ = 1 with semi-axes (a, b). n = 2 is an ellipse, 4 … 8 a rectangle with
/// round corners.
struct BodySection {
  float height_m = 0.0F;
  Eigen::Vector2f semi_axes_m = Eigen::Vector2f::Zero();  ///< > 0
  float power = 2.0F;                                     ///< n ≥ 2
  float shift_x_m = 0.0F;                                 ///< of the middle
  Surface surface;
};

/// More sections along the curve through the given ones (Catmull–Rom, the ends doubled), `steps` a
/// span; each takes the surface of the section before it. Sections at the same height stay an edge.
[[nodiscard]] std::vector<BodySection> SmoothSections(std::span<const BodySection> sections,
                                                      int steps);

/// The closed body through the sections, given upwards.
[[nodiscard]] Mesh LoftBody(std::span<const BodySection> sections);

/// More points along the curve through the given ones (Catmull–Rom, the ends doubled), `steps` a
/// span; each takes the surface of the point before it.
[[nodiscard]] std::vector<PathPoint> SmoothPath(std::span<const PathPoint> path, int steps);

/// A screw cap on z = 0 … height_m: a cylinder with upright ridges, rounded above.
[[nodiscard]] Mesh RidgedCap(float radius_m, float height_m, int num_ridges, Surface surface);

/// The mesh moved.
[[nodiscard]] Mesh MovedBy(Mesh mesh, const Eigen::Vector3f& offset_m);

/// What was built along z turned along x: z becomes x, x becomes y, y becomes z.
[[nodiscard]] Mesh TurnedAlongX(Mesh mesh);

/// Moves the middle of the box around the mesh onto the z axis and its lowest vertex onto z = 0.
void CentreOnTable(Mesh& mesh);

/// Changes the surface of every face whose centroid `is_there` says to: is_there(centroid, normal).
template <class IsThere>
void Resurface(Mesh& mesh, Surface surface, const IsThere& is_there) {
  for (Face& face : mesh.faces) {
    const Eigen::Vector3f& a = mesh.vertices[face.vertices[0]];
    const Eigen::Vector3f& b = mesh.vertices[face.vertices[1]];
    const Eigen::Vector3f& c = mesh.vertices[face.vertices[2]];
    const Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
    if (is_there((a + b + c) / 3.0F, normal)) face.surface = surface;
  }
}

/// Marks as graspable the faces whose centroid lies between two heights, and no others.
void MarkHeights(Mesh& mesh, float low_m, float high_m);

/// Print on a package: bands, emblems and text in two colours that differ.
[[nodiscard]] Material DrawLabel(Rng& rng);

/// Matt dark rubber or plastic, of grips, chucks and feet.
[[nodiscard]] Material DrawDarkRubber(Rng& rng);

/// A strong colour, of tools and caps.
[[nodiscard]] Material DrawVividPlastic(Rng& rng);

}  // namespace handcraft::synthetic
