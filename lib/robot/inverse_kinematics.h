// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lib/robot/serial_chain.h"

namespace handcraft::robot {

/// How inverse kinematics is done.
struct InverseKinematicsOptions {
  /// Closed form: step of the free joint's samples [rad]; 0.001 ... 1. The dissertation's 4
  /// degrees.
  double free_joint_step_rad = 0.06981317007977318;
  /// Starts of the iterative solver: the reference, then joint values drawn within the limits;
  /// 1 ... 10000.
  int max_starts = 64;
  /// Solutions after which the iterative solver stops; 1 ... 10000.
  int max_solutions = 8;
  /// What counts as solved: 1e-12 ... 0.1, [m] and [rad].
  double position_tolerance_m = 1e-9;
  double rotation_tolerance_rad = 1e-9;
  std::uint64_t seed = 1;  ///< of the iterative solver's starts

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class V>
  void VisitFields(V&& v) const {
    v("free_joint_step_rad", free_joint_step_rad);
    v("max_starts", max_starts);
    v("max_solutions", max_solutions);
    v("position_tolerance_m", position_tolerance_m);
    v("rotation_tolerance_rad", rotation_tolerance_rad);
    v("seed", seed);
  }
};

/// Joint values and how far they are from what was asked for.
struct Attempt {
  std::vector<double> joints = {};
  PoseError error = {};
};

/// What was found. Reuse one object: its memory is kept, and after the first calls a closed form
/// allocates no more.
struct InverseKinematicsResult {
  /// Solutions within the limits, row-major size() × number of joints, least cost first.
  std::vector<double> joints;
  /// C(q) = 1/n Σ_j ((q_j − r_j) / h_j)², r the reference, h_j half of joint j's range.
  std::vector<double> costs;
  /// The first solution, or, when there is none, the nearest attempt within the limits: the least
  /// position² + (0.1 m · rotation/rad)² that was found.
  Attempt best;
  std::vector<double> scratch;       ///< the solver's
  std::vector<std::uint32_t> order;  ///< the solver's
  std::vector<std::uint64_t> keys;   ///< the solver's

  [[nodiscard]] bool IsSolved() const noexcept { return !costs.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return costs.size(); }
  [[nodiscard]] std::span<const double> Solution(std::size_t i) const noexcept {
    const std::size_t n = joints.size() / costs.size();
    return {joints.data() + i * n, n};
  }
};

/// Joint values that bring a chain's tip to a pose. Thread-safe, each thread with a result of its
/// own; the same call gives the same result.
class InverseKinematics {
 public:
  virtual ~InverseKinematics() = default;
  InverseKinematics(const InverseKinematics&) = delete;
  InverseKinematics& operator=(const InverseKinematics&) = delete;

  /// `reference`: the joint values that solutions are to be near, as many as joints; empty: the
  /// middle of the limits. A rotation that is one but for rounding is made one, and errors are told
  /// against that. An unreachable pose is a result without solutions. Throws
  /// Error(kBadInput) for a pose that is none (FaultOf), Error(kUsage) for a reference outside the
  /// limits or of another length.
  void Solve(const Pose& base_from_tip,
             std::span<const double> reference,
             InverseKinematicsResult& result) const;

  /// Solve for one of several poses that would do: the nearest attempt, which takes hundreds of
  /// times as long, is not looked for, nor are the rare solutions that only its search finds.
  /// Without a solution `best` has no joints.
  void FindSolutions(const Pose& base_from_tip,
                     std::span<const double> reference,
                     InverseKinematicsResult& result) const;

  [[nodiscard]] virtual std::string_view Method() const noexcept = 0;
  [[nodiscard]] const SerialChain& chain() const noexcept { return chain_; }
  [[nodiscard]] const InverseKinematicsOptions& options() const noexcept { return options_; }

 protected:
  InverseKinematics(SerialChain chain, const InverseKinematicsOptions& options);

  /// Fills joints, costs and best of a result that is empty; pose and reference are sound.
  virtual void SolveSound(const Pose& base_from_tip,
                          std::span<const double> reference,
                          InverseKinematicsResult& result) const = 0;
  /// The same without the nearest attempt: best is empty when joints are. By default SolveSound.
  virtual void FindSound(const Pose& base_from_tip,
                         std::span<const double> reference,
                         InverseKinematicsResult& result) const;
  /// best is the first solution, if there is one.
  void TakeFirstAsBest(const Pose& base_from_tip, InverseKinematicsResult& result) const;

  [[nodiscard]] double Cost(std::span<const double> joints,
                            std::span<const double> reference) const noexcept;
  [[nodiscard]] bool IsWithinTolerance(const PoseError& error) const noexcept;
  /// Adds a solution unless one of those there is has all joints within 1e-4 of it.
  void AddSolution(std::span<const double> joints,
                   std::span<const double> reference,
                   InverseKinematicsResult& result) const;
  /// Orders the solutions by cost; equal ones as they are.
  static void SortSolutions(InverseKinematicsResult& result);

 private:
  // Throws as Solve does, else empties the result and returns the pose with a sound rotation.
  [[nodiscard]] Pose Prepare(const Pose& base_from_tip,
                             std::span<const double> reference,
                             InverseKinematicsResult& result) const;
  [[nodiscard]] std::span<const double> OrMiddle(std::span<const double> reference) const noexcept;

  SerialChain chain_;
  InverseKinematicsOptions options_;
  std::vector<double> middle_;
};

/// The closed form where the chain has one, else Orocos KDL's iterations. Throws Error(kUsage) for
/// options that break their rules.
[[nodiscard]] std::unique_ptr<InverseKinematics> MakeInverseKinematics(
    const SerialChain& chain, const InverseKinematicsOptions& options = {});

}  // namespace handcraft::robot
