// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/inverse_kinematics.h"

#include <limits>

#include "lib/core/error.h"
#include "tests/lib/robot/shipped_arms.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Returns the values it was made with, whatever the pose.
class FixedSolver : public InverseKinematics {
 public:
  FixedSolver(const SerialChain& chain, std::vector<std::vector<double>> solutions)
      : InverseKinematics(chain, {}), solutions_(std::move(solutions)) {}
  [[nodiscard]] std::string_view Method() const noexcept override { return "fixed"; }

 protected:
  void SolveSound(const Pose& /*base_from_tip*/,
                  std::span<const double> reference,
                  InverseKinematicsResult& result) const override {
    for (const auto& joints : solutions_) AddSolution(joints, reference, result);
    SortSolutions(result);
  }

 private:
  std::vector<std::vector<double>> solutions_;
};

SerialChain OneJoint() {
  return {.base = "base",
          .tip = "tip",
          .joints = {{.name = "a", .parent_from_joint = {}, .lower = -1, .upper = 3}},
          .last_from_tip = {}};
}

TEST(InverseKinematics, OrdersByCostAndDropsWhatIsThere) {
  const FixedSolver solver(OneJoint(), {{3.0}, {0.5}, {0.50001}, {-1.0}});
  InverseKinematicsResult result;
  solver.Solve({}, {}, result);
  // ((q − 1) / 2)²; equal costs keep their order.
  EXPECT_THAT(result.joints, ElementsAre(0.5, 3.0, -1.0));
  EXPECT_THAT(result.costs, ElementsAre(0.0625, 1.0, 1.0));
  const std::vector<double> reference = {-1.0};
  solver.Solve({}, reference, result);
  EXPECT_THAT(result.joints, ElementsAre(-1.0, 0.5, 3.0));
  EXPECT_THAT(result.Solution(1), ElementsAre(0.5));
  EXPECT_TRUE(result.IsSolved());
}

TEST(InverseKinematics, RefusesPosesThatAreNone) {
  const FixedSolver solver(OneJoint(), {});
  InverseKinematicsResult result;
  const Pose nan{kIdentity3, {0, std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_THROWS_MESSAGE((solver.Solve(nan, {}, result), 0), Error, HasSubstr("not finite"));
  EXPECT_THROWS_MESSAGE((solver.Solve({Matrix3{}, {}}, {}, result), 0),
                        Error,
                        HasSubstr("the pose's rotation is none"));
}

TEST(InverseKinematics, RefusesAReferenceOutsideTheLimits) {
  const FixedSolver solver(OneJoint(), {});
  InverseKinematicsResult result;
  EXPECT_THROWS_MESSAGE(
      (solver.Solve({}, std::vector<double>{4.0}, result), 0), Error, HasSubstr("joint a is 4"));
  EXPECT_THROWS_MESSAGE((solver.Solve({}, std::vector<double>{0, 0}, result), 0),
                        Error,
                        HasSubstr("2 joint values given"));
}

TEST(InverseKinematicsOptions, NameFieldValueAndRule) {
  const auto refuse = [](const InverseKinematicsOptions& options, const char* message) {
    EXPECT_THROWS_MESSAGE((options.Validate(), 0), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(InverseKinematicsOptions().Validate());
  refuse({.free_joint_step_rad = 0},
         "InverseKinematicsOptions.free_joint_step_rad is 0; it must be from 0.001 to 1");
  refuse({.free_joint_step_rad = std::numeric_limits<double>::quiet_NaN()},
         "free_joint_step_rad is nan");
  refuse({.max_starts = 0}, "max_starts is 0");
  refuse({.max_solutions = 0}, "max_solutions is 0");
  refuse({.position_tolerance_m = 1}, "position_tolerance_m is 1");
  refuse({.rotation_tolerance_rad = 0}, "rotation_tolerance_rad is 0");
}

}  // namespace
}  // namespace handcraft::robot
