// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/inverse_kinematics_benchmark.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "lib/core/rng.h"
#include "lib/features/instruction_set.h"
#include "lib/robot/closed_form_solver.h"
#include "lib/robot/kdl_solver.h"

namespace handcraft::experiments {
namespace {

constexpr double kMatlabMs = 20.0;  // Table 4.5

// A WAM of seven joints (Barrett's manual D1001); models/robots has the same, twice.
robot::SerialChain Wam() {
  struct Row {
    double a_m, alpha_rad, d_m, lower_rad, upper_rad;
  };
  constexpr double kHalf = std::numbers::pi / 2;
  constexpr std::array<Row, 7> kRows = {{{0, -kHalf, 0, -2.6, 2.6},
                                         {0, kHalf, 0, -2.0, 2.0},
                                         {0.045, -kHalf, 0.55, -2.8, 2.8},
                                         {-0.045, kHalf, 0, -0.9, 3.1},
                                         {0, -kHalf, 0.3, -4.76, 1.24},
                                         {0, kHalf, 0, -1.6, 1.6},
                                         {0, 0, 0.06, -3.0, 3.0}}};
  robot::SerialChain chain{.base = "base", .tip = "tool"};
  robot::Pose before = {robot::kIdentity3, {0, 0, 0.346}};
  for (const Row& row : kRows) {
    chain.joints.push_back({.name = "j" + std::to_string(chain.size() + 1),
                            .parent_from_joint = before,
                            .lower = row.lower_rad,
                            .upper = row.upper_rad});
    before = {robot::AxisRotation({1, 0, 0}, row.alpha_rad), {row.a_m, 0, row.d_m}};
  }
  chain.last_from_tip = before;
  return chain;
}

std::vector<robot::Pose> DrawPoses(const robot::SerialChain& chain, std::size_t count) {
  std::vector<robot::Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    Rng rng = Rng::Stream(1, "inverse_kinematics_benchmark", i);
    std::vector<double> joints;
    for (const robot::Joint& joint : chain.joints) {
      joints.push_back(joint.lower + rng.Uniform() * (joint.upper - joint.lower));
    }
    poses.push_back(robot::ForwardKinematics(chain, joints));
  }
  return poses;
}

// Processor time a pose [µs].
double MicrosecondsEach(std::span<const robot::Pose> poses,
                        const std::function<void(const robot::Pose&)>& call) {
  const std::clock_t start = std::clock();
  for (const robot::Pose& pose : poses) call(pose);
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
         static_cast<double>(poses.size());
}

double Share(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

void MeasureOurs(const robot::SerialChain& chain,
                 std::span<const robot::Pose> poses,
                 BenchmarkResult& result) {
  const robot::ClosedFormSolver solver(chain);
  robot::InverseKinematicsResult found;
  result.ours_ms =
      1e-3 * MicrosecondsEach(poses, [&](const auto& pose) { solver.Solve(pose, {}, found); });
  std::size_t num_solved = 0;
  std::size_t num_solutions = 0;
  double slowest_us = 0.0;
  robot::PoseError largest;
  for (const robot::Pose& pose : poses) {
    const double microseconds =
        MicrosecondsEach({&pose, 1}, [&](const auto& one) { solver.Solve(one, {}, found); });
    slowest_us = std::max(slowest_us, microseconds);
    num_solved += found.IsSolved() ? 1 : 0;
    num_solutions += found.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const robot::PoseError error =
          ErrorBetween(robot::ForwardKinematics(chain, found.Solution(i)), pose);
      largest.position_m = std::max(largest.position_m, error.position_m);
      largest.rotation_rad = std::max(largest.rotation_rad, error.rotation_rad);
    }
  }
  result.details["ours_us"] = 1e3 * result.ours_ms;
  result.details["ours_us_slowest"] = slowest_us;
  result.details["ours_solved"] = Share(num_solved, poses.size());
  result.details["ours_solutions_a_pose"] = Share(num_solutions, poses.size());
  result.details["ours_largest_error_m"] = largest.position_m;
  result.details["ours_largest_error_rad"] = largest.rotation_rad;
}

void MeasureInstructionSets(const robot::SerialChain& chain,
                            std::span<const robot::Pose> poses,
                            BenchmarkResult& result) {
  for (const features::InstructionSet set : features::SupportedInstructionSets()) {
    const robot::ClosedFormSolver solver(chain, {}, set);
    robot::InverseKinematicsResult found;
    result.details["ours_us_" + std::string(NameOf(set))] =
        MicrosecondsEach(poses, [&](const robot::Pose& pose) { solver.Solve(pose, {}, found); });
  }
}

// One call of KDL a pose, from the middle of the limits. Returns µs a pose.
double MeasureKdl(const robot::KdlSolver& solver,
                  robot::KdlMethod method,
                  std::span<const robot::Pose> poses,
                  const std::string& name,
                  BenchmarkResult& result) {
  const std::vector<double> middle = solver.chain().Middle();
  std::size_t num_converged = 0;
  std::size_t num_solved = 0;
  const double microseconds = MicrosecondsEach(poses, [&](const robot::Pose& pose) {
    const auto joints = solver.SolveOnce(method, pose, middle);
    if (!joints) return;
    ++num_converged;
    if (solver.chain().IsWithinLimits(*joints, 1e-9)) ++num_solved;
  });
  result.details[name + "_poses"] = static_cast<double>(poses.size());
  result.details[name + "_us"] = microseconds;
  result.details[name + "_converged"] = Share(num_converged, poses.size());
  result.details[name + "_solved"] = Share(num_solved, poses.size());
  return microseconds;
}

void MeasureKdlRestarts(const robot::SerialChain& chain,
                        std::span<const robot::Pose> poses,
                        BenchmarkResult& result) {
  const robot::KdlSolver solver(chain, {.max_solutions = 1});
  robot::InverseKinematicsResult found;
  std::size_t num_solved = 0;
  result.details["kdl_restarts_us"] = MicrosecondsEach(poses, [&](const robot::Pose& pose) {
    solver.Solve(pose, {}, found);
    num_solved += found.IsSolved() ? 1 : 0;
  });
  result.details["kdl_restarts_poses"] = static_cast<double>(poses.size());
  result.details["kdl_restarts_solved"] = Share(num_solved, poses.size());
}

}  // namespace

