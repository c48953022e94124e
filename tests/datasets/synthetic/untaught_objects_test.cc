// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/untaught_objects.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectCentred;
using testing::ExpectHalfTurnSymmetry;
using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;
using testing::GraspableReach;

TEST(DrawDvdCase, StandsThinAndIsHeldAbove) {
  ForManyObjects(DrawDvdCase, [](const Object& box) {
    ExpectSound(box);
    ExpectCentred(box);
    ExpectHalfTurnSymmetry(box);
    EXPECT_LT(Bounds(box.mesh).sizes().x(), 0.017F);
    EXPECT_GT(Bounds(box.mesh).sizes().z(), 0.18F);
    EXPECT_GT(GraspableBounds(box).min().z(), 0.4F * Bounds(box.mesh).max().z());
  });
}

TEST(DrawFlipTopBottle, IsFlatAndHeldInTheMiddle) {
  ForManyObjects(DrawFlipTopBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    ExpectHalfTurnSymmetry(bottle);
    const Eigen::Vector3f size_m = Bounds(bottle.mesh).sizes();
    EXPECT_LT(size_m.x(), 0.8F * size_m.y());
    EXPECT_LT(GraspableBounds(bottle).max().z(), 0.7F * size_m.z()) << "below the cap";
  });
}

TEST(DrawTaperedMug, IsWiderAboveAndHeldByHandleAndRim) {
  ForManyObjects(DrawTaperedMug, [](const Object& mug) {
    ExpectSound(mug);
    EXPECT_GT(Bounds(mug.mesh).max().x(), -Bounds(mug.mesh).min().x() + 0.015F) << "handle at +x";
    EXPECT_GT(GraspableReach(mug, 0.6F), 0.045F) << "handle";
    EXPECT_FLOAT_EQ(GraspableBounds(mug).max().z(), Bounds(mug.mesh).max().z()) << "rim";
  });
}

TEST(DrawSlantedJug, IsHeldByTheHandleAtItsFront) {
  ForManyObjects(DrawSlantedJug, [](const Object& jug) {
    ExpectSound(jug);
    const Eigen::AlignedBox3f held = GraspableBounds(jug);
    EXPECT_LT(held.sizes().y(), 0.04F);
    EXPECT_GT(held.max().x(), 0.035F);
    EXPECT_GT(held.min().z(), 0.3F * Bounds(jug.mesh).max().z());
  });
}

TEST(DrawWaterBottle, IsRoundAndHeldInTheMiddle) {
  ForManyObjects(DrawWaterBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    ExpectHalfTurnSymmetry(bottle);
    const Eigen::AlignedBox3f box = Bounds(bottle.mesh);
    EXPECT_NEAR(box.sizes().x(), box.sizes().y(), 1e-5F);
    EXPECT_LT(GraspableBounds(bottle).max().z(), 0.66F * box.max().z());
  });
}

TEST(DrawSaltContainer, IsACylinderHeldByItsSide) {
  ForManyObjects(DrawSaltContainer, [](const Object& salt) {
    ExpectSound(salt);
    ExpectCentred(salt);
    const Eigen::AlignedBox3f box = Bounds(salt.mesh);
    EXPECT_NEAR(box.sizes().x(), box.sizes().y(), 1e-5F);
    EXPECT_LT(GraspableBounds(salt).max().z(), 0.9F * box.max().z());
  });
}

TEST(DrawRectangularBox, IsHeldByTheUpperHalfOfItsSides) {
  ForManyObjects(DrawRectangularBox, [](const Object& box) {
    ExpectSound(box);
    ExpectCentred(box);
    ExpectHalfTurnSymmetry(box);
    EXPECT_LT(Bounds(box.mesh).sizes().x(), 0.6F * Bounds(box.mesh).sizes().y());
    EXPECT_GT(GraspableBounds(box).min().z(), 0.4F * Bounds(box.mesh).max().z());
  });
}

}  // namespace
}  // namespace handcraft::synthetic
