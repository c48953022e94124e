// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/spherical_arm.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lib/robot/shipped_arms.h"

namespace handcraft::robot {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Pointwise;

TEST(FindSphericalArm, FindsShoulderAndWristOfTheWam) {
  const SphericalArmSearch search = FindSphericalArm(testing::RightWam());
  ASSERT_TRUE(search.arm) << search.reason;
  // 0.346 m above the arm's base, which is turned by 90 degrees.
  EXPECT_THAT(search.arm->shoulder.centre_m,
              Pointwise(DoubleNear(1e-14), Vector3{-0.5, -0.3, 0.35}));
  EXPECT_THAT(search.arm->wrist.centre_m, Pointwise(DoubleNear(1e-14), Vector3{-0.5, -1.15, 0.35}));
  EXPECT_NEAR(search.arm->shoulder.sin_12, 1.0, 1e-15);
}

// The longest shoulder-wrist distance is 0.85519 m, at q4 = 0.2305: the two hypotenuses in a row.
TEST(FindSphericalArm, KnowsTheReachOfTheWam) {
  const SphericalArmSearch search = FindSphericalArm(testing::LeftWam());
  ASSERT_TRUE(search.arm);
  const SphericalArm& arm = *search.arm;
  const double amplitude = std::hypot(arm.reach_cosine, arm.reach_sine);
  EXPECT_NEAR(std::sqrt(arm.reach_constant + amplitude),
              std::hypot(0.045, 0.55) + std::hypot(0.045, 0.3),
              1e-14);
  EXPECT_NEAR(std::atan2(arm.reach_sine, arm.reach_cosine),
              std::atan(0.045 / 0.55) + std::atan(0.045 / 0.3),
              1e-14);
}

TEST(FindSphericalArm, TakesAxesThatAreNotSquare) {
  SerialChain chain = testing::LeftWam();
  for (const std::size_t j : {1U, 2U, 5U, 6U}) {
    Matrix3& rotation = chain.joints[j].parent_from_joint.rotation;
    rotation = Multiply(rotation, AxisRotation({1, 0, 0}, 0.2));
  }
  const SphericalArmSearch search = FindSphericalArm(chain);
  ASSERT_TRUE(search.arm) << search.reason;
  EXPECT_NEAR(search.arm->shoulder.sin_12, std::cos(0.2), 1e-14);
}

TEST(FindSphericalArm, SaysWhyNot) {
  EXPECT_THAT(FindSphericalArm(testing::Panda()).reason,
              HasSubstr("the wrist do not meet in one point"));
  SerialChain chain = testing::LeftWam();
  chain.joints[1].parent_from_joint.translation_m[0] += 0.01;
  EXPECT_THAT(FindSphericalArm(chain).reason, HasSubstr("the shoulder do not meet in one point"));
  chain = testing::LeftWam();
  chain.joints[5].parent_from_joint.rotation = kIdentity3;
  EXPECT_THAT(FindSphericalArm(chain).reason, HasSubstr("axes of the wrist are parallel"));
  chain = testing::LeftWam();
  chain.joints[2].type = JointType::kPrismatic;
  EXPECT_THAT(FindSphericalArm(chain).reason, HasSubstr("not every joint turns"));
  chain = testing::LeftWam();
  chain.joints.pop_back();
  EXPECT_THAT(FindSphericalArm(chain).reason, HasSubstr("6 joints, not 7"));
  chain = testing::LeftWam();
  chain.joints[3].parent_from_joint.translation_m = {};
  EXPECT_THAT(FindSphericalArm(chain).reason, HasSubstr("does not change the distance"));
}

}  // namespace
}  // namespace handcraft::robot