BenchmarkResult BenchmarkInverseKinematicsOf(const InverseKinematicsBenchmarkSize& size) {
  const robot::SerialChain chain = Wam();
  const std::vector<robot::Pose> poses = DrawPoses(chain, size.num_poses);
  const auto first = [&](std::size_t count) {
    return std::span(poses).first(std::min(count, poses.size()));
  };
  BenchmarkResult result;
  result.dissertation_ms = kMatlabMs;
  result.details["num_poses"] = static_cast<double>(poses.size());
  MeasureOurs(chain, poses, result);
  MeasureInstructionSets(chain, first(size.num_slow_poses), result);
  const robot::KdlSolver solver(chain,
                                {.position_tolerance_m = 1e-6, .rotation_tolerance_rad = 1e-6});
  result.peer = "Orocos KDL, one Levenberg-Marquardt call, one solution";
  result.peer_ms = 1e-3 * MeasureKdl(solver,
                                     robot::KdlMethod::kLevenbergMarquardt,
                                     first(size.num_peer_poses),
                                     "kdl_lma",
                                     result);
  MeasureKdl(solver,
             robot::KdlMethod::kNewtonRaphsonLimits,
             first(size.num_slow_poses),
             "kdl_nr_limits",
             result);
  MeasureKdlRestarts(chain, first(size.num_peer_poses), result);
  result.ratio = result.peer_ms / result.ours_ms;
  return result;
}

BenchmarkResult BenchmarkInverseKinematics(const BenchmarkOptions& /*options*/) {
  return BenchmarkInverseKinematicsOf({});
}

}  // namespace handcraft::experiments
