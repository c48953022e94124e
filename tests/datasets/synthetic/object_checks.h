// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "datasets/synthetic/object_classes.h"

namespace handcraft::synthetic::testing {

/// What holds of every object: closed, outwards, resting on the table, some of it graspable and not
/// all of it, unless `all_graspable`; materials that exist.
inline void ExpectSound(const Object& object, bool all_graspable = false) {
  EXPECT_TRUE(IsClosed(object.mesh));
  EXPECT_GT(Volume(object.mesh), 0.0);
  EXPECT_NEAR(Bounds(object.mesh).min().z(), 0.0F, 1e-6F);
  const Areas areas = SurfaceAreas(object.mesh);
  EXPECT_GT(areas.graspable, 0.02 * areas.all);
  EXPECT_LT(areas.graspable, all_graspable ? 1.001 * areas.all : 0.75 * areas.all);
  for (const Face& face : object.mesh.faces) {
    ASSERT_LT(face.surface.material, object.materials.size());
  }
}

/// The middle of the box around it lies on the z axis.
inline void ExpectCentred(const Object& object) {
  EXPECT_NEAR(Bounds(object.mesh).center().x(), 0.0F, 1e-5F);
  EXPECT_NEAR(Bounds(object.mesh).center().y(), 0.0F, 1e-5F);
}

/// Half a turn about z puts a vertex, every 53rd is tried, within 0.3 mm of another.
inline void ExpectHalfTurnSymmetry(const Object& object) {
  const std::vector<Eigen::Vector3f>& vertices = object.mesh.vertices;
  for (std::size_t i = 0; i < vertices.size(); i += 53) {
    const Eigen::Vector3f turned(-vertices[i].x(), -vertices[i].y(), vertices[i].z());
    const auto is_near = [&](const Eigen::Vector3f& other) {
      return (turned - other).squaredNorm() < 0.0003F * 0.0003F;
    };
    EXPECT_TRUE(std::any_of(vertices.begin(), vertices.end(), is_near)) << turned.transpose();
  }
}

/// Box around the graspable faces alone.
inline Eigen::AlignedBox3f GraspableBounds(const Object& object) {
  Eigen::AlignedBox3f box;
  for (const Face& face : object.mesh.faces) {
    if (!face.surface.graspable) continue;
    for (const std::uint32_t vertex : face.vertices) box.extend(object.mesh.vertices[vertex]);
  }
  return box;
}

/// Greatest distance from the z axis of a graspable point at most `below` of the whole height up.
inline float GraspableReach(const Object& object, float below) {
  const float limit_m = below * Bounds(object.mesh).max().z();
  float reach_m = 0.0F;
  for (const Face& face : object.mesh.faces) {
    if (!face.surface.graspable) continue;
    for (const std::uint32_t vertex : face.vertices) {
      const Eigen::Vector3f& at = object.mesh.vertices[vertex];
      if (at.z() <= limit_m) reach_m = std::max(reach_m, at.head<2>().norm());
    }
  }
  return reach_m;
}

/// Runs `check` on thirty drawn objects.
template <class Check>
void ForManyObjects(Object (*draw)(Rng&), const Check& check) {
  for (std::uint64_t i = 0; i < 30; ++i) {
    SCOPED_TRACE("object " + std::to_string(i));
    Rng rng = Rng::Stream(1, "objects", i);
    check(draw(rng));
  }
}

}  // namespace handcraft::synthetic::testing
