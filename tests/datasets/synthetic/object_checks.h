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

/// As wide as it is deep.
inline void ExpectRound(const Object& object) {
  const Eigen::Vector3f size_m = Bounds(object.mesh).sizes();
  EXPECT_NEAR(size_m.x(), size_m.y(), 1e-5F);
}

/// Nothing graspable is higher than this share of the whole height.
inline void ExpectHeldBelow(const Object& object, float share) {
  EXPECT_LT(GraspableBounds(object).max().z(), share * Bounds(object.mesh).max().z());
}

/// A flat bottle, its broad side to the front, held below the cap.
inline void ExpectFlatBottle(const Object& bottle, float held_below) {
  ExpectSound(bottle);
  ExpectHalfTurnSymmetry(bottle);
  const Eigen::Vector3f size_m = Bounds(bottle.mesh).sizes();
  EXPECT_LT(size_m.x(), 0.8F * size_m.y());
  ExpectHeldBelow(bottle, held_below);
}

/// A round bottle, held in the middle.
inline void ExpectRoundBottle(const Object& bottle) {
  ExpectSound(bottle);
  ExpectHalfTurnSymmetry(bottle);
  ExpectRound(bottle);
  ExpectHeldBelow(bottle, 0.66F);
}

/// A mug with its handle at +x, held by the handle, at least `reach_m` from the axis, and the rim.
inline void ExpectMug(const Object& mug, float reach_m) {
  ExpectSound(mug);
  EXPECT_GT(Bounds(mug.mesh).max().x(), -Bounds(mug.mesh).min().x() + 0.015F) << "handle at +x";
  EXPECT_GT(GraspableReach(mug, 0.6F), reach_m) << "handle";
  EXPECT_FLOAT_EQ(GraspableBounds(mug).max().z(), Bounds(mug.mesh).max().z()) << "rim";
}

/// A jug held by a handle at its front, farther out and higher than this.
inline void ExpectJug(const Object& jug, float out_m, float up_m) {
  ExpectSound(jug);
  const Eigen::AlignedBox3f held = GraspableBounds(jug);
  EXPECT_LT(held.sizes().y(), 0.04F);
  EXPECT_GT(held.max().x(), out_m);
  EXPECT_GT(held.min().z(), up_m);
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
