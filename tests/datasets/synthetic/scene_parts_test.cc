// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene_parts.h"

#include <cmath>

#include <gtest/gtest.h>

#include "datasets/synthetic/loft.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

TEST(UprightPose, TurnsAboutZByHand) {
  const Eigen::Isometry3f pose = UprightPose({1.0F, 2.0F, 3.0F}, std::acos(0.0F));
  EXPECT_TRUE((pose * Vector3f(1.0F, 0.0F, 0.5F)).isApprox(Vector3f(1.0F, 3.0F, 3.5F), 1e-5F));
}

TEST(DrawDirection, IsOfUnitLengthAndFavoursNone) {
  Rng rng = Rng::Stream(1, "directions");
  Eigen::Vector2f sum = Eigen::Vector2f::Zero();
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector2f direction = DrawDirection(rng);
    EXPECT_NEAR(direction.norm(), 1.0F, 1e-5F);
    sum += direction;
  }
  EXPECT_LT(sum.norm() / 10000.0F, 0.03F) << "four standard deviations";
}

TEST(FootprintRadius, IsTheFarthestVertexFromTheAxis) {
  const Object box{.mesh = RoundedBox({0.6F, 0.8F, 5.0F}, 1e-4F, {}), .materials = {}};
  EXPECT_NEAR(FootprintRadius(box), 0.5F, 1e-3F);
}

TEST(AddRoom, PutsTheTableUnderTheOrigin) {
  for (std::uint64_t i = 0; i < 30; ++i) {
    Scene scene;
    Rng rng = Rng::Stream(1, "room", i);
    AddRoom(scene, 1.0F, rng);
    ASSERT_EQ(scene.objects.size(), 6U) << "table, floor, four walls";
    Scene wide;
    Rng same = Rng::Stream(1, "room", i);
    AddRoom(wide, 1.8F, same);
    const auto radius = [](const Scene& of) { return FootprintRadius(of.objects[0].object); };
    EXPECT_NEAR(radius(wide) / radius(scene), 1.8F, 0.01F);
    const PlacedObject& table = scene.objects[0];
    EXPECT_NEAR(table.base_from_object.translation().z() + Bounds(table.object.mesh).max().z(),
                0.0F,
                1e-6F);
    EXPECT_LT(table.base_from_object.translation().norm(), 0.25F);
    EXPECT_FALSE(table.is_target);
  }
}

TEST(DrawFlatThing, RestsOnTheTable) {
  int num_thin = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Rng rng = Rng::Stream(2, "thing", i);
    const Object thing = DrawFlatThing(rng);
    const Eigen::AlignedBox3f bounds = Bounds(thing.mesh);
    EXPECT_NEAR(bounds.min().z(), 0.0F, 1e-6F);
    EXPECT_LT(bounds.max().z(), 0.031F);
    num_thin += bounds.max().z() < kThinM ? 1 : 0;
  }
  EXPECT_GT(num_thin, 30) << "sheets and cloths: half of the kinds";
  EXPECT_LT(num_thin, 70);
}

TEST(DrawLight, ShinesFromAbove) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Scene scene;
    Rng rng = Rng::Stream(3, "light", i);
    DrawLight(scene, rng);
    EXPECT_GT(scene.light.centre_m.z(), 0.6F);
    EXPECT_GT(scene.ambient.minCoeff(), 0.1F);
  }
}

TEST(DrawSensor, StaysInItsRanges) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Rng rng = Rng::Stream(4, "sensor", i);
    const SensorModel sensor = DrawSensor(rng);
    EXPECT_TRUE(sensor.mean_exposure >= 0.14F && sensor.mean_exposure <= 0.3F);
    EXPECT_TRUE(sensor.read_noise >= 0.6F && sensor.read_noise <= 2.0F);
    EXPECT_TRUE(sensor.blur_px >= 0.35F && sensor.blur_px <= 0.7F);
  }
}

}  // namespace
}  // namespace handcraft::synthetic
