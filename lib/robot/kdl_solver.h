// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "lib/robot/inverse_kinematics.h"

namespace handcraft::robot {

/// Which of Orocos KDL's iterations.
enum class KdlMethod : std::uint8_t {
  kLevenbergMarquardt,   ///< ChainIkSolverPos_LMA; knows no limits
  kNewtonRaphsonLimits,  ///< ChainIkSolverPos_NR_JL over ChainIkSolverVel_pinv, joints clamped
};

/// Inverse kinematics of any chain with Orocos KDL: Levenberg and Marquardt's iterations from the
/// reference and from joint values drawn within the limits; what they give is wrapped into the
/// limits and moved to the pose (nearest_attempt.h). Not every reachable pose is found, and not all
/// solutions. Allocates.
class KdlSolver : public InverseKinematics {
 public:
  explicit KdlSolver(const SerialChain& chain, const InverseKinematicsOptions& options = {});
  ~KdlSolver() override;

  [[nodiscard]] std::string_view Method() const noexcept override { return "Orocos KDL"; }

  /// One call of KDL's solver, as it is: what it returns when it reports success within the
  /// tolerances of the options (at most 500 iterations). The joint values may be outside the limits
  /// with kLevenbergMarquardt.
  [[nodiscard]] std::optional<std::vector<double>> SolveOnce(KdlMethod method,
                                                             const Pose& base_from_tip,
                                                             std::span<const double> start) const;

 protected:
  void SolveSound(const Pose& base_from_tip,
                  std::span<const double> reference,
                  InverseKinematicsResult& result) const override;

 private:
  struct Chain;
  std::unique_ptr<const Chain> kdl_;
};

}  // namespace handcraft::robot
