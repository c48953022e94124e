// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/sweep_kernel.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "lib/robot/closed_form_solver.h"
#include "tests/lib/robot/shipped_arms.h"

namespace handcraft::robot {
namespace {

TEST(SweepAtan2, IsTheSystemsWithinRounding) {
  constexpr std::size_t kCount = 4000;
  std::vector<double> y(kCount + internal::kSweepSlack, 1.0);
  std::vector<double> x = y;
  std::vector<double> angle = y;
  Rng rng(1);
  for (std::size_t i = 0; i < kCount; ++i) {
    y[i] = rng.Normal() * std::exp(10.0 * rng.Normal());
    x[i] = rng.Normal() * std::exp(10.0 * rng.Normal());
  }
  const double edges[][2] = {
      {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, 1}, {0, 0}, {1e-300, 1}, {1, -1e-300}};
  for (std::size_t i = 0; i < std::size(edges); ++i) {
    y[i] = edges[i][0];
    x[i] = edges[i][1];
  }
  for (const features::InstructionSet set : features::SupportedInstructionSets()) {
    internal::SweepFor(set).atan2(y.data(), x.data(), angle.data(), kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      ASSERT_NEAR(angle[i], std::atan2(y[i], x[i]), 1e-15)
          << NameOf(set) << " " << y[i] << " " << x[i];
    }
  }
}

// Instruction sets with fused multiply-add give the same bits, the others the same solutions.
TEST(Sweep, GivesTheSameWithEveryInstructionSet) {
  const SerialChain chain = testing::LeftWam();
  const auto sets = features::SupportedInstructionSets();
  const ClosedFormSolver best(chain);
  InverseKinematicsResult expected;
  InverseKinematicsResult result;
  for (const features::InstructionSet set : sets) {
    const ClosedFormSolver solver(chain, {}, set);
    const bool is_fused =
        set != features::InstructionSet::kBaseline && set != features::InstructionSet::kSse4;
    Rng rng(2);
    for (int i = 0; i < 100; ++i) {
      const Pose pose = ForwardKinematics(chain, testing::DrawJoints(chain, rng));
      best.Solve(pose, {}, expected);
      solver.Solve(pose, {}, result);
      if (is_fused) {
        ASSERT_EQ(result.joints, expected.joints) << NameOf(set);
        continue;
      }
      ASSERT_EQ(result.size(), expected.size()) << NameOf(set);
      for (std::size_t k = 0; k < result.size(); ++k)
        ASSERT_NEAR(result.costs[k], expected.costs[k], 1e-12);
    }
  }
}

}  // namespace
}  // namespace handcraft::robot
