// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/loft.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;

Vector2f Direction(float angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

float Fraction(int i, int count) { return static_cast<float>(i) / static_cast<float>(count); }

void AddStrip(Mesh& mesh, std::uint32_t first, std::uint32_t second, std::uint32_t n, Surface s) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.faces.push_back({{first + i, first + next, second + next}, s});
    mesh.faces.push_back({{first + i, second + next, second + i}, s});
  }
}

enum class Facing { kAlong, kAgainst };

void AddCap(Mesh& mesh, std::uint32_t first, const Section& section, Facing facing) {
  Vector3f mean = Vector3f::Zero();
  for (const Vector3f& point : section.ring) mean += point;
  const auto n = static_cast<std::uint32_t>(section.ring.size());
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(mean / static_cast<float>(n));
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t from = first + i;
    std::uint32_t to = first + (i + 1) % n;
    if (facing == Facing::kAgainst) std::swap(from, to);
    mesh.faces.push_back({{middle, from, to}, section.surface});
  }
}

// Unit tangents of the outside, pointing along it.
Vector2f TangentAt(const Profile& profile, std::size_t i) {
  const ProfilePoint& before = profile[i == 0 ? 0 : i - 1];
  const ProfilePoint& after = profile[std::min(i + 1, profile.size() - 1)];
  return Vector2f(after.radius_m - before.radius_m, after.height_m - before.height_m).normalized();
}

// The half circle from the outside of the rim to its inside.
void AddRim(Profile& profile, const ProfilePoint& top, const Vector2f& tangent, float wall_m) {
  const Vector2f inward(-tangent.y(), tangent.x());
  const Vector2f middle = Vector2f(top.radius_m, top.height_m) + 0.5F * wall_m * inward;
  constexpr int kSteps = 4;
  for (int i = 1; i < kSteps; ++i) {
    const Vector2f turn = Direction(kPi * Fraction(i, kSteps));
    const Vector2f at = middle + 0.5F * wall_m * (turn.y() * tangent - turn.x() * inward);
    profile.push_back({at.x(), at.y(), top.surface});
  }
}

}  // namespace

float CatmullRom(const std::array<float, 4>& values, float t) {
  const auto& p = values;
  return p[1] + 0.5F * t *
                    (p[2] - p[0] +
                     t * (2.0F * p[0] - 5.0F * p[1] + 4.0F * p[2] - p[3] +
                          t * (3.0F * (p[1] - p[2]) + p[3] - p[0])));
}

Mesh Loft(std::span<const Section> sections, Ends ends) {
  HC_CHECK(sections.size() >= 2, sections.size());
  const std::size_t size = sections.front().ring.size();
  HC_CHECK(size >= 3, size);
  Mesh mesh;
  for (const Section& section : sections) {
    HC_CHECK(section.ring.size() == size, section.ring.size(), size);
    mesh.vertices.insert(mesh.vertices.end(), section.ring.begin(), section.ring.end());
  }
  const auto n = static_cast<std::uint32_t>(size);
  const auto count = static_cast<std::uint32_t>(sections.size());
  const std::uint32_t num_strips = ends == Ends::kJoined ? count : count - 1;
  for (std::uint32_t i = 0; i < num_strips; ++i) {
    AddStrip(mesh, i * n, (i + 1) % count * n, n, sections[i].surface);
  }
  if (ends == Ends::kCapped) {
    AddCap(mesh, 0, sections.front(), Facing::kAgainst);
    AddCap(mesh, (count - 1) * n, sections.back(), Facing::kAlong);
  }
  return mesh;
}

Mesh Revolve(const Profile& profile, Ends ends, int num_segments) {
  std::vector<Section> sections;
  for (const ProfilePoint& point : profile) {
    HC_CHECK(point.radius_m > 0.0F, point.radius_m);
    Section section{.ring = {}, .surface = point.surface};
    for (int i = 0; i < num_segments; ++i) {
      const Vector2f at = point.radius_m * Direction(2.0F * kPi * Fraction(i, num_segments));
      section.ring.emplace_back(at.x(), at.y(), point.height_m);
    }
    sections.push_back(std::move(section));
  }
  return Loft(sections, ends);
}

Profile SmoothProfile(const Profile& profile, int steps) {
  Profile smooth;
  const std::size_t last = profile.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const ProfilePoint& before = profile[i == 0 ? 0 : i - 1];
    const ProfilePoint& from = profile[i];
    const ProfilePoint& to = profile[i + 1];
    const ProfilePoint& after = profile[std::min(i + 2, last)];
    for (int step = 0; step < steps; ++step) {
      const float t = Fraction(step, steps);
      smooth.push_back(
          {CatmullRom({before.radius_m, from.radius_m, to.radius_m, after.radius_m}, t),
           CatmullRom({before.height_m, from.height_m, to.height_m, after.height_m}, t),
           from.surface});
    }
  }
  smooth.push_back(profile.back());
  return smooth;
}

