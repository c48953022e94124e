// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/pose.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::robot {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;

constexpr double kHalf = std::numbers::pi / 2;

Pose DrawPose(Rng& rng) {
  return {RotationFromQuaternion({rng.Normal(), rng.Normal(), rng.Normal(), rng.Normal()}),
          {rng.Normal(), rng.Normal(), rng.Normal()}};
}

TEST(Pose, TurnsThenMoves) {
  const Pose pose{AxisRotation({0, 0, 1}, kHalf), {1, 2, 3}};
  EXPECT_THAT(Apply(pose, {1, 0, 0}), Pointwise(DoubleNear(1e-15), Vector3{1, 3, 3}));
}

TEST(Pose, TimesItsInverseIsNothing) {
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const Pose pose = DrawPose(rng);
    const PoseError error = ErrorBetween(pose * Inverse(pose), Pose{});
    EXPECT_LT(error.position_m, 1e-14);
    EXPECT_LT(error.rotation_rad, 1e-14);
    const Pose other = DrawPose(rng);
    EXPECT_THAT(Apply(pose * other, {1, 2, 3}),
                Pointwise(DoubleNear(1e-13), Apply(pose, Apply(other, {1, 2, 3}))));
  }
}

TEST(ErrorBetween, TellsDistanceAndAngle) {
  const PoseError error =
      ErrorBetween({AxisRotation({1, 0, 0}, 0.25), {0, 3, 0}}, {kIdentity3, {4, 0, 0}});
  EXPECT_DOUBLE_EQ(error.position_m, 5.0);
  EXPECT_NEAR(error.rotation_rad, 0.25, 1e-15);
}

// Rz(0.3) Ry(0.2) Rx(0.1), by the closed form of its entries.
TEST(RotationFromRollPitchYaw, TurnsAboutFixedAxes) {
  const Matrix3 rotation = RotationFromRollPitchYaw({0.1, 0.2, 0.3});
  EXPECT_NEAR(rotation[6], -std::sin(0.2), 1e-15);
  EXPECT_NEAR(rotation[7], std::sin(0.1) * std::cos(0.2), 1e-15);
  EXPECT_NEAR(rotation[3], std::sin(0.3) * std::cos(0.2), 1e-15);
}

TEST(Quaternion, RoundTripsAndTakesAnyLength) {
  Rng rng(2);
  for (int i = 0; i < 100; ++i) {
    const Matrix3 rotation = DrawPose(rng).rotation;
    const auto xyzw = QuaternionFromRotation(rotation);
    EXPECT_GE(xyzw[3], 0.0);
    EXPECT_THAT(RotationFromQuaternion(xyzw), Pointwise(DoubleNear(1e-14), rotation));
  }
  EXPECT_THAT(RotationFromQuaternion({0, 0, 5, 5}),
              Pointwise(DoubleNear(1e-15), AxisRotation({0, 0, 1}, kHalf)));
}

TEST(FaultOf, PassesRotations) {
  Rng rng(3);
  for (int i = 0; i < 20; ++i) EXPECT_THAT(FaultOf(DrawPose(rng)), IsEmpty());
}

TEST(FaultOf, NamesNanSingularScaledAndMirrored) {
  Pose pose;
  pose.translation_m[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(FaultOf(pose), HasSubstr("not finite"));
  pose = {};
  pose.rotation[4] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(FaultOf(pose), HasSubstr("not finite"));
  EXPECT_THAT(FaultOf({Matrix3{}, {}}), HasSubstr("its determinant is 0"));
  EXPECT_THAT(FaultOf({{1, 0, 0, 0, 1, 0, 0, 0, -1}, {}}), HasSubstr("its determinant is -1"));
  EXPECT_THAT(FaultOf({{2, 0, 0, 0, 1, 0, 0, 0, 1}, {}}),
              HasSubstr("off right angles and length 1 by 3"));
  EXPECT_THAT(FaultOf({RotationFromQuaternion({0, 0, 0, 0}), {}}), HasSubstr("not finite"));
}

}  // namespace
}  // namespace handcraft::robot
