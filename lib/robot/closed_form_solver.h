// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "lib/features/instruction_set.h"
#include "lib/robot/inverse_kinematics.h"
#include "lib/robot/spherical_arm.h"

namespace handcraft::robot {

namespace internal {
struct SweepJob;
}

/// Inverse kinematics of 7-joint arms with spherical shoulder and wrist, in closed form.
///
/// Joint 3 is sampled from its lower limit by options.free_joint_step_rad (dissertation, section
/// 6.4.1: 4 degrees). The distance from shoulder to wrist gives two q₄, the wrist's place two
/// (q₁, q₂), its rotation two (q₅, q₆, q₇): up to eight solutions a sample. Those within the limits
/// are returned, each exact to rounding.
///
/// Some poses are reached only between two samples (the room between limits is narrow, or the
/// shoulder is singular). When no sample solves one, 16 times as many are tried, those that the
/// reach itself gives (reach_samples.h), and last the nearest of all without limits, moved within
/// them (nearest_attempt.h); what is left over is the best attempt.
class ClosedFormSolver : public InverseKinematics {
 public:
  /// Throws Error(kUsage) when the chain has no such closed form, saying why, and for options that
  /// break their rules.
  explicit ClosedFormSolver(
      const SerialChain& chain,
      const InverseKinematicsOptions& options = {},
      features::InstructionSet set = features::SupportedInstructionSets().back());

  [[nodiscard]] std::string_view Method() const noexcept override { return "closed form"; }

 protected:
  void SolveSound(const Pose& base_from_tip,
                  std::span<const double> reference,
                  InverseKinematicsResult& result) const override;
  void FindSound(const Pose& base_from_tip,
                 std::span<const double> reference,
                 InverseKinematicsResult& result) const override;

 private:
  // Values of joint 3 with their cosines and sines, and numbers that a vector may touch after them.
  struct Samples {
    std::vector<double> angles_rad = {};
    std::vector<double> cosines = {};
    std::vector<double> sines = {};
    [[nodiscard]] std::size_t size() const noexcept;
  };
  // What a pose asks of the arm.
  struct Goal {
    Vector3 wrist_in_first;
    Vector3 x_in_first;
    Vector3 z_in_first;
  };
  enum class Limits : std::uint8_t { kKept, kIgnored };

  [[nodiscard]] static Samples MakeSamples(std::vector<double> angles_rad);
  [[nodiscard]] std::vector<double> GridOf(double step_rad) const;
  [[nodiscard]] Goal GoalOf(const Pose& base_from_tip) const noexcept;
  [[nodiscard]] std::array<double, 2> ElbowsFor(const Goal& goal) const noexcept;
  [[nodiscard]] Matrix3 ElbowRotation(double q4) const noexcept;
  [[nodiscard]] Vector3 WristInThird(const Matrix3& elbow) const noexcept;
  void SetElbow(double q4, double reference, internal::SweepJob& job) const;
  void Sweep(const Goal& goal,
             const Samples& samples,
             std::span<const double> reference,
             Limits limits,
             InverseKinematicsResult& result) const;
  static void TakeSorted(std::size_t count, InverseKinematicsResult& result);
  [[nodiscard]] Samples FineSamples(const Goal& goal) const;
  void KeepExact(const Pose& base_from_tip,
                 std::span<const double> reference,
                 InverseKinematicsResult& result) const;
  void Approach(const Pose& base_from_tip,
                const Goal& goal,
                std::span<const double> reference,
                InverseKinematicsResult& result) const;
  [[nodiscard]] Goal WithinReach(const Goal& goal) const noexcept;

  SphericalArm arm_;
  features::InstructionSet set_;
  Samples samples_;
};

}  // namespace handcraft::robot
