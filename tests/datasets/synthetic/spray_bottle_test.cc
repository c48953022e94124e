// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/spray_bottle.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;

TEST(DrawSprayBottle, IsHeldBelowItsHeadAndSpraysToTheFront) {
  ForManyObjects(DrawSprayBottle, [](const Object& bottle) {
    ExpectSound(bottle);
    const Eigen::AlignedBox3f box = Bounds(bottle.mesh);
    const Eigen::AlignedBox3f held = GraspableBounds(bottle);
    EXPECT_GT(box.max().x(), -box.min().x()) << "the nozzle";
    EXPECT_LT(held.max().z(), 0.85F * box.max().z()) << "below the head";
    EXPECT_GT(held.sizes().z(), 0.4F * box.max().z());
    EXPECT_GT(box.max().z(), 0.20F);
    EXPECT_LT(box.max().z(), 0.26F);
  });
}

}  // namespace
}  // namespace handcraft::synthetic
