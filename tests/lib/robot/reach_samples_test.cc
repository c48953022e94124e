// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/reach_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::robot {
namespace {

using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::Truly;

constexpr double kPi = std::numbers::pi;

SphericalJoint SquareShoulder() {
  SphericalJoint shoulder{};
  shoulder.sin_12 = shoulder.sin_23 = 1.0;
  shoulder.cos_12 = shoulder.cos_23 = 0.0;
  return shoulder;
}

// Square axes, v = (r, 0, h): u = (r cos θ, −h, r sin θ), k = w_z, so r² cos² θ ≥ w_z² − h².
TEST(ReachSamples, FindsTheIntervalsOfASquareShoulder) {
  const std::vector<double> samples =
      ReachSamples(SquareShoulder(), {0.3, 0, 0.5}, {0.2, 0.1, 0.55});
  const double half_width = std::acos(std::sqrt(0.55 * 0.55 - 0.5 * 0.5) / 0.3);
  for (const double centre : {0.0, kPi}) {
    EXPECT_THAT(samples, Contains(Truly([&](double a) {
                  return std::abs(std::remainder(a - centre, 2 * kPi)) < 1e-6;
                })));
    for (const double sign : {1.0, -1.0}) {
      const double end = std::remainder(centre + sign * half_width, 2 * kPi);
      EXPECT_THAT(samples, Contains(DoubleNear(end, 1e-9)));
    }
  }
  EXPECT_THAT(
      samples,
      Each(Truly([&](double a) { return std::abs(std::cos(a)) >= std::cos(half_width) - 1e-9; })));
}

// The wrist on axis 1: two angles alone.
TEST(ReachSamples, FindsThePointsOfASingularShoulder) {
  const double length = std::hypot(0.3, 0.5);
  const std::vector<double> samples = ReachSamples(SquareShoulder(), {0.3, 0, 0.5}, {0, 0, length});
  EXPECT_THAT(samples, Contains(DoubleNear(0.0, 1e-7)));
  EXPECT_THAT(samples, Each(Truly([](double a) { return std::abs(std::sin(a)) < 1e-4; })));
}

TEST(ReachSamples, IsEmptyOutOfReach) {
  EXPECT_THAT(ReachSamples(SquareShoulder(), {0.3, 0, 0.5}, {0, 0, 0.7}), IsEmpty());
}

}  // namespace
}  // namespace handcraft::robot
