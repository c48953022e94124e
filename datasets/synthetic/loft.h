// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "datasets/synthetic/mesh.h"

/// Builders of closed meshes. All of them string rings of points together; lengths in metres.
namespace handcraft::synthetic {

/// A ring of points, counter-clockwise about the direction in which the rings follow each other,
/// and the surface of the strip from it to the next ring (of the cap, for the last).
struct Section {
  std::vector<Eigen::Vector3f> ring;
  Surface surface;
};

enum class Ends {
  kCapped,  ///< the first and the last ring are closed by a fan about their mean point
  kJoined,  ///< the last ring is joined to the first
};

/// Joins at least two rings of the same number (≥ 3) of points into a closed mesh.
[[nodiscard]] Mesh Loft(std::span<const Section> sections, Ends ends);

/// A point of the outline that is turned about the z axis, with the surface of what follows it.
struct ProfilePoint {
  float radius_m = 0.0F;  ///< > 0
  float height_m = 0.0F;
  Surface surface;
};
using Profile = std::vector<ProfilePoint>;

/// Surface of revolution about z. The profile runs up the outside and down the inside.
[[nodiscard]] Mesh Revolve(const Profile& profile, Ends ends, int num_segments = 64);

/// Catmull and Rom's spline between the second and the third of four values, 0 ≤ t ≤ 1.
[[nodiscard]] float CatmullRom(const std::array<float, 4>& values, float t);

/// More points along the curve through the given ones (Catmull–Rom, the ends doubled), `steps` a
/// span; each takes the surface of the point before it.
[[nodiscard]] Profile SmoothProfile(const Profile& profile, int steps);

/// From the outside of a vessel, foot to rim, the whole profile of its wall: up the outside, round
/// the rim, and down the inside at distance `wall_m`, to a floor as thick as the wall.
[[nodiscard]] Profile WalledProfile(const Profile& outside, float wall_m);

/// Marks as graspable what lies between two heights.
void MarkBetween(Profile& profile, float low_m, float high_m);

/// A closed curve in the plane, counter-clockwise, with its outward normals.
struct Outline {
  std::vector<Eigen::Vector2f> points;
  std::vector<Eigen::Vector2f> normals;
};
[[nodiscard]] Outline RoundedRectangle(const Eigen::Vector2f& size_m, float corner_radius_m);
[[nodiscard]] Outline Ellipse(const Eigen::Vector2f& semi_axes_m, int num_points = 48);
/// Corners on a circle; the normals are those of the circle.
[[nodiscard]] Outline RegularPolygon(float circumradius_m, int num_corners);

/// Where along z an outline is placed, moved inwards by `inset_m` along its normals.
struct Station {
  float height_m = 0.0F;
  float inset_m = 0.0F;
  Surface surface;
};

[[nodiscard]] Mesh Extrude(const Outline& outline, std::span<const Station> stations);

/// Stations of a body from z = 0 to `height_m` whose two ends are rounded by quarter circles of
/// `radius_m`, at most half the height; the straight part is cut into `num_spans`.
[[nodiscard]] std::vector<Station> RoundedStations(float height_m,
                                                   float radius_m,
                                                   Surface surface,
                                                   int num_spans = 1);

/// A box of the given size about the z axis, z from 0, all edges rounded.
[[nodiscard]] Mesh RoundedBox(const Eigen::Vector3f& size_m, float radius_m, Surface surface);

/// A point of a curve along which an ellipse is drawn.
struct PathPoint {
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Eigen::Vector2f semi_axes_m = Eigen::Vector2f::Zero();  ///< along the side, and across it
  Surface surface;
};

/// A tube along the curve. `side` is a direction, not along the curve's beginning, for the first
/// semi-axis; it is carried along without twist.
[[nodiscard]] Mesh Sweep(std::span<const PathPoint> path,
                         const Eigen::Vector3f& side,
                         int num_segments = 16);

}  // namespace handcraft::synthetic
