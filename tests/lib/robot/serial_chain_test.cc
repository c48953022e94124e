// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/serial_chain.h"

#include <cmath>
#include <limits>

#include "lib/core/error.h"
#include "tests/lib/robot/shipped_arms.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::robot {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Pointwise;

// Two links of 1 m and 0.5 m in a plane, and a slide along z.
SerialChain PlanarArm() {
  return {.base = "base",
          .tip = "tip",
          .joints =
              {{.name = "a", .parent_from_joint = {}, .lower = -3, .upper = 3},
               {.name = "b", .parent_from_joint = {kIdentity3, {1, 0, 0}}, .lower = -1, .upper = 2},
               {.name = "c",
                .type = JointType::kPrismatic,
                .parent_from_joint = {kIdentity3, {0.5, 0, 0}},
                .lower = 0,
                .upper = 0.2}},
          .last_from_tip = {}};
}

TEST(ForwardKinematics, AddsTheLinksOfAPlanarArm) {
  const Pose tip = ForwardKinematics(PlanarArm(), std::vector<double>{0.3, 0.4, 0.1});
  EXPECT_THAT(
      tip.translation_m,
      Pointwise(
          DoubleNear(1e-15),
          Vector3{std::cos(0.3) + 0.5 * std::cos(0.7), std::sin(0.3) + 0.5 * std::sin(0.7), 0.1}));
  EXPECT_NEAR(RotationVector(tip.rotation)[2], 0.7, 1e-15);
}

TEST(ForwardKinematics, SaysWhereTheAxesStand) {
  std::vector<JointLine> lines(3);
  const std::vector<double> joints = {0.3, 0.4, 0.1};
  const Pose tip = ForwardKinematics(PlanarArm(), joints, lines);
  EXPECT_EQ(tip.translation_m, ForwardKinematics(PlanarArm(), joints).translation_m);
  EXPECT_THAT(lines[1].point_m,
              Pointwise(DoubleNear(1e-15), Vector3{std::cos(0.3), std::sin(0.3), 0}));
  EXPECT_EQ(lines[1].axis, (Vector3{0, 0, 1}));
}

// T = Rz(q) · move(a, 0, d) · Rx(alpha): standard Denavit-Hartenberg.
Pose DenavitHartenberg(double a, double alpha, double d, double q) {
  return Pose{AxisRotation({0, 0, 1}, q), {}} * Pose{AxisRotation({1, 0, 0}, alpha), {a, 0, d}};
}

TEST(ForwardKinematics, AgreesWithTheTableOfTheWam) {
  constexpr double kHalf = 1.5707963267948966;
  constexpr double kTable[7][3] = {{0, -kHalf, 0},
                                   {0, kHalf, 0},
                                   {0.045, -kHalf, 0.55},
                                   {-0.045, kHalf, 0},
                                   {0, -kHalf, 0.3},
                                   {0, kHalf, 0},
                                   {0, 0, 0.06}};
  const SerialChain chain = testing::LeftWam();
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> joints = testing::DrawJoints(chain, rng);
    Pose expected = Pose{AxisRotation({1, 0, 0}, -kHalf), {-0.5, -0.046, 0.35}} *
                    Pose{kIdentity3, {0, 0, 0.346}};
    for (std::size_t j = 0; j < 7; ++j) {
      expected = expected * DenavitHartenberg(kTable[j][0], kTable[j][1], kTable[j][2], joints[j]);
    }
    const PoseError error = ErrorBetween(ForwardKinematics(chain, joints), expected);
    EXPECT_LT(error.position_m, 1e-14);
    EXPECT_LT(error.rotation_rad, 1e-14);
  }
}

TEST(SerialChain, KnowsNamesMiddleAndLimits) {
  const SerialChain chain = PlanarArm();
  EXPECT_EQ(chain.JointNames(), "a, b, c");
  EXPECT_EQ(chain.Middle(), (std::vector<double>{0, 0.5, 0.1}));
  EXPECT_TRUE(chain.IsWithinLimits(std::vector<double>{3, -1, 0.2}, 0.0));
  EXPECT_FALSE(chain.IsWithinLimits(std::vector<double>{3, -1, 0.21}, 0.001));
}

TEST(RequireWithinLimits, NamesJointAndLimits) {
  const SerialChain chain = PlanarArm();
  EXPECT_NO_THROW(chain.RequireWithinLimits(std::vector<double>{0, 2, 0}));
  EXPECT_THROWS_MESSAGE((chain.RequireWithinLimits(std::vector<double>{0, 0}), 0),
                        Error,
                        HasSubstr("2 joint values given; the arm has 3: a, b, c"));
  EXPECT_THROWS_MESSAGE((chain.RequireWithinLimits(std::vector<double>{0, 2.5, 0}), 0),
                        Error,
                        HasSubstr("joint b is 2.5; its limits are -1 and 2"));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROWS_MESSAGE((chain.RequireWithinLimits(std::vector<double>{kNan, 0, 0}), 0),
                        Error,
                        HasSubstr("joint a is nan"));
}

}  // namespace
}  // namespace handcraft::robot
