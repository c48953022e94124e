// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/kdl_solver.h"

#include <algorithm>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <limits>
#include <numbers>

#include "lib/core/rng.h"
#include "lib/robot/nearest_attempt.h"

namespace handcraft::robot {
namespace {

constexpr unsigned int kMaxIterations = 500;

KDL::Vector ToKdl(const Vector3& v) { return {v[0], v[1], v[2]}; }

KDL::Frame ToKdl(const Pose& pose) {
  const Matrix3& r = pose.rotation;
  return {KDL::Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
          ToKdl(pose.translation_m)};
}

KDL::JntArray ToKdl(std::span<const double> joints) {
  KDL::JntArray array(static_cast<unsigned int>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) array(static_cast<unsigned int>(j)) = joints[j];
  return array;
}

// By whole turns nearest to the middle of the limits, then within them.
void BringWithinLimits(const SerialChain& chain, std::span<double> joints) {
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const Joint& joint = chain.joints[j];
    if (joint.type == JointType::kRevolute) {
      joints[j] =
          joint.Middle() + std::remainder(joints[j] - joint.Middle(), 2.0 * std::numbers::pi);
    }
    joints[j] = std::clamp(joints[j], joint.lower, joint.upper);
  }
}

}  // namespace

struct KdlSolver::Chain {
  KDL::Chain segments;
  KDL::JntArray lower;
  KDL::JntArray upper;
};

// KDL moves a segment's joint first and then goes along its frame: a segment's joint stands where
// the frames before it end.
KdlSolver::KdlSolver(const SerialChain& chain, const InverseKinematicsOptions& options)
    : InverseKinematics(chain, options) {
  auto kdl = std::make_unique<Chain>();
  const auto fixed = [](const Pose& pose) {
    return KDL::Segment(KDL::Joint(KDL::Joint::None), ToKdl(pose));
  };
  std::vector<double> lower;
  std::vector<double> upper;
  for (const Joint& joint : chain.joints) {
    const bool is_revolute = joint.type == JointType::kRevolute;
    kdl->segments.addSegment(fixed(joint.parent_from_joint));
    kdl->segments.addSegment(
        KDL::Segment(KDL::Joint(KDL::Vector::Zero(),
                                ToKdl(joint.axis),
                                is_revolute ? KDL::Joint::RotAxis : KDL::Joint::TransAxis)));
    lower.push_back(joint.lower);
    upper.push_back(joint.upper);
  }
  kdl->segments.addSegment(fixed(chain.last_from_tip));
  kdl->lower = ToKdl(lower);
  kdl->upper = ToKdl(upper);
  kdl_ = std::move(kdl);
}

KdlSolver::~KdlSolver() = default;

std::optional<std::vector<double>> KdlSolver::SolveOnce(KdlMethod method,
                                                        const Pose& base_from_tip,
                                                        std::span<const double> start) const {
  KDL::JntArray solution(kdl_->segments.getNrOfJoints());
  const KDL::JntArray first = ToKdl(start);
  const KDL::Frame goal = ToKdl(base_from_tip);
  const double tolerance =
      std::min(options().position_tolerance_m, options().rotation_tolerance_rad);
  int status = 0;
  if (method == KdlMethod::kLevenbergMarquardt) {
    Eigen::Matrix<double, 6, 1> weights;
    weights << 1, 1, 1, kRotationLength_m, kRotationLength_m, kRotationLength_m;
    KDL::ChainIkSolverPos_LMA solver(
        kdl_->segments, weights, tolerance * kRotationLength_m, kMaxIterations);
    status = solver.CartToJnt(first, goal, solution);
  } else {
    KDL::ChainFkSolverPos_recursive forward(kdl_->segments);
    KDL::ChainIkSolverVel_pinv velocity(kdl_->segments);
    KDL::ChainIkSolverPos_NR_JL solver(
        kdl_->segments, kdl_->lower, kdl_->upper, forward, velocity, kMaxIterations, tolerance);
    status = solver.CartToJnt(first, goal, solution);
  }
  if (status < 0) return std::nullopt;
  return std::vector<double>(solution.data.data(), solution.data.data() + solution.data.size());
}

void KdlSolver::SolveSound(const Pose& base_from_tip,
                           std::span<const double> reference,
                           InverseKinematicsResult& result) const {
  Rng rng = Rng::Stream(options().seed, "inverse_kinematics_starts");
  std::vector<double> start(reference.begin(), reference.end());
  result.best = {.error = {std::numeric_limits<double>::infinity(), std::numbers::pi}};
  for (int i = 0; i < options().max_starts &&
                  result.size() < static_cast<std::size_t>(options().max_solutions);
       ++i) {
    std::vector<double> joints =
        SolveOnce(KdlMethod::kLevenbergMarquardt, base_from_tip, start).value_or(start);
    BringWithinLimits(chain(), joints);
    const PoseError error = MoveToNearest(chain(), base_from_tip, joints);
    if (IsWithinTolerance(error)) AddSolution(joints, reference, result);
    if (SquaredError(error) < SquaredError(result.best.error)) {
      result.best = {.joints = joints, .error = error};
    }
    for (std::size_t j = 0; j < start.size(); ++j) {
      const Joint& joint = chain().joints[j];
      start[j] = joint.lower + rng.Uniform() * (joint.upper - joint.lower);
    }
  }
  SortSolutions(result);
  TakeFirstAsBest(base_from_tip, result);
}

}  // namespace handcraft::robot
