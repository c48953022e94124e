// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/drills.h"

#include "tests/datasets/synthetic/object_checks.h"

namespace handcraft::synthetic {
namespace {

using testing::ExpectCentred;
using testing::ExpectSound;
using testing::ForManyObjects;
using testing::GraspableBounds;

void ExpectDrill(const Object& drill) {
  ExpectSound(drill);
  ExpectCentred(drill);
  const Eigen::AlignedBox3f box = Bounds(drill.mesh);
  const Eigen::AlignedBox3f held = GraspableBounds(drill);
  EXPECT_GT(box.sizes().x(), 2.0F * box.sizes().y()) << "longer than broad";
  EXPECT_LT(held.max().x(), 0.6F * box.max().x()) << "never the chuck";
  EXPECT_GT(held.min().z(), 0.02F) << "never the battery's bottom";
  EXPECT_GT(held.max().z(), 0.9F * box.max().z()) << "the housing";
  EXPECT_LT(held.min().z(), 0.6F * box.max().z()) << "the handle";
}

TEST(DrawDrill, StandsOnItsBatteryWithTheChuckToTheFront) {
  ForManyObjects(DrawDrill, [](const Object& drill) {
    ExpectDrill(drill);
    EXPECT_GT(Bounds(drill.mesh).max().z(), 0.19F);
    EXPECT_LT(Bounds(drill.mesh).max().z(), 0.24F);
  });
}

TEST(DrawOtherDrill, IsSmallerAndStandsOnTheFootOfItsHandle) {
  ForManyObjects(DrawOtherDrill, [](const Object& drill) {
    ExpectDrill(drill);
    EXPECT_GT(Bounds(drill.mesh).max().z(), 0.17F);
    EXPECT_LT(Bounds(drill.mesh).max().z(), 0.20F);
  });
}

}  // namespace
}  // namespace handcraft::synthetic
