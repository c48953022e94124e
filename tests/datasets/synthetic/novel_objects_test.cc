// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/novel_objects.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;
using testing::GraspableReach;

TEST(DrawBottle, IsHeldByItsNeckAndStandsOrLies) {
  int num_standing = 0;
  ForManyObjects(DrawBottle, [&](const Object& bottle) {
    ExpectSound(bottle);
    EXPECT_LT(GraspableBounds(bottle).sizes().y(), 0.6F * Bounds(bottle.mesh).sizes().y());
    num_standing += Bounds(bottle.mesh).sizes().z() > 0.15F ? 1 : 0;
  });
  EXPECT_GT(num_standing, 9);
  EXPECT_LT(num_standing, 28);
}

TEST(DrawCalculator, IsHeldByItsLongSides) {
  ForManyObjects(DrawCalculator, [](const Object& calculator) {
    ExpectSound(calculator);
    const float half_m = Bounds(calculator.mesh).max().x();
    for (const Face& face : calculator.mesh.faces) {
      if (!face.surface.graspable) continue;
      for (const std::uint32_t vertex : face.vertices) {
        EXPECT_GT(std::abs(calculator.mesh.vertices[vertex].x()), half_m - 0.008F);
      }
    }
  });
}

TEST(DrawVerySmallCup, IsHeldByEarAndRim) {
  ForManyObjects(DrawVerySmallCup, [](const Object& cup) {
    ExpectSound(cup);
    EXPECT_LT(Bounds(cup.mesh).max().z(), 0.05F);
    EXPECT_GT(GraspableReach(cup, 0.7F), -Bounds(cup.mesh).min().x() + 0.004F) << "ear";
    EXPECT_FLOAT_EQ(GraspableBounds(cup).max().z(), Bounds(cup.mesh).max().z()) << "rim";
  });
}

TEST(DrawHammer, IsHeldByItsHandle) {
  ForManyObjects(DrawHammer, [](const Object& hammer) {
    ExpectSound(hammer);
    EXPECT_LT(GraspableBounds(hammer).sizes().y(), 0.04F);
    EXPECT_GT(Bounds(hammer.mesh).sizes().y(), 0.08F) << "the head lies across";
    EXPECT_GT(GraspableBounds(hammer).sizes().x(), 0.5F * Bounds(hammer.mesh).sizes().x());
  });
}

TEST(DrawShampooBottle, IsHeldByMiddleAndCap) {
  ForManyObjects(DrawShampooBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    const float height_m = Bounds(bottle.mesh).max().z();
    EXPECT_FLOAT_EQ(GraspableBounds(bottle).max().z(), height_m) << "cap";
    EXPECT_GT(GraspableBounds(bottle).min().z(), 0.2F * height_m);
    EXPECT_GT(GraspableReach(bottle, 0.6F), 0.02F) << "middle";
  });
}

TEST(DrawTape, IsARingThatCanBeHeldAnywhere) {
  ForManyObjects(DrawTape, [](const Object& tape) {
    ExpectSound(tape, true);
    EXPECT_DOUBLE_EQ(SurfaceAreas(tape.mesh).graspable, SurfaceAreas(tape.mesh).all);
  });
}

}  // namespace
}  // namespace handcraft::synthetic
