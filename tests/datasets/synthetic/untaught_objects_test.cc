// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/untaught_objects.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectCentred;
using testing::ExpectFlatBottle;
using testing::ExpectHalfTurnSymmetry;
using testing::ExpectHeldBelow;
using testing::ExpectJug;
using testing::ExpectMug;
using testing::ExpectRound;
using testing::ExpectRoundBottle;
using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;

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
  ForManyObjects(DrawFlipTopBottle, [](const Object& bottle) { ExpectFlatBottle(bottle, 0.7F); });
}

TEST(DrawTaperedMug, IsWiderAboveAndHeldByHandleAndRim) {
  ForManyObjects(DrawTaperedMug, [](const Object& mug) { ExpectMug(mug, 0.045F); });
}

TEST(DrawSlantedJug, IsHeldByTheHandleAtItsFront) {
  ForManyObjects(DrawSlantedJug, [](const Object& jug) {
    ExpectJug(jug, 0.035F, 0.3F * Bounds(jug.mesh).max().z());
  });
}

TEST(DrawWaterBottle, IsRoundAndHeldInTheMiddle) {
  ForManyObjects(DrawWaterBottle, [](const Object& bottle) { ExpectRoundBottle(bottle); });
}

TEST(DrawSaltContainer, IsACylinderHeldByItsSide) {
  ForManyObjects(DrawSaltContainer, [](const Object& salt) {
    ExpectSound(salt);
    ExpectCentred(salt);
    ExpectRound(salt);
    ExpectHeldBelow(salt, 0.9F);
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
