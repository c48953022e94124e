// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/taught_objects.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectCentred;
using testing::ExpectHalfTurnSymmetry;
using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;
using testing::GraspableReach;

TEST(DrawCoffeeCan, IsARoundedBoxHeldByItsSides) {
  ForManyObjects(DrawCoffeeCan, [](const Object& can) {
    ExpectSound(can);
    ExpectCentred(can);
    ExpectHalfTurnSymmetry(can);
    const Eigen::Vector3f size_m = Bounds(can.mesh).sizes();
    EXPECT_LT(size_m.x(), size_m.y()) << "the broad side faces +x";
    EXPECT_GT(size_m.z(), size_m.y());
    EXPECT_LT(GraspableBounds(can).max().z(), 0.95F * size_m.z()) << "below the lid";
  });
}

TEST(DrawMouthwashBottle, IsFlatAndHeldInTheMiddle) {
  ForManyObjects(DrawMouthwashBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    ExpectHalfTurnSymmetry(bottle);
    const Eigen::Vector3f size_m = Bounds(bottle.mesh).sizes();
    EXPECT_LT(size_m.x(), 0.8F * size_m.y());
    EXPECT_GT(size_m.z(), 0.16F);
    EXPECT_LT(GraspableBounds(bottle).max().z(), 0.75F * size_m.z());
  });
}

TEST(DrawBelliedMug, IsHeldByHandleAndRim) {
  ForManyObjects(DrawBelliedMug, [](const Object& mug) {
    ExpectSound(mug);
    EXPECT_GT(Bounds(mug.mesh).max().x(), -Bounds(mug.mesh).min().x() + 0.015F) << "handle at +x";
    EXPECT_GT(GraspableReach(mug, 0.6F), -Bounds(mug.mesh).min().x() + 0.015F) << "handle";
    EXPECT_FLOAT_EQ(GraspableBounds(mug).max().z(), Bounds(mug.mesh).max().z()) << "rim";
  });
}

TEST(DrawDetergentBottle, IsHeldByTheHandleAtItsFront) {
  ForManyObjects(DrawDetergentBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    const Eigen::AlignedBox3f held = GraspableBounds(bottle);
    EXPECT_LT(held.sizes().y(), 0.04F);
    EXPECT_GT(held.max().x(), 0.045F);
    EXPECT_GT(held.min().z(), 0.08F);
  });
}

// The plane y = 0 through the handle: behind the handle there is air, then the body.
TEST(DrawDetergentBottle, LeavesRoomForFingersBehindTheHandle) {
  ForManyObjects(DrawDetergentBottle, [](const Object& bottle) {
    const float height_m = Bounds(bottle.mesh).max().z();
    float body_m = -1.0F;   // the farthest of the body to the front, at the handle's middle
    float handle_m = 1.0F;  // the handle's nearest to the body
    for (const Face& face : bottle.mesh.faces) {
      for (const std::uint32_t index : face.vertices) {
        const Eigen::Vector3f& at = bottle.mesh.vertices[index];
        if (std::abs(at.z() - 0.55F * height_m) > 0.03F * height_m) continue;
        if (face.surface.graspable) handle_m = std::min(handle_m, at.x());
        if (!face.surface.graspable && at.x() < 0.03F) body_m = std::max(body_m, at.x());
      }
    }
    EXPECT_GT(handle_m - body_m, 0.015F);
  });
}

TEST(DrawPlasticBottle, IsRoundAndHeldByItsWaist) {
  ForManyObjects(DrawPlasticBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    ExpectHalfTurnSymmetry(bottle);
    const Eigen::AlignedBox3f box = Bounds(bottle.mesh);
    EXPECT_NEAR(box.sizes().x(), box.sizes().y(), 1e-5F);
    EXPECT_LT(GraspableBounds(bottle).max().z(), 0.66F * box.max().z());
  });
}

}  // namespace
}  // namespace handcraft::synthetic
