// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "lib/features/instruction_set.h"
#include "lib/robot/spherical_arm.h"

namespace handcraft::robot::internal {

/// Numbers of an array that a vector may touch past the last one it was asked for.
inline constexpr std::size_t kSweepSlack = 16;
/// Solutions that one sample can have for one elbow: shoulder and wrist both have two.
inline constexpr std::size_t kSolutionsPerSample = 4;
/// Numbers of a solution: seven joints and the cost.
inline constexpr std::size_t kSolutionSize = 8;

/// Limits of a joint and what its cost is measured with.
struct SweepLimit {
  double middle = 0.0;
  double half = 0.0;  ///< infinity: no limits
  double reference = 0.0;
  double inverse_half_range = 0.0;  ///< of the cost
};

/// One elbow angle, all samples of joint 3.
struct SweepJob {
  const SphericalArm* arm = nullptr;
  std::array<SweepLimit, 7> limits = {};
  const double* free_rad = nullptr;  ///< count values of q₃, and kSweepSlack readable numbers
  const double* cosines = nullptr;   ///< of them
  const double* sines = nullptr;
  std::size_t count = 0;
  /// Shoulder to wrist, in the shoulder's third frame, with this elbow.
  Vector3 wrist_in_third = {};
  /// Where that is to go, and columns x and z of the wrist's third frame as they are to be, in the
  /// shoulder's first frame.
  Vector3 wrist_in_first = {};
  Vector3 goal_x_in_first = {};
  Vector3 goal_z_in_first = {};
  /// The wrist's first frame from the shoulder's third frame, with this elbow.
  Matrix3 fifth_from_third = {};
  double elbow_rad = 0.0;   ///< q₄
  double elbow_cost = 0.0;  ///< of q₄
  /// Where solutions go, q₁ ... q₇ and the cost of each; room for kSolutionsPerSample · count.
  double* solutions = nullptr;
};

/// The sweep and its parts, compiled once for each instruction set. Nothing here allocates.
struct SweepKernels {
  /// Writes the solutions within the limits and returns how many there are.
  ///
  /// With w = wrist_in_first and v = Rz(θ₃) wrist_in_third, in vectors of several θ₃ at once:
  ///   u = Rx(α₂₃) v;  k = (w_z − cos α₁₂ · u_z) / sin α₁₂;  s₂ u_x + c₂ u_y = k gives two θ₂ where
  ///   u_x² + u_y² ≥ k²;  θ₁ turns Rx(α₁₂) Rz(θ₂) u onto w;  the rest of the wanted rotation gives
  ///   two (θ₅, θ₆, θ₇).
  /// A singular shoulder (w along axis 1) takes joint 1 from the reference, a singular wrist
  /// joint 5.
  std::size_t (*sweep)(const SweepJob& job);
  /// atan2 of count numbers, as the sweep computes it, within 1e-15; arrays have kSweepSlack more.
  void (*atan2)(const double* y, const double* x, double* angle, std::size_t count);
};

/// The version for an instruction set. Those with fused multiply-add give the same bits.
[[nodiscard]] const SweepKernels& SweepFor(features::InstructionSet set) noexcept;

}  // namespace handcraft::robot::internal
