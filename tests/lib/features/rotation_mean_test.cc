// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/rotation_mean.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::features {
namespace {

Quaternion SomeRotation(Rng& rng) {
  Quaternion q = {rng.Normal(), rng.Normal(), rng.Normal(), rng.Normal()};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= length;
  return q;
}

void ExpectSame(const Quaternion& a, const Quaternion& b, double tolerance) {
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

// Σ w (q_i · q)²: what the mean maximises.
double Agreement(const std::vector<Quaternion>& rotations,
                 const std::vector<double>& weights,
                 const Quaternion& q) {
  double sum = 0.0;
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    double dot = 0.0;
    for (std::size_t i = 0; i < 4; ++i) dot += rotations[k][i] * q[i];
    sum += weights[k] * dot * dot;
  }
  return sum;
}

TEST(MeanRotation, OfOneIsItself) {
  const std::vector<Quaternion> one = {{0.0, 0.6, 0.0, -0.8}};
  const std::vector<double> weight = {3.0};
  EXPECT_EQ(MeanRotation(one, weight), (Quaternion{-0.0, -0.6, -0.0, 0.8}));
}

TEST(MeanRotation, OfTwoTurnsAboutZIsHalfway) {
  const std::vector<Quaternion> two = {TurnAboutZ(0.2), TurnAboutZ(0.8)};
  ExpectSame(MeanRotation(two, std::vector<double>{1.0, 1.0}), TurnAboutZ(0.5), 1e-15);
}

TEST(MeanRotation, DoesNotSeeSigns) {
  Rng rng(3);
  std::vector<Quaternion> rotations;
  std::vector<double> weights;
  for (int i = 0; i < 5; ++i) {
    rotations.push_back(SomeRotation(rng));
    weights.push_back(rng.Uniform() + 0.1);
  }
  const Quaternion mean = MeanRotation(rotations, weights);
  for (double& part : rotations[2]) part = -part;
  ExpectSame(MeanRotation(rotations, weights), mean, 1e-12);
}

TEST(MeanRotation, IsTheBestOfManyTries) {
  Rng rng(4);
  for (int repeat = 0; repeat < 10; ++repeat) {
    std::vector<Quaternion> rotations;
    std::vector<double> weights;
    for (int i = 0; i < 4; ++i) {
      rotations.push_back(SomeRotation(rng));
      weights.push_back(rng.Uniform() + 0.1);
    }
    const double best = Agreement(rotations, weights, MeanRotation(rotations, weights));
    for (int i = 0; i < 300; ++i) {
      EXPECT_LE(Agreement(rotations, weights, SomeRotation(rng)), best + 1e-12);
    }
  }
}

TEST(Product, TurnsOneAfterTheOther) {
  ExpectSame(Product(TurnAboutZ(0.3), TurnAboutZ(0.4)), TurnAboutZ(0.7), 1e-15);
  // i · j = k, of which the real part is 0.
  ExpectSame(Product({1, 0, 0, 0}, {0, 1, 0, 0}), {0, 0, 1, 0}, 0.0);
  const double pi = std::numbers::pi;
  EXPECT_GE(Product(TurnAboutZ(0.9 * pi), TurnAboutZ(0.9 * pi))[3], 0.0);
}

TEST(AngleBetween, IsThatOfTheTurn) {
  const double pi = std::numbers::pi;
  for (const double angle : {0.0, 1e-9, 0.3, 3.0, pi}) {
    EXPECT_NEAR(
        AngleBetween(TurnAboutZ(0.2), TurnAboutZ(0.2 + angle)), angle, 1e-15 + 1e-15 * angle);
  }
  EXPECT_NEAR(AngleBetween(TurnAboutZ(0.0), TurnAboutZ(1.5 * pi)), 0.5 * pi, 1e-14);
  // A half turn about x, whichever sign the quaternion has.
  EXPECT_NEAR(AngleBetween({0, 0, 0, -1}, {1, 0, 0, 0}), pi, 1e-15);
}

}  // namespace
}  // namespace handcraft::features
