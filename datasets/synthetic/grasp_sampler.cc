// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "datasets/synthetic/draw.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;

// Draws points of a surface, each area alike.
class SurfacePoints {
 public:
  explicit SurfacePoints(const Mesh& mesh) : mesh_(mesh) {
    double sum = 0.0;
    for (const Face& face : mesh.faces) {
      const Vector3f& a = mesh.vertices[face.vertices[0]];
      const Vector3f normal =
          (mesh.vertices[face.vertices[1]] - a).cross(mesh.vertices[face.vertices[2]] - a);
      sum += static_cast<double>(normal.norm());
      area_up_to_.push_back(sum);
    }
    HC_CHECK(sum > 0.0, sum);
  }

  struct Point {
    Vector3f position_m;
    std::uint32_t face = 0;
  };

  [[nodiscard]] Point Draw(Rng& rng) const {
    const double area = rng.Uniform() * area_up_to_.back();
    const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end(), area);
    const auto face = static_cast<std::uint32_t>(found - area_up_to_.begin());
    const auto& corners = mesh_.faces[face].vertices;
    // A point of the parallelogram, folded into the triangle.
    auto b = static_cast<float>(rng.Uniform());
    auto c = static_cast<float>(rng.Uniform());
    if (b + c > 1.0F) {
      b = 1.0F - b;
      c = 1.0F - c;
    }
    const Vector3f& a = mesh_.vertices[corners[0]];
    return {a + b * (mesh_.vertices[corners[1]] - a) + c * (mesh_.vertices[corners[2]] - a), face};
  }

 private:
  const Mesh& mesh_;
  std::vector<double> area_up_to_;
};

// Into the surface, evenly over the cross-section of its friction cone.
Vector3f DrawInwards(const Vector3f& normal, float friction, Rng& rng) {
  const float tangent = friction * std::sqrt(static_cast<float>(rng.Uniform()));
  const float turn_rad = Between(rng, 0.0F, kFullTurn);
  const Vector3f side = normal.unitOrthogonal();
  const Vector3f other_side = normal.cross(side);
  return (tangent * (std::cos(turn_rad) * side + std::sin(turn_rad) * other_side) - normal)
      .normalized();
}

// Where the line from a contact leaves the object: the first place, or the last one within the
// hand's opening.
struct Opposite {
  GraspFault fault = GraspFault::kNone;
  float width_m = 0.0F;
};

Opposite FindOpposite(const GraspCheck& check,
                      const Vector3f& contact_m,
                      const Vector3f& inwards,
                      bool last) {
  const float opening_m = check.gripper().max_opening_m;
  RayPacket rays;
  if (last) {
    rays.Add(contact_m + opening_m * inwards, -inwards, opening_m);
  } else {
    rays.Add(contact_m, inwards, opening_m);
  }
  const Hit hit = check.tracer().Intersect(rays)[0];
  if (hit.mesh == Hit::kNothing) return {GraspFault::kTooWide, 0.0F};
  const Vector3f normal = check.NormalOf(hit.face);
  const float width_m = last ? opening_m - hit.distance : hit.distance;
  const bool leaves = inwards.dot(normal) > 0.0F;
  if (!leaves || width_m > check.gripper().WidestM()) return {GraspFault::kTooWide, width_m};
  const bool holds = check.IsInFrictionCone(-inwards, normal);
  return {holds ? GraspFault::kNone : GraspFault::kSlips, width_m};
}

Isometry3f PoseAt(const Vector3f& centre_m, const Vector3f& closing, float turn_rad) {
  Isometry3f pose = Isometry3f::Identity();
  const Vector3f side = closing.unitOrthogonal();
  const Vector3f approach = std::cos(turn_rad) * side + std::sin(turn_rad) * closing.cross(side);
  pose.linear().col(0) = closing;
  pose.linear().col(1) = approach.cross(closing);
  pose.linear().col(2) = approach;
  pose.translation() = centre_m;
  return pose;
}

}  // namespace

void GraspCounts::Add(const GraspCounts& other) {
  for (std::size_t i = 0; i < kNumGraspFaults; ++i) by_fault[i] += other.by_fault[i];
}

std::size_t GraspCounts::Total() const {
  return std::accumulate(by_fault.begin(), by_fault.end(), std::size_t{0});
}

std::string GraspCounts::ToText() const {
  std::array<std::size_t, kNumGraspFaults> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return by_fault[a] > by_fault[b];
  });
  std::string text = "of " + std::to_string(Total()) + " poses";
  for (const std::size_t fault : order) {
    if (by_fault[fault] == 0) break;
    text += (fault == order[0] ? " " : ", ") + std::to_string(by_fault[fault]) + " ";
    text += NameOf(static_cast<GraspFault>(fault));
  }
  return text;
}

void RequireGrasps(const std::vector<Grasp>& grasps,
                   std::string_view name,
                   const GraspCounts& counts) {
  if (!grasps.empty()) return;
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "the hand cannot hold the " + std::string(name) + ": " + counts.ToText()});
}

void GraspSamplerOptions::Validate() const {
  RequireOption(num_tries >= 1 && num_tries <= 10000000,
                "GraspSamplerOptions.num_tries",
                num_tries,
                "from 1 to 10000000");
  RequireOption(most_grasps >= 1 && most_grasps <= 1000000,
                "GraspSamplerOptions.most_grasps",
                most_grasps,
                "from 1 to 1000000");
  RequireOption(num_approaches >= 1 && num_approaches <= 360,
                "GraspSamplerOptions.num_approaches",
                num_approaches,
                "from 1 to 360");
}

std::vector<Grasp> SampleGrasps(const GraspCheck& check,
                                const GraspSamplerOptions& options,
                                Rng& rng,
                                GraspCounts& counts) {
  options.Validate();
  const SurfacePoints points(check.object());
  const auto enough = static_cast<std::size_t>(options.most_grasps);
  std::vector<Grasp> grasps;
  for (int tries = 0; tries < options.num_tries && grasps.size() < enough; ++tries) {
    const auto [contact_m, face] = points.Draw(rng);
    const Vector3f inwards = DrawInwards(check.NormalOf(face), check.rules().friction, rng);
    const Opposite opposite = FindOpposite(check, contact_m, inwards, Chance(rng, 0.5));
    if (opposite.fault != GraspFault::kNone) {
      counts.Add(opposite.fault);
      continue;
    }
    const Vector3f centre_m = contact_m + 0.5F * opposite.width_m * inwards;
    const Vector3f closing = Chance(rng, 0.5) ? inwards : Vector3f(-inwards);
    const float first_rad = Between(rng, 0.0F, kFullTurn);
    for (int turn = 0; turn < options.num_approaches; ++turn) {
      const float share = static_cast<float>(turn) / static_cast<float>(options.num_approaches);
      const Isometry3f pose = PoseAt(centre_m, closing, first_rad + kFullTurn * share);
      const GraspOutcome outcome = check.Close(pose);
      counts.Add(outcome.fault);
      if (outcome.fault == GraspFault::kNone) grasps.push_back({pose, outcome.contacts});
    }
  }
  return grasps;
}

}  // namespace handcraft::synthetic
