// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "datasets/synthetic/loft.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using ::testing::HasSubstr;

// Möller and Trumbore's test of one triangle, in double precision: distance along the ray.
std::optional<double> MeetTriangle(const std::array<Vector3d, 3>& corners,
                                   const Vector3d& origin,
                                   const Vector3d& direction) {
  const Vector3d edge_b = corners[1] - corners[0];
  const Vector3d edge_c = corners[2] - corners[0];
  const Vector3d p = direction.cross(edge_c);
  const double determinant = edge_b.dot(p);
  if (determinant == 0.0) return std::nullopt;
  const Vector3d from_corner = origin - corners[0];
  const double b = from_corner.dot(p) / determinant;
  const Vector3d q = from_corner.cross(edge_b);
  const double c = direction.dot(q) / determinant;
  const double distance = edge_c.dot(q) / determinant;
  if (b < 0.0 || c < 0.0 || b + c > 1.0 || distance < 1e-4) return std::nullopt;
  return distance;
}

double BruteForce(const std::vector<Mesh>& meshes,
                  const Vector3f& origin,
                  const Vector3f& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Mesh& mesh : meshes) {
    for (const Face& face : mesh.faces) {
      std::array<Vector3d, 3> corners;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = mesh.vertices[face.vertices[i]].cast<double>();
      const auto distance = MeetTriangle(corners, origin.cast<double>(), direction.cast<double>());
      if (distance) nearest = std::min(nearest, *distance);
    }
  }
  return nearest;
}

std::vector<Mesh> TwoMeshes() {
  Mesh tape = Revolve(
      {{0.5F, 0.0F, {}}, {0.5F, 0.3F, {}}, {0.3F, 0.3F, {}}, {0.3F, 0.0F, {}}}, Ends::kJoined, 24);
  Mesh box = RoundedBox({0.4F, 0.3F, 0.5F}, 0.05F, {});
  Transform(box, Eigen::Isometry3f(Eigen::Translation3f(0.9F, 0.1F, 0.0F)));
  return {tape, box};
}

TEST(RayTracer, HitsAPlaneWhereItIs) {
  const Mesh box = RoundedBox({2.0F, 2.0F, 0.5F}, 0.01F, {});
  const RayTracer tracer(std::span(&box, 1));
  RayPacket rays;
  rays.Add({0.1F, 0.2F, 2.5F}, {0.0F, 0.0F, -1.0F}, 10.0F);
  rays.Add({0.1F, 0.2F, 2.5F}, {0.0F, 0.0F, -2.0F}, 10.0F);
  rays.Add({0.1F, 0.2F, 2.5F}, {0.0F, 0.0F, 1.0F}, 10.0F);
  const auto hits = tracer.Intersect(rays);
  EXPECT_FLOAT_EQ(hits[0].distance, 2.0F);
  EXPECT_FLOAT_EQ(hits[1].distance, 1.0F) << "in lengths of the direction";
  EXPECT_EQ(hits[0].mesh, 0U);
  EXPECT_EQ(hits[2].mesh, Hit::kNothing);
  EXPECT_EQ(hits[3].mesh, Hit::kNothing) << "not cast";
  EXPECT_EQ(tracer.IsBlocked(rays), (std::array<bool, 4>{true, true, false, false}));
}

TEST(RayTracer, AgreesWithBruteForce) {
  const std::vector<Mesh> meshes = TwoMeshes();
  const RayTracer tracer(meshes);
  Rng rng = Rng::Stream(1, "rays");
  const auto draw = [&](float reach) {
    return reach * static_cast<float>(2.0 * rng.Uniform() - 1.0);
  };
  int num_hits = 0;
  for (int i = 0; i < 1000; ++i) {
    RayPacket rays;
    for (int k = 0; k < 4; ++k) {
      const Vector3f origin(draw(2.0F), draw(2.0F), draw(2.0F));
      const Vector3f to(draw(0.9F), draw(0.4F), 0.2F + draw(0.2F));
      rays.Add(origin, to - origin, 100.0F);
    }
    const auto hits = tracer.Intersect(rays);
    const auto blocked = tracer.IsBlocked(rays);
    for (std::size_t k = 0; k < 4; ++k) {
      const double expected = BruteForce(meshes, rays.origins[k], rays.directions[k]);
      EXPECT_EQ(hits[k].mesh == Hit::kNothing, std::isinf(expected));
      EXPECT_EQ(blocked[k], !std::isinf(expected));
      if (std::isinf(expected)) continue;
      ++num_hits;
      EXPECT_NEAR(hits[k].distance, expected, 1e-5) << "single precision";
    }
  }
  EXPECT_GT(num_hits, 1000);
}

TEST(RayTracer, StopsAtTheFarthestPoint) {
  const Mesh box = RoundedBox({2.0F, 2.0F, 0.5F}, 0.01F, {});
  const RayTracer tracer(std::span(&box, 1));
  RayPacket rays;
  rays.Add({0.0F, 0.0F, 2.5F}, {0.0F, 0.0F, -1.0F}, 1.9F);
  EXPECT_FALSE(tracer.IsBlocked(rays)[0]);
  EXPECT_EQ(tracer.Intersect(rays)[0].mesh, Hit::kNothing);
}

TEST(RayTracer, RefusesAnEmptyAndAnOverfullPacket) {
  const Mesh box = RoundedBox({2.0F, 2.0F, 0.5F}, 0.01F, {});
  const RayTracer tracer(std::span(&box, 1));
  RayPacket rays;
  EXPECT_THROWS_MESSAGE(tracer.Intersect(rays), std::logic_error, HasSubstr("rays.count"));
  for (int i = 0; i < 4; ++i) rays.Add(Vector3f::Zero(), Vector3f::UnitZ(), 1.0F);
  EXPECT_TRUE(rays.IsFull());
  EXPECT_THROW(rays.Add(Vector3f::Zero(), Vector3f::UnitZ(), 1.0F), std::logic_error);
}

}  // namespace
}  // namespace handcraft::synthetic
