// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/trained_objects.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;
using testing::GraspableReach;

TEST(DrawCerealBowl, IsHeldByItsRim) {
  ForManyObjects(DrawCerealBowl, [](const Object& bowl) {
    ExpectSound(bowl);
    const float height_m = Bounds(bowl.mesh).max().z();
    EXPECT_GT(GraspableBounds(bowl).min().z(), height_m - 0.016F);
    EXPECT_FLOAT_EQ(GraspableBounds(bowl).max().z(), height_m);
  });
}

TEST(DrawEraser, IsHeldInTheMiddle) {
  ForManyObjects(DrawEraser, [](const Object& eraser) {
    ExpectSound(eraser);
    EXPECT_LT(Bounds(eraser.mesh).sizes().z(), Bounds(eraser.mesh).sizes().y()) << "lies flat";
    const float half_m = Bounds(eraser.mesh).max().x();
    EXPECT_LT(GraspableBounds(eraser).max().x(), 0.75F * half_m);
    EXPECT_GT(GraspableBounds(eraser).min().x(), -0.75F * half_m);
  });
}

TEST(DrawMartiniGlass, IsHeldByItsStem) {
  ForManyObjects(DrawMartiniGlass, [](const Object& glass) {
    ExpectSound(glass);
    EXPECT_LT(GraspableBounds(glass).max().x(), 0.010F);
    EXPECT_GT(GraspableBounds(glass).sizes().z(), 0.05F);
  });
}

TEST(DrawMug, IsHeldByHandleAndRim) {
  ForManyObjects(DrawMug, [](const Object& mug) {
    ExpectSound(mug);
    const float rim_m = -Bounds(mug.mesh).min().x();
    EXPECT_GT(GraspableReach(mug, 0.7F), rim_m + 0.012F) << "handle";
    EXPECT_NEAR(GraspableBounds(mug).min().x(), -rim_m, 0.001F) << "rim";
    EXPECT_FLOAT_EQ(GraspableBounds(mug).max().z(), Bounds(mug.mesh).max().z());
  });
}

TEST(DrawStapler, IsHeldInTheMiddleOfItsArm) {
  ForManyObjects(DrawStapler, [](const Object& stapler) {
    ExpectSound(stapler);
    const float length_m = Bounds(stapler.mesh).sizes().x();
    EXPECT_LT(GraspableBounds(stapler).sizes().x(), 0.6F * length_m);
    EXPECT_GT(GraspableBounds(stapler).min().z(), 0.008F) << "above the base";
  });
}

TEST(DrawTeaCup, IsHeldByHandleAndRimAndMayHaveASaucer) {
  int num_saucers = 0;
  ForManyObjects(DrawTeaCup, [&](const Object& cup) {
    ExpectSound(cup);
    EXPECT_GT(GraspableBounds(cup).sizes().x(), GraspableBounds(cup).sizes().y() + 0.008F)
        << "handle";
    EXPECT_FLOAT_EQ(GraspableBounds(cup).max().z(), Bounds(cup.mesh).max().z()) << "rim";
    const bool has_saucer = -Bounds(cup.mesh).min().x() > -GraspableBounds(cup).min().x() + 0.01F;
    num_saucers += has_saucer ? 1 : 0;
  });
  EXPECT_GT(num_saucers, 4);
  EXPECT_LT(num_saucers, 22);
}

TEST(DrawPencil, IsHeldInTheMiddle) {
  ForManyObjects(DrawPencil, [](const Object& pencil) {
    ExpectSound(pencil);
    const float length_m = Bounds(pencil.mesh).sizes().x();
    EXPECT_GE(length_m, 0.12F - 1e-5F);
    EXPECT_LE(length_m, 0.19F + 1e-5F);
    EXPECT_LT(GraspableBounds(pencil).sizes().x(), 0.6F * length_m);
    EXPECT_GT(GraspableBounds(pencil).sizes().x(), 0.3F * length_m);
  });
}

}  // namespace
}  // namespace handcraft::synthetic
