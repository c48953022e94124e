// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/taught_objects.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectCentred;
using testing::ExpectFlatBottle;
using testing::ExpectHalfTurnSymmetry;
using testing::ExpectHeldBelow;
using testing::ExpectJug;
using testing::ExpectMug;
using testing::ExpectRoundBottle;
using testing::ExpectSound;
using testing::ForManyObjects;

TEST(DrawCoffeeCan, IsARoundedBoxHeldByItsSides) {
  ForManyObjects(DrawCoffeeCan, [](const Object& can) {
    ExpectSound(can);
    ExpectCentred(can);
    ExpectHalfTurnSymmetry(can);
    const Eigen::Vector3f size_m = Bounds(can.mesh).sizes();
    EXPECT_LT(size_m.x(), size_m.y()) << "the broad side faces +x";
    EXPECT_GT(size_m.z(), size_m.y());
    ExpectHeldBelow(can, 0.95F);  // below the lid
  });
}

TEST(DrawMouthwashBottle, IsFlatAndHeldInTheMiddle) {
  ForManyObjects(DrawMouthwashBottle, [](const Object& bottle) {
    ExpectFlatBottle(bottle, 0.75F);
    EXPECT_GT(Bounds(bottle.mesh).sizes().z(), 0.16F);
  });
}

TEST(DrawBelliedMug, IsHeldByHandleAndRim) {
  ForManyObjects(DrawBelliedMug,
                 [](const Object& mug) { ExpectMug(mug, -Bounds(mug.mesh).min().x() + 0.015F); });
}

TEST(DrawDetergentBottle, IsHeldByTheHandleAtItsFront) {
  ForManyObjects(DrawDetergentBottle,
                 [](const Object& bottle) { ExpectJug(bottle, 0.045F, 0.08F); });
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
  ForManyObjects(DrawPlasticBottle, [](const Object& bottle) { ExpectRoundBottle(bottle); });
}

}  // namespace
}  // namespace handcraft::synthetic