Profile WalledProfile(const Profile& outside, float wall_m) {
  HC_CHECK(outside.size() >= 2 && wall_m > 0.0F, outside.size(), wall_m);
  Profile profile = outside;
  const std::size_t last = outside.size() - 1;
  AddRim(profile, outside[last], TangentAt(outside, last), wall_m);
  const float floor_m = outside.front().height_m + wall_m;
  float radius_m = outside[last].radius_m - wall_m;
  for (std::size_t i = outside.size(); i-- > 0;) {
    const Vector2f tangent = TangentAt(outside, i);
    const float height_m = outside[i].height_m + wall_m * tangent.x();
    if (height_m < floor_m + 0.5F * wall_m) break;
    radius_m = std::max(outside[i].radius_m - wall_m * tangent.y(), wall_m);
    profile.push_back({radius_m, height_m, outside[i == 0 ? 0 : i - 1].surface});
  }
  profile.push_back({0.8F * radius_m, floor_m, outside.front().surface});
  return profile;
}

void MarkBetween(Profile& profile, float low_m, float high_m) {
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const float middle_m = 0.5F * (profile[i].height_m + profile[i + 1].height_m);
    if (middle_m >= low_m && middle_m <= high_m) profile[i].surface.graspable = true;
  }
}

Outline RoundedRectangle(const Vector2f& size_m, float corner_radius_m) {
  HC_CHECK(2.0F * corner_radius_m <= size_m.minCoeff(), corner_radius_m, size_m.minCoeff());
  constexpr int kSteps = 6;
  const Vector2f core = 0.5F * size_m - Vector2f::Constant(corner_radius_m);
  Outline outline;
  for (int corner = 0; corner < 4; ++corner) {
    const Vector2f middle(corner == 0 || corner == 3 ? core.x() : -core.x(),
                          corner < 2 ? core.y() : -core.y());
    for (int i = 0; i <= kSteps; ++i) {
      const Vector2f normal =
          Direction(0.5F * kPi * (static_cast<float>(corner) + Fraction(i, kSteps)));
      outline.points.emplace_back(middle + corner_radius_m * normal);
      outline.normals.push_back(normal);
    }
  }
  return outline;
}

Outline Ellipse(const Vector2f& semi_axes_m, int num_points) {
  Outline outline;
  for (int i = 0; i < num_points; ++i) {
    const Vector2f on_circle = Direction(2.0F * kPi * Fraction(i, num_points));
    outline.points.emplace_back(semi_axes_m.cwiseProduct(on_circle));
    outline.normals.emplace_back(on_circle.cwiseQuotient(semi_axes_m).normalized());
  }
  return outline;
}

Outline RegularPolygon(float circumradius_m, int num_corners) {
  return Ellipse(Vector2f::Constant(circumradius_m), num_corners);
}

Mesh Extrude(const Outline& outline, std::span<const Station> stations) {
  std::vector<Section> sections;
  for (const Station& station : stations) {
    Section section{.ring = {}, .surface = station.surface};
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      const Vector2f at = outline.points[i] - station.inset_m * outline.normals[i];
      section.ring.emplace_back(at.x(), at.y(), station.height_m);
    }
    sections.push_back(std::move(section));
  }
  return Loft(sections, Ends::kCapped);
}

std::vector<Station> RoundedStations(float height_m,
                                     float radius_m,
                                     Surface surface,
                                     int num_spans) {
  HC_CHECK(2.0F * radius_m <= height_m && num_spans >= 1, radius_m, height_m, num_spans);
  constexpr int kSteps = 4;
  std::vector<Station> stations;
  const auto add_quarter = [&](float middle_m, float first_rad) {
    for (int i = 0; i <= kSteps; ++i) {
      const Vector2f turn = Direction(first_rad + 0.5F * kPi * Fraction(i, kSteps));
      stations.push_back({middle_m + radius_m * turn.y(), radius_m * (1.0F - turn.x()), surface});
    }
  };
  const float straight_m = height_m - 2.0F * radius_m;
  add_quarter(radius_m, -0.5F * kPi);
  for (int i = 1; i < num_spans; ++i) {
    stations.push_back({radius_m + straight_m * Fraction(i, num_spans), 0.0F, surface});
  }
  add_quarter(height_m - radius_m, 0.0F);
  return stations;
}

Mesh RoundedBox(const Eigen::Vector3f& size_m, float radius_m, Surface surface) {
  // The corners' radius is a little greater than the edges', so that no cap shrinks to a point.
  const float corner_m = std::min(1.2F * radius_m, 0.5F * size_m.head<2>().minCoeff());
  return Extrude(RoundedRectangle(size_m.head<2>(), corner_m),
                 RoundedStations(size_m.z(), radius_m, surface));
}

Mesh Sweep(std::span<const PathPoint> path, const Vector3f& side, int num_segments) {
  HC_CHECK(path.size() >= 2, path.size());
  std::vector<Section> sections;
  Vector3f carried = side;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3f& before = path[i == 0 ? 0 : i - 1].position_m;
    const Vector3f& after = path[std::min(i + 1, path.size() - 1)].position_m;
    const Vector3f tangent = (after - before).normalized();
    carried = (carried - carried.dot(tangent) * tangent).normalized();
    const Vector3f across = tangent.cross(carried);
    Section section{.ring = {}, .surface = path[i].surface};
    for (int k = 0; k < num_segments; ++k) {
      const Vector2f at =
          path[i].semi_axes_m.cwiseProduct(Direction(2.0F * kPi * Fraction(k, num_segments)));
      section.ring.emplace_back(path[i].position_m + at.x() * carried + at.y() * across);
    }
    sections.push_back(std::move(section));
  }
  return Loft(sections, Ends::kCapped);
}

}  // namespace handcraft::synthetic
