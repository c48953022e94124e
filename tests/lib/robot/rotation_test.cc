// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/rotation.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::robot {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-14;

Vector3 DrawVector(Rng& rng) { return {rng.Normal(), rng.Normal(), rng.Normal()}; }

TEST(AxisRotation, TurnsAQuarter) {
  const Matrix3 quarter = AxisRotation({0, 0, 1}, kPi / 2);
  EXPECT_THAT(Multiply(quarter, Vector3{1, 0, 0}),
              Pointwise(DoubleNear(kRounding), Vector3{0, 1, 0}));
  EXPECT_THAT(Multiply(quarter, Vector3{0, 0, 2}),
              Pointwise(DoubleNear(kRounding), Vector3{0, 0, 2}));
  EXPECT_EQ(AxisRotation({0, 1, 0}, 0.0), kIdentity3);
}

TEST(RotationVector, IsTheInverseOfAxisRotation) {
  Rng rng(1);
  // Angles of every size, also next to 0 and π, where other formulas lose digits.
  for (const double angle : {1e-12, 1e-6, 0.1, 1.0, 2.0, 2.7, 3.1, kPi - 1e-6, kPi - 1e-9}) {
    for (int i = 0; i < 50; ++i) {
      const Vector3 v = DrawVector(rng);
      const Vector3 axis = Scale(v, 1.0 / Norm(v));
      EXPECT_THAT(RotationVector(AxisRotation(axis, angle)),
                  Pointwise(DoubleNear(1e-14), Scale(axis, angle)))
          << angle;
    }
  }
  EXPECT_EQ(RotationVector(kIdentity3), (Vector3{0, 0, 0}));
}

TEST(RotationVector, KnowsHalfTurns) {
  for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    EXPECT_NEAR(Norm(RotationVector(AxisRotation(axis, kPi))), kPi, kRounding);
    EXPECT_NEAR(std::abs(Dot(RotationVector(AxisRotation(axis, kPi)), axis)), kPi, kRounding);
  }
}

TEST(Orthonormalised, KeepsRotationsAndMendsRounding) {
  Rng rng(3);
  for (int i = 0; i < 50; ++i) {
    const Vector3 v = DrawVector(rng);
    const Matrix3 rotation = AxisRotation(Scale(v, 1.0 / Norm(v)), 3.0 * rng.Uniform());
    EXPECT_THAT(Orthonormalised(rotation), Pointwise(DoubleNear(kRounding), rotation));
    Matrix3 rounded = rotation;
    for (double& entry : rounded) entry = std::round(1e6 * entry) / 1e6;
    const Matrix3 mended = Orthonormalised(rounded);
    EXPECT_THAT(Multiply(mended, Transpose(mended)), Pointwise(DoubleNear(kRounding), kIdentity3));
    EXPECT_THAT(mended, Pointwise(DoubleNear(2e-6), rotation));
  }
}

TEST(Matrix3, KeepsTheLawsOfRotations) {
  Rng rng(2);
  for (int i = 0; i < 50; ++i) {
    const Vector3 v = DrawVector(rng);
    const Matrix3 a = AxisRotation(Scale(v, 1.0 / Norm(v)), rng.Uniform());
    EXPECT_THAT(Multiply(a, Transpose(a)), Pointwise(DoubleNear(kRounding), kIdentity3));
    EXPECT_NEAR(Determinant(a), 1.0, kRounding);
    EXPECT_EQ(FromColumns(Column(a, 0), Column(a, 1), Column(a, 2)), a);
    const Vector3 u = DrawVector(rng);
    EXPECT_THAT(Multiply(a, Cross(u, v)),
                Pointwise(DoubleNear(1e-13), Cross(Multiply(a, u), Multiply(a, v))));
    EXPECT_THAT(Subtract(Add(u, v), v), Pointwise(DoubleNear(kRounding), u));
  }
}

}  // namespace
}  // namespace handcraft::robot
