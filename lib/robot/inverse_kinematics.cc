// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::robot {

void InverseKinematicsOptions::Validate() const {
  const auto require = [](bool holds, const char* field, auto value, const char* rule) {
    RequireOption(holds, std::string("InverseKinematicsOptions.") + field, value, rule);
  };
  require(free_joint_step_rad >= 1e-3 && free_joint_step_rad <= 1.0,
          "free_joint_step_rad",
          free_joint_step_rad,
          "from 0.001 to 1");
  require(max_starts >= 1 && max_starts <= 10000, "max_starts", max_starts, "from 1 to 10000");
  require(max_solutions >= 1 && max_solutions <= 10000,
          "max_solutions",
          max_solutions,
          "from 1 to 10000");
  require(position_tolerance_m >= 1e-12 && position_tolerance_m <= 0.1,
          "position_tolerance_m",
          position_tolerance_m,
          "from 1e-12 to 0.1");
  require(rotation_tolerance_rad >= 1e-12 && rotation_tolerance_rad <= 0.1,
          "rotation_tolerance_rad",
          rotation_tolerance_rad,
          "from 1e-12 to 0.1");
}

InverseKinematics::InverseKinematics(SerialChain chain, const InverseKinematicsOptions& options)
    : chain_(std::move(chain)), options_(options), middle_(chain_.Middle()) {
  options_.Validate();
}

Pose InverseKinematics::Prepare(const Pose& base_from_tip,
                                std::span<const double> reference,
                                InverseKinematicsResult& result) const {
  if (const std::string fault = FaultOf(base_from_tip); !fault.empty()) {
    throw Error({.reason = fault, .remedy = "give a finite position and a rotation"});
  }
  if (!reference.empty()) chain_.RequireWithinLimits(reference);
  result.joints.clear();
  result.costs.clear();
  return {Orthonormalised(base_from_tip.rotation), base_from_tip.translation_m};
}

std::span<const double> InverseKinematics::OrMiddle(
    std::span<const double> reference) const noexcept {
  return reference.empty() ? std::span<const double>(middle_) : reference;
}

void InverseKinematics::Solve(const Pose& base_from_tip,
                              std::span<const double> reference,
                              InverseKinematicsResult& result) const {
  SolveSound(Prepare(base_from_tip, reference, result), OrMiddle(reference), result);
}

void InverseKinematics::FindSolutions(const Pose& base_from_tip,
                                      std::span<const double> reference,
                                      InverseKinematicsResult& result) const {
  FindSound(Prepare(base_from_tip, reference, result), OrMiddle(reference), result);
  if (!result.IsSolved()) result.best = {};
}

void InverseKinematics::FindSound(const Pose& base_from_tip,
                                  std::span<const double> reference,
                                  InverseKinematicsResult& result) const {
  SolveSound(base_from_tip, reference, result);
}

void InverseKinematics::TakeFirstAsBest(const Pose& base_from_tip,
                                        InverseKinematicsResult& result) const {
  if (!result.IsSolved()) return;
  const std::span<const double> first = result.Solution(0);
  result.best.joints.assign(first.begin(), first.end());
  result.best.error = ErrorBetween(ForwardKinematics(chain_, first), base_from_tip);
}

double InverseKinematics::Cost(std::span<const double> joints,
                               std::span<const double> reference) const noexcept {
  double sum = 0.0;
  for (std::size_t j = 0; j < chain_.size(); ++j) {
    const double half = 0.5 * (chain_.joints[j].upper - chain_.joints[j].lower);
    const double share = (joints[j] - reference[j]) / half;
    sum += share * share;
  }
  return sum / static_cast<double>(chain_.size());
}

bool InverseKinematics::IsWithinTolerance(const PoseError& error) const noexcept {
  return error.position_m <= options_.position_tolerance_m &&
         error.rotation_rad <= options_.rotation_tolerance_rad;
}

void InverseKinematics::AddSolution(std::span<const double> joints,
                                    std::span<const double> reference,
                                    InverseKinematicsResult& result) const {
  constexpr double kSame = 1e-4;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::span<const double> other = result.Solution(i);
    const bool is_same =
        std::equal(joints.begin(), joints.end(), other.begin(), [](double a, double b) {
          return std::abs(a - b) < kSame;
        });
    if (is_same) return;
  }
  result.joints.insert(result.joints.end(), joints.begin(), joints.end());
  result.costs.push_back(Cost(joints, reference));
}

void InverseKinematics::SortSolutions(InverseKinematicsResult& result) {
  if (result.costs.empty()) return;
  std::vector<std::size_t> order(result.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result.costs[a] < result.costs[b];
  });
  InverseKinematicsResult sorted;
  for (const std::size_t i : order) {
    const std::span<const double> joints = result.Solution(i);
    sorted.joints.insert(sorted.joints.end(), joints.begin(), joints.end());
    sorted.costs.push_back(result.costs[i]);
  }
  result.joints.swap(sorted.joints);
  result.costs.swap(sorted.costs);
}

}  // namespace handcraft::robot
