// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/mesh.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "datasets/synthetic/loft.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

Mesh Tetrahedron() {
  return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .faces = {{{0, 2, 1}, {}}, {{0, 1, 3}, {}}, {{0, 3, 2}, {}}, {{1, 2, 3}, {0, true}}}};
}

TEST(Mesh, HasTheVolumeAndTheAreasOfATetrahedron) {
  const Mesh mesh = Tetrahedron();
  EXPECT_NEAR(Volume(mesh), 1.0 / 6.0, 1e-12);
  const Areas areas = SurfaceAreas(mesh);
  EXPECT_NEAR(areas.graspable, std::sqrt(3.0) / 2.0, 1e-6);
  EXPECT_NEAR(areas.all, 1.5 + std::sqrt(3.0) / 2.0, 1e-6);
}

TEST(IsClosed, SeesAMissingFaceAndATurnedOne) {
  EXPECT_TRUE(IsClosed(Tetrahedron()));
  Mesh open = Tetrahedron();
  open.faces.pop_back();
  EXPECT_FALSE(IsClosed(open));
  Mesh turned = Tetrahedron();
  std::swap(turned.faces[0].vertices[0], turned.faces[0].vertices[1]);
  EXPECT_FALSE(IsClosed(turned));
  Mesh doubled = Tetrahedron();
  doubled.faces.push_back(doubled.faces[0]);
  EXPECT_FALSE(IsClosed(doubled));
  EXPECT_FALSE(IsClosed(Mesh{})) << "empty";
}

TEST(Append, KeepsBothParts) {
  Mesh mesh = Tetrahedron();
  Append(mesh, Tetrahedron());
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), 2.0 / 6.0, 1e-12);
}

TEST(Transform, KeepsVolumeAndAreas) {
  Rng rng = Rng::Stream(1, "motions");
  for (int i = 0; i < 20; ++i) {
    const auto draw = [&] { return static_cast<float>(rng.Normal()); };
    const Vector3f axis = Vector3f(draw(), draw(), draw()).normalized();
    Mesh mesh = Tetrahedron();
    Transform(mesh, Eigen::Translation3f(draw(), draw(), draw()) * Eigen::AngleAxisf(draw(), axis));
    EXPECT_NEAR(Volume(mesh), 1.0 / 6.0, 1e-5) << "single precision";
    EXPECT_NEAR(SurfaceAreas(mesh).all, SurfaceAreas(Tetrahedron()).all, 1e-5);
  }
}

TEST(RestOnTable, PutsTheLowestVertexOnZero) {
  Mesh mesh = Tetrahedron();
  Transform(mesh, Eigen::Isometry3f(Eigen::Translation3f(1.0F, 2.0F, -3.0F)));
  RestOnTable(mesh);
  EXPECT_EQ(Bounds(mesh).min(), Vector3f(1.0F, 2.0F, 0.0F));
}

TEST(LieAlongX, LaysZAlongXAndKeepsTheOrientation) {
  Mesh mesh = RoundedBox({0.1F, 0.2F, 0.4F}, 0.01F, {});
  const double volume = Volume(mesh);
  LieAlongX(mesh);
  EXPECT_TRUE(Bounds(mesh).min().isApprox(Vector3f(-0.2F, -0.05F, 0.0F), 1e-5F));
  EXPECT_TRUE(Bounds(mesh).max().isApprox(Vector3f(0.2F, 0.05F, 0.2F), 1e-5F));
  EXPECT_NEAR(Volume(mesh), volume, 1e-8);
}

TEST(CornerNormals, KeepsEdgesSharperThanTheCrease) {
  for (const auto& normals : CornerNormals(Tetrahedron(), 0.5F)) {
    EXPECT_TRUE(normals[0].isApprox(normals[1]) && normals[1].isApprox(normals[2]));
  }
}

TEST(CornerNormals, PointAwayFromTheMiddleOfASphere) {
  Profile profile;
  for (int i = 1; i < 40; ++i) {
    const float angle_rad = std::numbers::pi_v<float> * (static_cast<float>(i) / 40.0F - 0.5F);
    profile.push_back({std::cos(angle_rad), std::sin(angle_rad), {}});
  }
  const Mesh sphere = Revolve(profile, Ends::kCapped);
  const auto normals = CornerNormals(sphere, 0.7F);
  for (std::size_t i = 0; i < sphere.faces.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vector3f outward = sphere.vertices[sphere.faces[i].vertices[corner]].normalized();
      EXPECT_GT(normals[i][corner].dot(outward), 0.99F) << "within the angle between two strips";
    }
  }
}

}  // namespace
}  // namespace handcraft::synthetic
